#pragma once

#include <span>
#include <string>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// The usual names of `dim` coordinates: x, y, z; beyond three x1, x2, ...
std::vector<std::string> coordinate_names(int dim);

/// Comma-separated rows under a line of names (none where `names` is empty), numbers in their
/// shortest exact form. Throws `number.overflow` for a number that is not finite.
std::string csv_points(PointsView points, const std::vector<std::string>& names);

/// `[[x, y], ...]`, one point a line. Throws as csv_points.
std::string json_points(PointsView points);

/// A NumPy array, version 1.0, type <f8, shape (rows, dim). Throws as csv_points.
std::string npy_points(PointsView points);

/// Points of a curve as rows `t,x,y[,z]`. Throws as csv_points.
std::string csv_samples(const Curve& curve, std::span<const double> parameters);

}  // namespace batten
