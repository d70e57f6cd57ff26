#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/spline_function.hpp"
#include "num/roots.hpp"
#include "shape/knots.hpp"

/// Derivative, integral, crossings and extrema of a spline, and its graph.
namespace batten {
namespace {

constexpr int most_halvings = 60;

/// One polynomial in Bernstein form: the signs of its coefficients bound the number of its roots.
struct Bernstein {
    std::array<double, knots::most_order> b{};
    int degree = 0;
    Interval part;

    int sign_changes() const {
        int changes = 0;
        double last = 0;
        for (int j = 0; j <= degree; ++j) {
            if (b[j] == 0) continue;
            changes += last != 0 && (b[j] > 0) != (last > 0);
            last = b[j];
        }
        return changes;
    }
    bool is_zero() const {
        return std::all_of(b.begin(), b.begin() + degree + 1, [](double c) { return c == 0; });
    }
};

struct Halves {
    Bernstein left, right;
};

Halves halved(const Bernstein& whole) {
    Halves result{whole, whole};
    Bernstein rest = whole;
    for (int level = 0; level <= whole.degree; ++level) {
        result.left.b[level] = rest.b[0];
        result.right.b[whole.degree - level] = rest.b[whole.degree - level];
        for (int j = 0; j + level < whole.degree; ++j) rest.b[j] = 0.5 * (rest.b[j] + rest.b[j + 1]);
    }
    result.left.part.hi = result.right.part.lo = whole.part.middle();
    return result;
}

/// The piece less `level`, from its power form.
Bernstein bernstein(const SplineFunction& s, std::size_t piece, double level) {
    Bernstein result;
    result.degree = s.degree();
    result.part = {s.breaks()[piece], s.breaks()[piece + 1]};
    std::array<double, knots::most_order> a{};
    double power = 1;
    double choose = 1;  // degree over j
    for (int j = 0; j <= s.degree(); ++j) {
        a[j] = s.power(j)[piece] * power / choose;
        power *= result.part.length();
        choose = choose * (s.degree() - j) / (j + 1);
    }
    a[0] -= level;
    for (int j = 0; j <= s.degree(); ++j) {
        double sum = 0, binomial = 1;
        for (int i = 0; i <= j; ++i) {
            sum += binomial * a[i];
            binomial = binomial * (j - i) / (i + 1);
        }
        result.b[j] = sum;
    }
    return result;
}

/// Roots of one piece in the open interval, rising.
void collect(const SplineFunction& s, std::size_t piece, double level, const Bernstein& p,
             int halvings, std::vector<double>& out) {
    const int changes = p.sign_changes();
    if (changes == 0) return;
    const auto value = [&](double x) { return s.value_on(piece, x, 0) - level; };
    if (changes == 1 && (value(p.part.lo) > 0) != (value(p.part.hi) > 0) &&
        value(p.part.lo) != 0 && value(p.part.hi) != 0) {
        out.push_back(num::find_root(value, p.part).at);
        return;
    }
    const double middle = p.part.middle();
    if (halvings == most_halvings || !(p.part.lo < middle && middle < p.part.hi)) {
        out.push_back(middle);
        return;
    }
    const Halves parts = halved(p);
    collect(s, piece, level, parts.left, halvings + 1, out);
    if (parts.right.b[0] == 0) out.push_back(middle);
    collect(s, piece, level, parts.right, halvings + 1, out);
}

}  // namespace

SplineFunction derivative(const SplineFunction& spline) {
    const std::span<const double> t = spline.knots(), c = spline.coefficients();
    const int degree = spline.degree();
    if (degree == 0) {
        const Interval d = spline.domain();
        return {{d.lo, d.hi}, {0.0}, 0};
    }
    std::vector<double> slopes, knots;
    for (std::size_t j = 0; j + 1 < c.size(); ++j) {
        const double width = t[j + 1 + degree] - t[j + 1];
        if (!(width > 0)) continue;  // a jump: its knot stands once less often
        slopes.push_back(degree * (c[j + 1] - c[j]) / width);
        knots.push_back(t[j + 1]);
    }
    knots.insert(knots.end(), t.end() - 1 - degree, t.end() - 1);
    return spline.is_closed()
               ? SplineFunction::periodic(std::move(knots), std::move(slopes), degree - 1)
               : SplineFunction(std::move(knots), std::move(slopes), degree - 1);
}

SplineFunction antiderivative(const SplineFunction& spline) {
    const std::span<const double> t = spline.knots(), c = spline.coefficients();
    const int degree = spline.degree();
    std::vector<double> knots(t.begin(), t.end());
    knots.insert(knots.begin(), t.front());
    knots.push_back(t.back());
    std::vector<double> sums(c.size() + 1);
    for (std::size_t j = 0; j < c.size(); ++j) {
        sums[j + 1] = sums[j] + c[j] * (t[j + 1 + degree] - t[j]) / (degree + 1);
    }
    const SplineFunction raw(knots, sums, degree + 1);
    const double start = raw(raw.domain().lo);
    if (start == 0) return raw;
    for (double& sum : sums) sum -= start;
    return {std::move(knots), std::move(sums), degree + 1};
}

double integral(const SplineFunction& spline, Interval part) {
    const SplineFunction sum = antiderivative(spline);
    return sum(part.hi) - sum(part.lo);
}

std::vector<double> roots(const SplineFunction& spline, double level) {
    std::vector<double> found;
    bool was_level = true;
    for (std::size_t i = 0; i < spline.pieces(); ++i) {
        const Interval piece{spline.breaks()[i], spline.breaks()[i + 1]};
        const double start = spline.value_on(i, piece.lo, 0) - level;
        const double before = i == 0 ? start : spline.value_on(i - 1, piece.lo, 0) - level;
        const Bernstein p = bernstein(spline, i, level);
        const bool is_level = p.is_zero();
        const bool is_root = start == 0 || (start > 0) != (before > 0);
        if (is_root && !(is_level && was_level)) found.push_back(piece.lo);
        collect(spline, i, level, p, 0, found);
        was_level = is_level;
    }
    const double end = spline.domain().hi;
    if (!was_level && spline.value_on(spline.pieces() - 1, end, 0) == level) found.push_back(end);
    // A root at a joint may have been met by both its pieces.
    const auto is_same = [](double a, double b) {
        return b - a <= 8 * std::numeric_limits<double>::epsilon() *
                            std::max(std::fabs(a), std::fabs(b));
    };
    found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
    return found;
}

std::vector<double> extrema(const SplineFunction& spline) {
    const SplineFunction slope = derivative(spline);
    const Interval domain = spline.domain();
    std::vector<double> ends = roots(slope);
    std::vector<double> found;
    double from = domain.lo;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!(ends[i] > domain.lo && ends[i] < domain.hi)) continue;
        const double to = i + 1 < ends.size() ? ends[i + 1] : domain.hi;
        const double before = slope(0.5 * (from + ends[i])), after = slope(0.5 * (ends[i] + to));
        if ((before > 0) != (after > 0)) found.push_back(ends[i]);
        from = ends[i];
    }
    return found;
}

