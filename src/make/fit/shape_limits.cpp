#include "make/fit/shape_limits.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "num/householder.hpp"
#include "num/nonnegative.hpp"

namespace batten::fitting {
namespace {

using num::DenseMatrix;

/// A linear form of the coefficients.
struct Form {
    std::vector<std::size_t> at;
    std::vector<double> factor;
};

/// Coefficients as functions of those that are free: c = map f + offset.
struct Freedom {
    std::vector<std::ptrdiff_t> free_of;  ///< -1: fixed
    std::vector<double> offset;
    std::size_t free = 0;
    std::vector<Form> held;
};

/// Values and slopes fixed at one end; `step` leads inwards.
void fix_end(Freedom& freedom, std::size_t end, std::ptrdiff_t step, std::optional<double> value,
             std::optional<double> rise) {
    const std::size_t next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(end) + step);
    if (value) {
        freedom.free_of[end] = -1;
        freedom.offset[end] = *value;
        freedom.held.push_back({{end}, {1}});
    }
    if (!rise) return;
    freedom.held.push_back({{next, end}, {1, -1}});
    if (value) {
        freedom.free_of[next] = -1;
        freedom.offset[next] = *value + *rise;
    } else {
        freedom.free_of[next] = static_cast<std::ptrdiff_t>(end);  // made one with the end below
        freedom.offset[next] = *rise;
    }
}

/// The change of the coefficient beside an end for a slope there.
std::optional<double> rise_of(const FixedFit& fixed, std::optional<double> slope, bool is_start) {
    if (!slope) return std::nullopt;
    const std::span<const double> t = fixed.knots;
    const std::size_t k = static_cast<std::size_t>(fixed.system.order());
    const std::size_t p = static_cast<std::size_t>(fixed.functions);
    const double gap = is_start ? t[k] - t[1] : t[p + k - 2] - t[p - 1];
    return (is_start ? 1 : -1) * *slope * gap / static_cast<double>(k - 1);
}

Freedom freedom_of(const FixedFit& fixed, const FitOptions& options) {
    const std::size_t p = static_cast<std::size_t>(fixed.functions);
    constexpr std::ptrdiff_t own = -2;
    Freedom freedom{std::vector<std::ptrdiff_t>(p, own), std::vector<double>(p, 0.0), 0, {}};
    fix_end(freedom, 0, 1, options.start_value, rise_of(fixed, options.start_slope, true));
    fix_end(freedom, p - 1, -1, options.end_value, rise_of(fixed, options.end_slope, false));
    std::vector<std::ptrdiff_t> place(p, -1);
    for (std::size_t j = 0; j < p; ++j) {
        if (freedom.free_of[j] == own) place[j] = static_cast<std::ptrdiff_t>(freedom.free++);
    }
    for (std::size_t j = 0; j < p; ++j) {
        const std::ptrdiff_t with = freedom.free_of[j];
        if (with == -1) continue;
        freedom.free_of[j] = place[with == own ? j : static_cast<std::size_t>(with)];
    }
    return freedom;
}

/// How many coefficients beside the ends take part in what is held there.
int coefficients_held(const FitOptions& o) {
    const int start = o.start_slope ? 2 : o.start_value ? 1 : 0;
    const int end = o.end_slope ? 2 : o.end_value ? 1 : 0;
    return start + end;
}

/// The sign that `direction` asks for; by the data where it is to be found: that of the sum.
double sign_of(Direction direction, double sum) {
    if (direction == Direction::up) return 1;
    if (direction == Direction::down) return -1;
    return sum < 0 ? -1 : 1;
}

/// Forms that must not be negative.
std::vector<Form> rising_forms(std::size_t p, Direction direction, std::span<const double> c) {
    const double sign = sign_of(direction, c[p - 1] - c[0]);
    std::vector<Form> forms;
    for (std::size_t j = 0; j + 1 < p; ++j) forms.push_back({{j, j + 1}, {-sign, sign}});
    return forms;
}

std::vector<Form> bending_forms(const FixedFit& fixed, Direction direction,
                                std::span<const double> c) {
    const std::span<const double> t = fixed.knots;
    const std::size_t k = static_cast<std::size_t>(fixed.system.order());
    const std::size_t p = static_cast<std::size_t>(fixed.functions);
    std::vector<Form> forms;
    double sum = 0;
    for (std::size_t j = 0; j + 2 < p; ++j) {
        const double here = t[j + k] - t[j + 1], next = t[j + k + 1] - t[j + 2];
        if (!(here > 0 && next > 0)) continue;
        // The difference of the slopes beside coefficient j + 1, times both gaps.
        forms.push_back({{j, j + 1, j + 2}, {next, -(next + here), here}});
        sum += (c[j + 2] - c[j + 1]) / next - (c[j + 1] - c[j]) / here;
    }
    const double sign = sign_of(direction, sum);
    for (Form& form : forms) {
        for (double& f : form.factor) f *= sign;
    }
    return forms;
}

std::vector<Form> forms_of(const FixedFit& fixed, const FitOptions& options) {
    const std::span<const double> c = fixed.system.coefficients(0);
    std::vector<Form> forms;
    if (options.monotone != Direction::free && c.size() > 1) {
        forms = rising_forms(c.size(), options.monotone, c);
    }
    if (options.convex != Direction::free) {
        for (Form& f : bending_forms(fixed, options.convex, c)) forms.push_back(std::move(f));
    }
    return forms;
}

/// The problem in the free coefficients: R' f = z', triangular, the right side last.
DenseMatrix reduced(const FixedFit& fixed, const Freedom& freedom) {
    const num::BandedQr& qr = fixed.system.qr();
    const std::size_t q = freedom.free, p = freedom.offset.size();
    const std::size_t band = static_cast<std::size_t>(qr.shape().width);
    DenseMatrix triangle(q, q + 1);
    std::vector<double> rows(p * (q + 1), 0.0);
    for (std::size_t i = 0; i < p; ++i) {
        const double* const r = qr.row(static_cast<int>(i));
        double* const row = rows.data() + i * (q + 1);
        row[q] = r[band];
        for (std::size_t l = 0; l < band && i + l < p; ++l) {
            const std::ptrdiff_t f = freedom.free_of[i + l];
            row[q] -= r[l] * freedom.offset[i + l];
            if (f >= 0) row[f] += r[l];
        }
    }
    num::absorb({triangle.entries.data(), q + 1, static_cast<int>(q), static_cast<int>(q + 1)},
                {rows.data(), static_cast<int>(p), q + 1});
    return triangle;
}

/// The row g R'^-1 for a row g.
void divide(const DenseMatrix& triangle, std::span<double> g) {
    for (std::size_t j = 0; j < g.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) g[j] -= g[i] * triangle(i, j);
        g[j] /= triangle(j, j);
    }
}

