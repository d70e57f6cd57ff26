#include "band.hpp"

#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::python {
namespace {

constexpr int most_derivatives = 15;

}  // namespace

void require_order(int order, const char* name) {
    if (order < 0 || order > most_derivatives) {
        throw Error("option.range", name, std::to_string(order),
                    "must be at least 0 and at most " + std::to_string(most_derivatives));
    }
}

void require_finite(std::span<const double> t, const char* name) {
    for (const double x : t) {
        if (!std::isfinite(x)) {
            throw Error("curve.parameter", name, format_number(x), "parameters must be finite");
        }
    }
}

std::vector<py::ssize_t> shape_of(const Array& t, std::initializer_list<int> more) {
    std::vector<py::ssize_t> shape(t.shape(), t.shape() + t.ndim());
    shape.insert(shape.end(), more.begin(), more.end());
    return shape;
}

py::tuple band_around(const Array& t, std::span<const double> values,
                      const FitCovariance* known, int nu, double percent) {
    if (!(percent > 0 && percent < 100)) {
        throw Error("option.range", "percent", format_number(percent),
                    "must be above 0 and below 100");
    }
    const FitCovariance& covariance = require_covariance(known);
    py::array_t<double> lower(shape_of(t, {})), upper(shape_of(t, {}));
    double *lo = lower.mutable_data(), *hi = upper.mutable_data();
    const double* at = t.data();
    {
        const py::gil_scoped_release free;
        const double factor = covariance.factor(percent);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double half = factor * covariance.deviation(at[i], nu);
            if (!std::isfinite(values[i] - half) || !std::isfinite(values[i] + half)) {
                throw Error("number.overflow", "band", format_number(half),
                            "is beyond the range of a double");
            }
            lo[i] = values[i] - half;
            hi[i] = values[i] + half;
        }
    }
    return py::make_tuple(lower, upper);
}

}  // namespace batten::python
