#pragma once

#include <string>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/measure/contours.hpp"
#include "batten/shape/surface.hpp"

/// Panels of heights z over x and y: level lines, reliefs, maps. Maps keep the proportion of the
/// units of x and y where the sides differ by no more than 1:2.5; else each side has its own unit.
namespace batten {

/// Heights at the nodes of rising lines `x` and `y`; missing nodes are left out of every picture.
struct Heights {
    std::vector<double> x, y;
    Grid z{0, 0};
};

/// A surface at `count` x `count` places evenly over its domain.
Heights sampled(const Surface& surface, std::size_t count);

/// Numbers at single places, all of them finite.
struct PlacedNumbers {
    std::vector<double> x, y, values;
};

/// The knot lines of a surface: straight ones dotted, curved ones in red.
std::vector<PolylineLayer> knot_lines(const Surface& surface);

/// An empty panel for a map of `part`.
Panel map_panel(const Rectangle& part, std::string caption);

/// Level lines of heights on a grid, linear between nodes, with their levels; of more than 12 every
/// other one is numbered.
/// Throws what level_lines throws.
Panel level_plot(const Heights& heights, const std::vector<double>& levels, std::string caption);

/// Level lines of a spline, exact to 1e-4 of its domain. Throws what contours throws.
Panel level_plot(const Surface& surface, const std::vector<double>& levels,
                 std::string caption);

/// Level lines that are known, each level with its own number upon them.
void add_levels(Panel& panel, const std::vector<Contour>& lines);

struct ReliefStyle {
    std::vector<double> levels = {};  ///< of the lines upon the relief
    std::size_t most_nodes = 48;      ///< a side; of more, some are picked
    SheetStyle sheet = SheetStyle::shaded;
};

/// A view of heights in space.
Panel relief_plot(const Heights& heights, const ReliefStyle& style, std::string caption);

/// The same of a surface with curved knot lines: nodes stand along the lines, so that a front is as
/// smooth as they are.
Panel relief_plot(const CurvedKnotSurface& surface, const std::vector<double>& levels,
                  std::string caption);

/// Coloured heights with their bar.
Panel height_map(const Heights& heights, std::string caption);

/// Residuals in standard deviations, red where the data lie above, on a scale symmetric about 0
/// with one standard deviation marked. `knots` are drawn over them.
Panel residual_map(const Heights& residuals, const std::vector<PolylineLayer>& knots,
                   std::string caption);

/// The same of single points of `part`: dots under the knot lines.
Panel height_dots(const PlacedNumbers& heights, const std::vector<PolylineLayer>& knots,
                  const Rectangle& part, std::string caption);
Panel residual_dots(const PlacedNumbers& residuals, const std::vector<PolylineLayer>& knots,
                    const Rectangle& part, std::string caption);

}  // namespace batten
