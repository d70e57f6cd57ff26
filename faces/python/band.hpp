#pragma once

#include <span>

#include "convert.hpp"

namespace batten::python {

/// Throws `option.range` unless a derivative's order is 0 to 15.
void require_order(int order, const char* name);

/// Throws `curve.parameter`.
void require_finite(std::span<const double> t, const char* name);

/// The shape of `t`, and more axes.
std::vector<py::ssize_t> shape_of(const Array& t, std::initializer_list<int> more);

/// Lower and upper edge around `values`, derivatives number `nu` at `t`, which hold with this
/// probability at each t by itself. Throws `option.range`, `curve.no-band` where nothing is known,
/// `number.overflow`.
py::tuple band_around(const Array& t, std::span<const double> values,
                      const FitCovariance* covariance, int nu, double percent);

}  // namespace batten::python
