#include "make/fit/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/first_look.hpp"

namespace batten::fitting {
namespace {

void require_finite(std::span<const double> column, const char* name) {
    for (std::size_t i = 0; i < column.size(); ++i) {
        if (std::isfinite(column[i])) continue;
        throw Error("points.not-finite", "row " + std::to_string(i) + ", column " + name,
                    format_number(column[i]), "coordinates must be finite", {i});
    }
}

void require_sigma(std::span<const double> sigma) {
    for (std::size_t i = 0; i < sigma.size(); ++i) {
        if (sigma[i] > 0) continue;
        throw Error("fit.sigma", "row " + std::to_string(i) + ", column sigma",
                    format_number(sigma[i]), "errors must be above 0 (inf: no weight)", {i});
    }
}

std::vector<double> sigma_by_model(std::span<const double> y, std::span<const double> model) {
    if (model.size() != 2) {
        throw Error("fit.sigma-model", "sigma_model", std::to_string(model.size()),
                    "must be two numbers A,B: the errors are sqrt(A y + B)");
    }
    std::vector<double> sigma(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double variance = model[0] * y[i] + model[1];
        if (!(variance > 0) || !std::isfinite(variance)) {
            throw Error("fit.sigma-model", "row " + std::to_string(i), format_number(variance),
                        "A y + B must be above 0 for every y", {i});
        }
        sigma[i] = std::sqrt(variance);
    }
    return sigma;
}

/// Copies what has weight, in rising x.
void sort_and_drop(Samples& samples) {
    const std::size_t n = samples.x.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto weightless = [&](std::size_t i) { return std::isinf(samples.sigma_at(i)); };
    order.erase(std::remove_if(order.begin(), order.end(), weightless), order.end());
    const std::span<const double> x = samples.x;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    const auto picked = [&](std::span<const double> column) {
        std::vector<double> result;
        result.reserve(order.size());
        for (const std::size_t i : order) result.push_back(column[i]);
        return result;
    };
    std::vector<std::vector<double>> columns;
    columns.push_back(picked(samples.x));
    for (const auto& side : samples.sides) columns.push_back(picked(side));
    if (!samples.sigma.empty()) columns.push_back(picked(samples.sigma));
    samples.owned = std::move(columns);
    samples.x = samples.owned[0];
    for (std::size_t s = 0; s < samples.sides.size(); ++s) samples.sides[s] = samples.owned[s + 1];
    if (!samples.sigma.empty()) samples.sigma = samples.owned.back();
    if (!samples.row_of.empty()) {
        for (std::size_t& i : order) i = samples.row_of[i];
    }
    samples.row_of = std::move(order);
}

/// Checks x and y, and looks at the errors. Where x does not fall, it is finite if its ends are.
FirstLook checked(const FitSamples& given) {
    FirstLook look;
    const std::span<const double> x = given.x, y = given.y;
    if (x.empty()) return look;
    Samples plain;
    plain.x = x;
    plain.sides = {y};
    plain.sigma = given.sigma;
    look_at(plain, {0, x.size()}, look);
    const bool is_suspect = look.falls || !std::isfinite(x.front()) || !std::isfinite(x.back());
    if (is_suspect) require_finite(x, "x");
    if (!std::isfinite(look.largest)) require_finite(y, "y");
    return look;
}

void choose_sigma(Samples& samples, const FitSamples& given, const FirstLook& look,
                  const FitOptions& options) {
    if (!given.sigma.empty()) {
        samples.sigma = given.sigma;
        samples.source = SigmaSource::column;
        samples.has_weightless = !look.sigma.are_usable;
        if (samples.has_weightless) require_sigma(given.sigma);
    } else if (options.sigma) {
        if (!(*options.sigma > 0 && std::isfinite(*options.sigma))) {
            throw Error("fit.sigma", "sigma", format_number(*options.sigma),
                        "must be above 0 and finite");
        }
        samples.common_sigma = *options.sigma;
        samples.source = SigmaSource::number;
    } else if (!options.sigma_model.empty()) {
        samples.owned.push_back(sigma_by_model(given.y, options.sigma_model));
        samples.sigma = samples.owned.back();
        samples.source = SigmaSource::model;
    }
    samples.sigma_known = samples.source != SigmaSource::estimated;
}

bool has_square(double size) { return size > 0x1p-480 && size < 0x1p480; }

SigmaRange range_of(double sigma) { return {sigma, sigma}; }

/// What is wrong with the units, if anything is.
struct UnitsFault {
    const char* place;
    double value;
    const char* rule;
};

std::optional<UnitsFault> units_fault(const Samples& samples, SigmaRange range, double largest,
                                      int degree) {
    const bool is_estimated = samples.source == SigmaSource::estimated;
    if (is_estimated && largest > 0 && !has_square(largest)) {
        return UnitsFault{"column y", largest, "squares of y must lie within a double"};
    }
    for (const double sigma : {range.least, range.largest}) {
        const bool is_usable = largest == 0 || has_square(largest / sigma);
        if (is_estimated || (has_square(sigma) && is_usable)) continue;
        return UnitsFault{"sigma", sigma,
                          "squares of sigma and of y / sigma must lie within a double"};
    }
    const double length = samples.range.hi - samples.range.lo;
    if (!std::isfinite(length)) {
        return UnitsFault{"column x", length, "the range of x must lie within a double"};
    }
    // The spline's highest derivative is no larger than some 2^40 y / length^degree.
    const int slopes = largest > 0 ? std::ilogb(largest) - degree * std::ilogb(length) : 0;
    if (length < 0x1p-900 || slopes > 980) {
        return UnitsFault{
            "column x", length,
            "derivatives over so short a range are beyond a double: take larger units"};
    }
    return std::nullopt;
}

}  // namespace

void require_units(const Samples& samples, double largest, int degree) {
    SigmaRange range = range_of(samples.common_sigma);
    if (!samples.sigma.empty()) {
        const auto ends = std::minmax_element(samples.sigma.begin(), samples.sigma.end());
        range = {*ends.first, *ends.second};
    }
    const std::optional<UnitsFault> fault = units_fault(samples, range, largest, degree);
    if (!fault) return;
    throw Error("number.overflow", fault->place, format_number(fault->value), fault->rule);
}

bool has_usable_units(const Samples& samples, const FirstLook& look, int degree) {
    const SigmaRange range =
        samples.sigma.empty() ? range_of(samples.common_sigma) : look.sigma;
    return !units_fault(samples, range, look.largest, degree);
}

double noise_from_differences(std::span<const double> x, std::span<const double> y) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double width = x[i + 1] - x[i - 1];
        const double a = width > 0 ? (x[i + 1] - x[i]) / width : 0.5;
        const double b = 1 - a;
        const double e = a * y[i - 1] + b * y[i + 1] - y[i];
        sum += e * e / (a * a + b * b + 1);
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

void estimate_sigma(Samples& samples, double noise, double largest) {
    constexpr double unit = std::numeric_limits<double>::epsilon();
    constexpr double rounding = 8 * unit;  // of a spline's value, in units of the data
    samples.common_sigma = std::max(noise, unit * largest);
    if (!(samples.common_sigma > 0)) samples.common_sigma = 1;
    const double lost = rounding * largest / samples.common_sigma;
    samples.least_delta2 = static_cast<double>(samples.values()) * lost * lost;
}

namespace {

/// What the samples must have.
enum class Needed { range, nothing };

/// `domain`: what derivatives are taken over, where the samples do not say it themselves.
Samples prepared_as(Needed needed, const FitSamples& given, const FitOptions& options,
                    std::optional<Interval> domain = {}) {
    if (given.y.size() != given.x.size() ||
        (!given.sigma.empty() && given.sigma.size() != given.x.size())) {
        throw Error("fit.lengths", "samples",
                    std::to_string(given.x.size()) + ", " + std::to_string(given.y.size()) + ", " +
                        std::to_string(given.sigma.size()),
                    "x, y and sigma must be equally many");
    }
    const FirstLook look = checked(given);
    Samples samples;
    samples.x = given.x;
    samples.sides = {given.y};
    choose_sigma(samples, given, look, options);
    if (needed == Needed::nothing && given.x.empty()) return samples;
    if (needed == Needed::range && given.x.size() < 2) {
        throw Error("fit.too-few", "samples", std::to_string(given.x.size()),
                    "there must be at least two");
    }
    if (look.falls || samples.has_weightless) {
        const auto [lo, hi] = std::minmax_element(given.x.begin(), given.x.end());
        samples.range = {*lo, *hi};
        sort_and_drop(samples);
    } else {
        samples.range = {given.x.front(), given.x.back()};
    }
    if (needed == Needed::range && !(samples.range.lo < samples.range.hi)) {
        throw Error("fit.x-equal", "x", format_number(samples.range.lo),
                    "the abscissae must not all be equal");
    }
    if (samples.size() > 0) {
        const Interval own = samples.range;
        samples.range = domain.value_or(own);
        require_units(samples, look.largest, options.degree);
        samples.range = own;
    }
    if (!samples.sigma_known) {
        estimate_sigma(samples, noise_from_differences(samples.x, samples.sides[0]), look.largest);
    }
    samples.work = Work(options.progress);
    return samples;
}

}  // namespace

Samples prepared(const FitSamples& given, const FitOptions& options) {
    return prepared_as(Needed::range, given, options);
}

Samples prepared_part(const FitSamples& given, const FitOptions& options, Interval domain) {
    return prepared_as(Needed::nothing, given, options, domain);
}

std::optional<Samples> believed(const FitSamples& given, const FitOptions& options) {
    const std::size_t n = given.x.size();
    const bool has_column = !given.sigma.empty();
    if (n == 0 || given.y.size() != n || (has_column && given.sigma.size() != n)) return {};
    const bool has_number = options.sigma && *options.sigma > 0 && std::isfinite(*options.sigma);
    if (!has_column && !has_number) return {};
    Samples samples;
    samples.x = given.x;
    samples.sides = {given.y};
    samples.sigma = given.sigma;
    if (!has_column) samples.common_sigma = *options.sigma;
    samples.source = has_column ? SigmaSource::column : SigmaSource::number;
    samples.sigma_known = true;
    samples.range = {given.x.front(), given.x.back()};
    const bool is_range = samples.range.lo < samples.range.hi && std::isfinite(samples.range.lo) &&
                          std::isfinite(samples.range.hi);
    if (!is_range) return {};
    samples.work = Work(options.progress);
    return samples;
}

Samples reweighted(const Samples& samples, std::span<const double> factor) {
    Samples result;
    result.x = samples.x;
    result.sides = samples.sides;
    result.sigma_known = samples.sigma_known;
    result.common_sigma = samples.common_sigma;
    result.source = samples.source;
    result.are_feet = samples.are_feet;
    result.least_delta2 = samples.least_delta2;
    result.work = samples.work;
    result.range = samples.range;
    result.row_of = samples.row_of;
    std::vector<double> sigma(samples.size());
    for (std::size_t i = 0; i < sigma.size(); ++i) sigma[i] = samples.sigma_at(i) * factor[i];
    result.sigma = sigma;
    sort_and_drop(result);
    return result;
}

}  // namespace batten::fitting
