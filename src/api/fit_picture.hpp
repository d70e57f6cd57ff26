#pragma once

#include <string>
#include <vector>

#include "batten/base/shared.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/make/fit.hpp"
#include "batten/make/fit_curve.hpp"

/// The pictures of a fit: data and fit, residuals, the criterion, the derivative.
namespace batten::api {

/// What was fitted, in the order it was given; sigma has one number a sample.
struct FitData {
    SharedNumbers x, y, sigma;
    std::string x_name, y_name;

    FitSamples view() const { return {x, y, sigma}; }
};

/// Charts as in the paper's figures a and b, and two more: data with their errors, the fit, its
/// 95 % band and the knots; residuals over sigma; what the stopping rule saw; the derivative.
Drawing fit_picture(const FitData& data, const Fit& fit, const FitOptions& options);

/// Points a curve was fitted to; sigma has one number a point, or none where one holds for all.
struct CurveFitData {
    SharedPoints points;
    SharedNumbers sigma;
    std::vector<std::string> names;  ///< of the coordinates
};

/// Points and curve with its knots; how far the curve passes; what the stopping rule saw.
Drawing fit_curve_picture(const CurveFitData& data, const CurveFit& fit, const FitOptions& options);

}  // namespace batten::api
