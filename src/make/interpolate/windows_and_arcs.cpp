#include "make/interpolate/windows_and_arcs.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "batten/base/text.hpp"
#include "batten/make/arcs.hpp"
#include "batten/make/densify.hpp"

namespace batten::interpolation {
namespace {

constexpr double rounding = 1e-9;  ///< radians: no jump that anybody can see

LagrangeParameter window_parameter(Parameter parameter) {
    switch (parameter) {
        case Parameter::uniform: return LagrangeParameter::index;
        case Parameter::chord: return LagrangeParameter::chord;
        case Parameter::centripetal: return LagrangeParameter::centripetal;
    }
    return LagrangeParameter::index;
}

}  // namespace

Built lagrange_windows(const Outline& outline, const InterpolateOptions& options, int degree) {
    DensifyOptions windows;
    const int most = static_cast<int>(std::min<std::size_t>(outline.points.size(), 1000)) - 1;
    windows.degree = std::min(degree, most);
    windows.between = 0;
    windows.closed = outline.closed;
    windows.parameter = window_parameter(options.parameter.value_or(Parameter::uniform));
    windows.parameter_values = options.parameter_values;
    const Densified made = densify(outline.points, windows);
    Built built{made.curve, Status::met, {}};
    if (windows.degree < degree) {
        built.notes.push_back("too few points for degree " + std::to_string(degree) +
                              ": one polynomial through all of them");
    }
    if (!made.report.tamed_cells.empty()) {
        built.notes.push_back("spans that strayed from their chords and were made anew: " +
                              std::to_string(made.report.tamed_cells.size()));
    }
    if (made.report.max_tangent_jump > rounding) {
        const double degrees = made.report.max_tangent_jump * 180 / std::numbers::pi;
        built.notes.push_back("the tangent jumps at the points, by up to " +
                              format_fixed(degrees, 3) + " degrees");
    }
    return built;
}

Built joined_arcs(const Outline& outline) {
    ArcsOptions chain;
    chain.method = ArcMethod::chain;
    chain.closed = outline.closed;
    if (const std::optional<double> start = outline.angle(0)) chain.start_angle = Angle{*start};
    ArcFit fit = arcs(outline.points, chain);
    return {std::move(fit.chain), fit.report.status, std::move(fit.report.notes)};
}

}  // namespace batten::interpolation
