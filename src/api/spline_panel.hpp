#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/make/fit_bands.hpp"
#include "batten/shape/spline_function.hpp"

/// Charts of a spline y(x) and of its derivatives.
namespace batten::api {

/// What the axes of y(x) are called.
struct AxisNames {
    std::string x = "x", y = "y";
};

/// `dy/dx`, `d²y/dx²` of the names, of x and y where these are long; the name itself for order 0.
std::string name_of_derivative(const AxisNames& names, int order);

/// An empty chart.
Panel chart(std::string caption, std::string x_label, std::string y_label);

/// The spline y(x) whose graph a curve is, jumps and all; nothing where it is a plane figure.
std::optional<SplineFunction> function_of(const Curve& curve);

/// The spline or a derivative of it as runs, one for each stretch without a jump.
std::vector<Points> traced(const SplineFunction& spline, int derivative);

/// The extent of runs in y.
Interval extent_of_runs(const std::vector<Points>& runs);

/// The band, filled.
RegionsLayer band_layer(std::span<const double> x, std::span<const double> lower,
                        std::span<const double> upper, std::string name);

/// What is shown of a band: as wide as it is in the middle of its widths, and little of where it is
/// wider; between knots that are barely determined it may be a hundred times so.
Interval covering_band(Interval covered, std::span<const double> lower,
                       std::span<const double> upper);

/// A band that is asked for, and what it is called.
struct NamedBand {
    const FitCovariance* covariance = nullptr;  ///< null: none
    double factor = 0;
    std::string name;
};

/// The spline that the legend calls `name`, with its band; its knots are marked.
Panel value_panel(const SplineFunction& spline, const AxisNames& names, const NamedBand& band,
                  std::string name);

/// A derivative of the spline that the legend calls `name`, with its band; its knots are marked.
Panel derivative_panel(const SplineFunction& spline, int order, const AxisNames& names,
                       const NamedBand& band, std::string name);

}  // namespace batten::api