std::vector<double> back_substituted(const DenseMatrix& triangle, std::vector<double> u) {
    for (std::size_t i = u.size(); i-- > 0;) {
        for (std::size_t j = i + 1; j < u.size(); ++j) u[i] -= triangle(i, j) * u[j];
        u[i] /= triangle(i, i);
    }
    return u;
}

}  // namespace

bool has_limits(const FitOptions& o) {
    return o.start_value || o.start_slope || o.end_value || o.end_slope ||
           o.monotone != Direction::free || o.convex != Direction::free;
}

void require_limits(const FitOptions& o) {
    if (!has_limits(o)) return;
    if (o.closed) {
        throw Error("fit.options", "closed", "true",
                    "monotone, convex, values and slopes at the ends go with open splines only");
    }
    const bool needs_slope =
        o.start_slope || o.end_slope || o.convex != Direction::free;
    if (o.degree == 0 && needs_slope) {
        throw Error("fit.options", "degree", "0", "slopes and convexity need degree 1 or more");
    }
}

bool keep_within_limits(FixedFit& fixed, const FitOptions& options) {
    if (coefficients_held(options) > fixed.functions) return false;
    const Freedom freedom = freedom_of(fixed, options);
    const std::vector<Form> forms = forms_of(fixed, options);
    const DenseMatrix triangle = reduced(fixed, freedom);
    const std::size_t q = freedom.free, p = freedom.offset.size();
    std::vector<double> z(q);
    for (std::size_t i = 0; i < q; ++i) z[i] = triangle(i, q);

    DenseMatrix rows(forms.size(), q);
    std::vector<double> right(forms.size(), 0.0);
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const std::span<double> g(rows.entries.data() + i * q, q);
        for (std::size_t l = 0; l < forms[i].at.size(); ++l) {
            const std::ptrdiff_t f = freedom.free_of[forms[i].at[l]];
            right[i] -= forms[i].factor[l] * freedom.offset[forms[i].at[l]];
            if (f >= 0) g[static_cast<std::size_t>(f)] += forms[i].factor[l];
        }
        divide(triangle, g);
        for (std::size_t j = 0; j < q; ++j) right[i] -= g[j] * z[j];
    }
    const auto nearest = num::least_distance(rows, right);
    if (!nearest) return false;
    for (std::size_t j = 0; j < q; ++j) z[j] += nearest->point[j];
    const std::vector<double> free = back_substituted(triangle, std::move(z));

    std::vector<double> limited(p);
    for (std::size_t j = 0; j < p; ++j) {
        const std::ptrdiff_t f = freedom.free_of[j];
        limited[j] = freedom.offset[j] + (f >= 0 ? free[static_cast<std::size_t>(f)] : 0);
    }
    if (options.monotone != Direction::free && p > 1) {
        // Rounding leaves steps of an ulp; a flat stretch is to be flat.
        const double sign = forms.front().factor[1];
        for (std::size_t j = 1; j < p; ++j) {
            double& c = limited[j];
            if (sign * (c - limited[j - 1]) < 0) c = limited[j - 1];
        }
    }
    fixed.limited = {std::move(limited)};
    const auto hold = [&](const Form& form) {
        std::vector<double> row(p, 0.0);
        for (std::size_t l = 0; l < form.at.size(); ++l) row[form.at[l]] += form.factor[l];
        fixed.held.push_back(std::move(row));
    };
    fixed.fixed_count = static_cast<int>(freedom.held.size());
    for (const Form& form : freedom.held) hold(form);
    for (const std::size_t i : nearest->active) hold(forms[i]);
    return true;
}

}  // namespace batten::fitting
