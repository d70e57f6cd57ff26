#pragma once

/// Batten: fair curves and surfaces from points, and how good they are. The table of contents.

// Numbers, points, and what can go wrong.
#include "batten/base/error.hpp"
#include "batten/base/fields.hpp"
#include "batten/base/grid.hpp"
#include "batten/base/interval.hpp"
#include "batten/base/points.hpp"
#include "batten/base/progress.hpp"
#include "batten/base/shared.hpp"
#include "batten/base/text.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/base/value.hpp"

// Shapes.
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/basis.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/coons.hpp"
#include "batten/shape/cubic_evaluator.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/curved_knot_surface.hpp"
#include "batten/shape/jet.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/spline_surface.hpp"
#include "batten/shape/surface.hpp"
#include "batten/shape/transform.hpp"

// What a curve measures, and how far it is from something.
#include "batten/measure/arc_length_map.hpp"
#include "batten/measure/area.hpp"
#include "batten/measure/centroid.hpp"
#include "batten/measure/compare.hpp"
#include "batten/measure/continuity.hpp"
#include "batten/measure/contours.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/measure/curvature_graph.hpp"
#include "batten/measure/deviation.hpp"
#include "batten/measure/energy.hpp"
#include "batten/measure/graph_bend.hpp"
#include "batten/measure/length.hpp"
#include "batten/measure/level_lines.hpp"
#include "batten/measure/line.hpp"
#include "batten/measure/measure.hpp"
#include "batten/measure/measured.hpp"
#include "batten/measure/nearest.hpp"
#include "batten/measure/surface.hpp"
#include "batten/measure/surface_measures.hpp"

// Make: interpolate.
#include "batten/make/implicit_cubic.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/make/natural_spline.hpp"
#include "batten/make/pseudo_segment.hpp"
#include "batten/make/pseudo_spline.hpp"

// Make: points along a curve, denser and fewer points, arcs.
#include "batten/make/arcs.hpp"
#include "batten/make/convert.hpp"
#include "batten/make/densify.hpp"
#include "batten/make/motion.hpp"
#include "batten/make/motion_law.hpp"
#include "batten/make/sample.hpp"
#include "batten/make/thin.hpp"

// Make: fair.
#include "batten/make/alpha.hpp"
#include "batten/make/fair.hpp"
#include "batten/make/fair_surface.hpp"
#include "batten/make/log_aesthetic.hpp"

// Make: fit.
#include "batten/make/fit.hpp"
#include "batten/make/fit_chunks.hpp"
#include "batten/make/fit_curve.hpp"
#include "batten/make/fit_front.hpp"
#include "batten/make/fit_scattered.hpp"
#include "batten/make/fit_statistics.hpp"
#include "batten/make/fit_surface.hpp"

// Reading, writing, drawing.
#include "batten/io/curve_file.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/io/draw/layers.hpp"
#include "batten/io/draw/styles.hpp"
#include "batten/io/draw/surface_layers.hpp"
#include "batten/io/draw/surface_plots.hpp"
#include "batten/io/dxf.hpp"
#include "batten/io/files.hpp"
#include "batten/io/gcode.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/point_grid.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/svg_arcs.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"

// Every operation as a row of one table: what the faces are made from.
#include "batten/api/argument.hpp"
#include "batten/api/job.hpp"
#include "batten/api/operation.hpp"
