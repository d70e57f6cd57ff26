#pragma once

#include "batten/io/draw/drawing.hpp"

/// The shapes and drawings that the picture tests look at.
namespace batten::testing {

/// Cubics with tangents along the chords of the neighbours, at the ends along the first and last
/// chord [InoueShibata, section 4.1, method A]; a closed curve may have a corner at its seam.
enum class Seam { open, smooth, corner };
Curve hermite_chord(PointsView points, Seam seam = Seam::open);

/// Four cubics that differ from the circle by 2.7e-4 of the radius.
Curve near_circle(double radius);
/// The exact circle, counter-clockwise, as a user's function.
Curve exact_circle(double radius);
/// One turn and a half of a rising helix.
Curve helix();
/// A drop: a half circle and two flanks, smooth at the shoulders, that meet in a corner.
Curve drop();

/// A hand-typed closed outline, the body of a guitar.
Points guitar();
/// [InoueShibata, Table 2]: points where the classical curves make needles.
Points zigzag();
Drawing points_picture();
Drawing outline_picture();
Drawing aerofoil_picture(const Points& points);
Drawing drop_picture();
Drawing circle_picture();
Drawing needle_picture();
Drawing line_picture();
Drawing ruler_picture();
Drawing comparison_picture();
Drawing convergence_picture();
Drawing curvature_picture();
Drawing helix_picture();
Drawing six_curves_picture();
Drawing small_multiples_picture();
Drawing bare_picture();
Drawing cut_picture();
/// Points of any kind, joined by a line.
Drawing joined_points(const Points& points, const std::string& title);

}  // namespace batten::testing