Curve graph(const SplineFunction& spline) {
    const SplineFunction s = clamped(spline);
    if (s.degree() == 0) {
        throw Error("spline.not-continuous", "degree", "0", "a curve has no jumps");
    }
    const std::size_t n = s.coefficients().size(), degree = static_cast<std::size_t>(s.degree());
    Points control(n, 2);
    for (std::size_t j = 0; j < n; ++j) {
        if (j > 0 && s.knots()[j] > s.domain().lo && s.knots()[j] == s.knots()[j + degree]) {
            throw Error("spline.not-continuous", "knot", format_number(s.knots()[j]),
                        "a curve has no jumps");
        }
        double mean = 0;
        for (std::size_t i = 1; i <= degree; ++i) mean += s.knots()[j + i];
        control(j, 0) = mean / static_cast<double>(degree);
        control(j, 1) = s.coefficients()[j];
    }
    const std::vector<double> knots(s.knots().begin(), s.knots().end());
    return BSplineCurve(BSplineBasis(knots, s.degree()), std::move(control));
}

PiecewiseCubic graph_cubic(const SplineFunction& spline) {
    if (spline.degree() > 3) {
        throw Error("spline.degree", "degree", std::to_string(spline.degree()), "must be 3 or less");
    }
    const std::size_t n = spline.pieces(), width = n + 1;
    std::vector<double> block(8 * width);
    for (std::size_t i = 0; i <= n; ++i) block[i] = spline.breaks()[i];
    for (std::size_t i = 0; i < n; ++i) {
        block[2 * width + i] = 1;
        for (int j = 0; j <= spline.degree(); ++j) {
            block[static_cast<std::size_t>(2 * j + 1) * width + i] = spline.power(j)[i];
        }
    }
    block[width + n] = spline.value_on(n - 1, spline.domain().hi, 0);
    return PiecewiseCubic::power(std::move(block), 2,
                                 {spline.breaks().begin(), spline.breaks().end()}, false);
}

}  // namespace batten
