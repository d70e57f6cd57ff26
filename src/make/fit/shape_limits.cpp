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

/// Which way a spline goes and bends: up, down, or free.
struct Way {
    Direction monotone = Direction::free;
    Direction convex = Direction::free;
};

double sign_of(Direction direction) { return direction == Direction::down ? -1 : 1; }

/// How the slopes change from coefficient j to j + 2, times both gaps; none where knots are stacked.
std::optional<Form> bend_at(const FixedFit& fixed, std::size_t j) {
    const std::span<const double> t = fixed.knots;
    const std::size_t k = static_cast<std::size_t>(fixed.system.order());
    const double here = t[j + k] - t[j + 1], next = t[j + k + 1] - t[j + 2];
    if (!(here > 0 && next > 0)) return std::nullopt;
    return Form{{j, j + 1, j + 2}, {next, -(next + here), here}};
}

/// Forms that must not be negative.
std::vector<Form> forms_of(const FixedFit& fixed, Way way) {
    const std::size_t p = static_cast<std::size_t>(fixed.functions);
    std::vector<Form> forms;
    const double rise = sign_of(way.monotone), bend = sign_of(way.convex);
    for (std::size_t j = 0; j + 1 < p && way.monotone != Direction::free; ++j) {
        forms.push_back({{j, j + 1}, {-rise, rise}});
    }
    for (std::size_t j = 0; j + 2 < p && way.convex != Direction::free; ++j) {
        std::optional<Form> form = bend_at(fixed, j);
        if (!form) continue;
        for (double& f : form->factor) f *= bend;
        forms.push_back(*std::move(form));
    }
    return forms;
}

/// The ways that are allowed; first the one that the fit without limits goes from end to end.
std::vector<Way> ways_of(const FixedFit& fixed, const FitOptions& options) {
    const std::span<const double> c = fixed.system.coefficients(0);
    double bend = 0;
    for (std::size_t j = 0; j + 2 < c.size(); ++j) {
        const std::optional<Form> form = bend_at(fixed, j);
        if (!form) continue;
        const double both = form->factor[0] * form->factor[2];
        for (std::size_t l = 0; l < 3; ++l) bend += form->factor[l] * c[j + l] / both;
    }
    const auto directions = [](Direction asked, double sum) -> std::vector<Direction> {
        if (asked != Direction::by_data) return {asked};
        if (sum < 0) return {Direction::down, Direction::up};
        return {Direction::up, Direction::down};
    };
    std::vector<Way> ways;
    for (const Direction convex : directions(options.convex, bend)) {
        for (const Direction monotone : directions(options.monotone, c.back() - c.front())) {
            ways.push_back({monotone, convex});
        }
    }
    return ways;
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

/// What a form is of the fixed coefficients; 0 where that is rounding.
double fixed_part(const Form& form, const Freedom& freedom) {
    double sum = 0, largest = 0;
    for (std::size_t l = 0; l < form.at.size(); ++l) {
        const double term = form.factor[l] * freedom.offset[form.at[l]];
        sum += term;
        largest = std::max(largest, std::fabs(term));
    }
    constexpr double rounding = 1e-14;
    return std::fabs(sum) > rounding * largest ? sum : 0;
}

/// Rounding leaves steps of an ulp; a flat stretch is to be flat, and what is fixed stays.
void take_out_ulps(std::vector<double>& c, const Freedom& freedom, Direction monotone) {
    const double sign = sign_of(monotone);
    const auto follow = [&](std::size_t j, std::size_t leader, double way) {
        if (freedom.free_of[j] >= 0 && way * (c[j] - c[leader]) < 0) c[j] = c[leader];
    };
    for (std::size_t j = 1; j < c.size(); ++j) follow(j, j - 1, sign);
    for (std::size_t j = c.size() - 1; j-- > 0;) follow(j, j + 1, -sign);
}

/// The best coefficients of one way, and what keeps them from better ones.
struct WithinLimits {
    std::vector<double> coefficients;
    std::vector<Form> active;
    double distance_sq = 0;  ///< how much delta2 is above that of fixed coefficients alone
};

std::optional<WithinLimits> nearest_within(const FixedFit& fixed, const Freedom& freedom,
                                           const DenseMatrix& triangle, Way way) {
    const std::vector<Form> forms = forms_of(fixed, way);
    const std::size_t q = freedom.free, p = freedom.offset.size();
    std::vector<double> z(q);
    for (std::size_t i = 0; i < q; ++i) z[i] = triangle(i, q);
    DenseMatrix rows(forms.size(), q);
    std::vector<double> right(forms.size(), 0.0);
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const std::span<double> g(rows.entries.data() + i * q, q);
        for (std::size_t l = 0; l < forms[i].at.size(); ++l) {
            const std::ptrdiff_t f = freedom.free_of[forms[i].at[l]];
            if (f >= 0) g[static_cast<std::size_t>(f)] += forms[i].factor[l];
        }
        divide(triangle, g);
        right[i] = -fixed_part(forms[i], freedom);
        for (std::size_t j = 0; j < q; ++j) right[i] -= g[j] * z[j];
    }
    const auto nearest = num::least_distance(rows, right);
    if (!nearest) return std::nullopt;
    WithinLimits result;
    for (std::size_t j = 0; j < q; ++j) {
        z[j] += nearest->point[j];
        result.distance_sq += nearest->point[j] * nearest->point[j];
    }
    const std::vector<double> free = back_substituted(triangle, std::move(z));
    result.coefficients = freedom.offset;
    for (std::size_t j = 0; j < p; ++j) {
        const std::ptrdiff_t f = freedom.free_of[j];
        if (f >= 0) result.coefficients[j] += free[static_cast<std::size_t>(f)];
    }
    if (way.monotone != Direction::free) {
        take_out_ulps(result.coefficients, freedom, way.monotone);
    }
    for (const std::size_t i : nearest->active) result.active.push_back(forms[i]);
    return result;
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
    const DenseMatrix triangle = reduced(fixed, freedom);
    std::optional<WithinLimits> best;
    for (const Way way : ways_of(fixed, options)) {
        std::optional<WithinLimits> found = nearest_within(fixed, freedom, triangle, way);
        if (!found || (best && !(found->distance_sq < best->distance_sq))) continue;
        best = std::move(found);
        if (best->distance_sq == 0) break;
    }
    if (!best) return false;
    fixed.limited = {std::move(best->coefficients)};
    const auto hold = [&](const Form& form) {
        std::vector<double> row(freedom.offset.size(), 0.0);
        for (std::size_t l = 0; l < form.at.size(); ++l) row[form.at[l]] += form.factor[l];
        fixed.held.push_back(std::move(row));
    };
    fixed.fixed_count = static_cast<int>(freedom.held.size());
    for (const Form& form : freedom.held) hold(form);
    for (const Form& form : best->active) hold(form);
    return true;
}

}  // namespace batten::fitting
