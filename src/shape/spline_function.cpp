#include "batten/shape/spline_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "shape/knots.hpp"

namespace batten {
namespace {

void require_knots(std::span<const double> knots, std::size_t coefficients, int degree) {
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    if (knots.size() != coefficients + order || coefficients < order) {
        throw Error("spline.knots", "knots", std::to_string(knots.size()),
                    "there must be degree + 1 more than coefficients, and degree + 1 of those");
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const std::string place = "knot " + std::to_string(i);
        if (!std::isfinite(knots[i])) {
            throw Error("spline.knots", place, format_number(knots[i]), "must be finite");
        }
        if (i > 0 && knots[i] < knots[i - 1]) {
            throw Error("spline.knots", place, format_number(knots[i]), "must not decrease");
        }
        if (i > order && i + 1 < knots.size() && knots[i] == knots[i - order]) {
            throw Error("spline.knots", place, format_number(knots[i]),
                        "must not be repeated more than degree + 1 times");
        }
    }
    if (!(knots[order - 1] < knots[coefficients])) {
        throw Error("spline.knots", "domain", format_number(knots[order - 1]),
                    "must have positive length");
    }
}

/// Taylor coefficients at the left end of one span, from its coefficients `c` (degree + 1).
void taylor(std::span<const double> knots, std::size_t span, int degree, std::span<double> c,
            double* out, std::size_t stride) {
    const double at = knots[span];
    double factor = 1;  // degree! / (degree - r)! / r!, step by step
    std::array<double, knots::most_order> d;
    for (int r = 0; r <= degree; ++r) {
        const int rest = degree - r;  // c now holds the rest + 1 coefficients of derivative r
        std::copy(c.begin(), c.begin() + rest + 1, d.begin());
        for (int level = 1; level <= rest; ++level) {
            for (int j = 0; j + level <= rest; ++j) {
                const double lo = knots[span - static_cast<std::size_t>(rest - level - j)];
                const double hi = knots[span + static_cast<std::size_t>(j) + 1];
                const double share = (at - lo) / (hi - lo);
                d[j] = (1 - share) * d[j] + share * d[j + 1];
            }
        }
        out[static_cast<std::size_t>(r) * stride] = factor * d[0];
        for (int j = 0; j < rest; ++j) {
            const double lo = knots[span - static_cast<std::size_t>(rest - 1 - j)];
            const double hi = knots[span + static_cast<std::size_t>(j) + 1];
            c[j] = rest * (c[j + 1] - c[j]) / (hi - lo);
        }
        factor /= r + 1;
    }
}

}  // namespace

SplineFunction::SplineFunction(std::vector<double> knots, std::vector<double> coefficients,
                               int degree)
    : knots_(std::move(knots)), coefficients_(std::move(coefficients)), degree_(degree) {
    if (degree < 0 || degree > BSplineBasis::most_degree) {
        throw Error("spline.degree", "degree", std::to_string(degree),
                    "must be 0 to " + std::to_string(BSplineBasis::most_degree));
    }
    require_knots(knots_, coefficients_.size(), degree);
    for (std::size_t j = 0; j < coefficients_.size(); ++j) {
        if (!std::isfinite(coefficients_[j])) {
            throw Error("spline.coefficients", "coefficient " + std::to_string(j),
                        format_number(coefficients_[j]), "must be finite");
        }
    }
    build_pieces();
    build_guide();
}

SplineFunction SplineFunction::periodic(std::vector<double> knots,
                                        std::vector<double> coefficients, int degree) {
    SplineFunction result(std::move(knots), std::move(coefficients), degree);
    result.closed_ = true;
    return result;
}

void SplineFunction::build_pieces() {
    const std::size_t order = static_cast<std::size_t>(degree_) + 1;
    for (std::size_t span = order - 1; span < coefficients_.size(); ++span) {
        if (knots_[span] < knots_[span + 1]) {
            spans_.push_back(span);
            breaks_.push_back(knots_[span]);
        }
    }
    breaks_.push_back(knots_[coefficients_.size()]);
    power_.resize(order * spans_.size());
    std::array<double, knots::most_order> local;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        std::copy_n(coefficients_.begin() + static_cast<std::ptrdiff_t>(spans_[i] - order + 1),
                    order, local.begin());
        taylor(knots_, spans_[i], degree_, {local.data(), order}, power_.data() + i,
               spans_.size());
    }
    for (const double c : power_) {
        if (!std::isfinite(c)) {
            throw Error("number.overflow", "spline", format_number(c),
                        "a coefficient of the power form is beyond the range of a double");
        }
    }
}

void SplineFunction::build_guide() {
    // Two cells a piece: a cell knows the last piece that starts at or before it does.
    const std::size_t cells = 2 * pieces();
    const double lo = breaks_.front();
    guide_scale_ = static_cast<double>(cells) / (breaks_.back() - lo);
    if (!std::isfinite(guide_scale_)) guide_scale_ = 0;
    guide_.resize(cells);
    std::size_t piece = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        while (piece + 1 < pieces() &&
               (breaks_[piece + 1] - lo) * guide_scale_ < static_cast<double>(cell)) {
            ++piece;
        }
        guide_[cell] = static_cast<unsigned>(piece);
    }
}

std::size_t SplineFunction::piece_of(double x) const {
    const double cell = (x - breaks_.front()) * guide_scale_;
    const std::size_t last = pieces() - 1;
    if (!(cell > 0)) return 0;
    if (!(cell < static_cast<double>(guide_.size()))) return last;
    std::size_t piece = guide_[static_cast<std::size_t>(cell)];
    for (int step = 0; step < 4; ++step) {
        if (piece == last || x < breaks_[piece + 1]) return piece;
        ++piece;
    }
    const auto from = breaks_.begin() + static_cast<std::ptrdiff_t>(piece) + 1;
    const auto to = breaks_.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(from, to, x) - breaks_.begin()) - 1;
}

double SplineFunction::value_on(std::size_t piece, double x, int derivative) const {
    const double u = x - breaks_[piece];
    double sum = 0;
    for (int j = degree_; j >= derivative; --j) {
        double factor = 1;
        for (int r = 0; r < derivative; ++r) factor *= j - r;
        sum = sum * u + factor * power(j)[piece];
    }
    return sum;
}

}  // namespace batten
