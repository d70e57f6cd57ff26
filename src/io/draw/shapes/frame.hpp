#pragma once

#include <array>
#include <span>

#include "batten/base/interval.hpp"
#include "batten/base/points.hpp"
#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// The box around everything a panel shows, in 2 or 3 coordinates.
struct Box {
    int dim = 0;  ///< 0 while empty
    std::array<Interval, 3> sides{};

    void add(std::span<const double> point);
    void add(PointsView points);
    void add(const Box& other);
    double middle(int k) const;
    double half(int k) const;
    /// Half of the longest side, made positive: a box that is one point is given
    /// a tenth of its distance from the origin, or 1 at the origin; no box less than 64 ulps.
    double reach() const;

private:
    const Interval& side(int k) const { return sides[static_cast<std::size_t>(k)]; }
};

/// How data become pixels: coordinate k, on its axis' scale, moves along `steps[k]` by one step
/// for each `halves[k]` from `middle[k]`.
struct Frame {
    int dim = 2;
    Rect area;  ///< where the panel is drawn
    Pixel origin;
    std::array<double, 3> middle{};
    std::array<double, 3> halves{1, 1, 1};
    std::array<Pixel, 3> steps{};
    std::array<bool, 3> is_log{};

    Pixel at(std::span<const double> point) const;
    /// How far it is from the middle along each axis as it is seen, in pixels before foreshortening.
    std::array<double, 3> along_axes(const std::array<double, 3>& point) const;
    /// The direction in the picture, of length 1; zero where there is none.
    Pixel along(std::span<const double> direction) const;
    /// Where value `x` of coordinate `k` lies, already on the axis' scale, others in the middle.
    Pixel on_axis(int k, double x) const;
    /// What the area shows of coordinate k, on the axis' scale. In the plane only.
    Interval shown(int k) const;
    /// Units of coordinate k, on the axis' scale, that one pixel is.
    double units_per_pixel(int k) const;
};

/// Equal units on both axes, the box in the middle of the area.
Frame plane_frame(const Box& box, Rect area, double padding);

/// One pixel along x or y of an isometric view, right and down: cos 30 and sin 30 degrees.
inline constexpr double isometric_x = 0.8660254037844386;
inline constexpr double isometric_y = 0.5;

/// Isometric view from above the front right: x to the right and down, y to the right and up, z
/// up. `box` as `roomy` gives it.
Frame space_frame(const Box& box, Rect area, double padding);

/// A box in space with some air around, never flat.
Box roomy(const Box& box);

/// The box fills the area. On logarithmic axes the box is that of the logarithms.
Frame chart_frame(const Box& box, Rect area, std::array<bool, 3> is_log);

/// Height over width of what `box` needs in a geometry panel.
double aspect(const Box& box);

}  // namespace batten::drawing
