#include "projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nakajima {
namespace {

using namespace batten;

using std::numbers::pi;
constexpr int cells = 10;
constexpr int between = 15;

/// One and a half turns of a screw that comes close to the eye.
std::array<double, 3> screw(double t) { return {std::cos(t), std::sin(t), 0.35 * t}; }

enum class View { perspective, parallel };

/// The eye stands this far in front of the axis, at the height 1.2, and looks along y.
constexpr double eye = 1.8;

std::array<double, 2> seen(std::span<const double> p, View view) {
    const double depth = view == View::perspective ? p[1] + eye : eye;
    return {p[0] / depth, (p[2] - 1.2) / depth};
}

Points picture(const Points& space, View view) {
    Points result(0, 2);
    for (std::size_t i = 0; i < space.size(); ++i) {
        result.push_back(seen(space.view()[i], view));
    }
    return result;
}

Points screw_points(int steps) {
    Points points(0, 3);
    for (int i = 0; i <= steps; ++i) points.push_back(screw(3 * pi * i / steps));
    return points;
}

Densified dense(const Points& points) {
    DensifyOptions options;
    options.between = between;
    return densify(points, options);
}

Curve true_picture() {
    DensifyOptions options;  // 400 cells of degree 3: exact to 1e-7
    options.between = 0;
    return densify(picture(screw_points(400), View::perspective), options).curve;
}

double largest_distance(const Points& points, const Curve& from) {
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        largest = std::max(largest, nearest(from, points.view()[i]).distance);
    }
    return 100 * largest / extent(from);
}

double largest_gap(const Points& a, const Points& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.coordinates().size(); ++i) {
        largest = std::max(largest, std::fabs(a.coordinates()[i] - b.coordinates()[i]));
    }
    return 100 * largest / extent(a.view());
}

}  // namespace

Projection project_screw() {
    const Points space = screw_points(cells);
    const Points seen_points = picture(space, View::perspective);
    const Points space_first = picture(dense(space).points, View::perspective);
    const Densified picture_first = dense(seen_points);
    const Curve truth = true_picture();
    Projection result;
    result.space_first = largest_distance(space_first, truth);
    result.picture_first = largest_distance(picture_first.points, truth);
    result.apart_in_parallel = largest_gap(picture(dense(space).points, View::parallel),
                                           dense(picture(space, View::parallel)).points);
    result.drawing.title = "Densify in space, then project";
    result.drawing.subtitle = "A screw of 11 points in perspective, 15 new points a cell";
    result.drawing.add(CurveLayer{truth, "true picture", {Tone::grey, Dash::solid, 5.0}});
    result.drawing.add(CurveLayer{picture_first.curve, "projected, then densified",
                                  {Tone::accent, Dash::solid, 1.5}});
    result.drawing.add(PolylineLayer{{space_first}, "densified, then projected",
                                     {Tone::blue, Dash::solid, 1.5}});
    result.drawing.add(PointsLayer{seen_points, "points given"});
    return result;
}

}  // namespace nakajima
