#pragma once

#include <string>

#include "batten/make/interpolate.hpp"
#include "batten/measure/arc_length_map.hpp"
#include "shared.hpp"

/// The test curve of the motion references: `figure8_points20.csv`, natural-chord, part 0 to 18.
namespace batten::testing {

inline Points xy_of(const CsvTable& table) {
    Points points(table.rows.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points(i, 0) = std::stod(table.rows[i][0]);
        points(i, 1) = std::stod(table.rows[i][1]);
    }
    return points;
}

/// The 19 points of the figure itself: the last of the 20 is the one beyond the end.
inline Points figure_8_points() {
    const Points all = xy_of(shared_csv("reference/sampling/figure8_points20.csv"));
    return Points(all.view().part(0, all.size() - 1));
}

inline Curve figure_8() {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    options.part = IndexRange{0, 18};
    return curve_through(xy_of(shared_csv("reference/sampling/figure8_points20.csv")), options);
}

}  // namespace batten::testing
