#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/base/interval.hpp"
#include "batten/base/points.hpp"
#include "batten/io/draw/styles.hpp"

/// Layers that show surfaces: as coloured maps in the plane, as sheets in space.
namespace batten {

/// How numbers become colours.
enum class Ramp {
    rising,     ///< from paper to deep blue
    diverging,  ///< from blue over paper to red; for numbers around 0
};

/// A mark with its text on a colour bar.
struct BarMark {
    double at = 0;
    std::string text;
};

/// Coloured cells around nodes, with their colour bar below the panel. In the plane only, and not
/// on logarithmic axes.
///
/// Borders of cells are halfway between nodes, those outside on the first and last node; cells
/// narrower than 4 pixels are drawn together, by the mean of their numbers. Where nodes are missing
/// the map is hatched, and the legend says what that is. 17 classes of colour, so that neighbours can be told apart.
struct MapLayer {
    std::vector<double> x, y;  ///< places of the nodes, rising, at least two each
    Grid values{0, 0};         ///< x.size() x y.size() numbers
    std::string bar = {};      ///< what the colour bar is of
    Ramp ramp = Ramp::rising;
    /// What the colours span; numbers outside take the colours of the ends. Without it that of the
    /// numbers, made symmetric about 0 on a diverging ramp.
    std::optional<Interval> range = {};
    /// Beside both ends of the range; left out where their texts would cross.
    std::vector<BarMark> marks = {};
    std::string missing = "missing";  ///< the legend's name for where nodes are missing
};

/// Dots coloured by their numbers, with the colour bar of a map. In the plane only.
///
/// Those nearer to one another than 4 pixels are drawn as one, by the mean of their numbers; the
/// ends of the colours lie on top.
struct ColoredPointsLayer {
    Points points{0, 2};
    std::vector<double> values;  ///< one a point
    std::string bar = {};        ///< what the colour bar is of
    Ramp ramp = Ramp::rising;
    std::optional<Interval> range = {};  ///< as of a map
    std::vector<BarMark> marks = {};
};

enum class SheetStyle {
    shaded,  ///< lit from above the left
    wire,    ///< node lines; what lies behind is hidden
};

/// A line upon a sheet: each row a place in counts of nodes, so that 2.5, 7 is halfway between the
/// nodes 2, 7 and 3, 7.
struct SheetLine {
    Points places;
    LineStyle line = {};
};

/// A surface in space through nu x nv nodes of 3 coordinates, seen from above the front right; what
/// is near hides what is far. Cells with a missing corner are left out.
///
/// Exact order for heights over a rectangle (x of a node depends on its row alone, y on its
/// column); else cells are ordered by their middles, so that they should be small.
/// Cost: about 60 bytes a cell: take some 60 x 60.
struct SheetLayer {
    Grid nodes{0, 0, 3};
    std::string name = {};
    SheetStyle style = SheetStyle::shaded;
    std::vector<SheetLine> lines = {};
    Points dots{0, 3};  ///< hidden where the sheet is before them; heights over a rectangle only
    Tone tone = Tone::blue;
};

}  // namespace batten
