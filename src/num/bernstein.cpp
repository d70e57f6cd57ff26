#include "num/bernstein.hpp"

#include <cassert>
#include <cmath>

#include "num/roots.hpp"

namespace batten::bernstein {
namespace {

constexpr std::size_t tabulated_degree = 32;

constexpr auto pascal = [] {
    std::array<std::array<double, tabulated_degree + 1>, tabulated_degree + 1> rows{};
    for (std::size_t n = 0; n <= tabulated_degree; ++n) {
        rows[n][0] = rows[n][n] = 1;
        for (std::size_t k = 1; k < n; ++k) rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
    }
    return rows;
}();

/// Below this width in u two places are one: an ulp of 1 is 2^-52.
constexpr double narrowest = 0x1p-50;

int sign_changes(View c) {
    int changes = 0;
    double last = 0;
    for (const double x : c) {
        if (x == 0) continue;
        if (last != 0 && (x > 0) != (last > 0)) ++changes;
        last = x;
    }
    return changes;
}

struct RootSearch {
    double noise;
    std::vector<double> found;

    void search(View c, Interval u) {
        const auto [least, most] = std::minmax_element(c.begin(), c.end());
        if (*least > noise || *most < -noise) return;
        if (u.length() <= narrowest || (*most <= noise && *least >= -noise)) {
            found.push_back(u.middle());
            return;
        }
        const bool starts = std::fabs(c.front()) <= noise, ends = std::fabs(c.back()) <= noise;
        if (starts) found.push_back(u.lo);
        if (ends) found.push_back(u.hi);
        const View inner = c.subspan(starts ? 1 : 0, c.size() - (starts ? 1 : 0) - (ends ? 1 : 0));
        const auto [low, high] = std::minmax_element(inner.begin(), inner.end());
        if (*low > noise || *high < -noise) return;
        if (!starts && !ends && (c.front() > 0) != (c.back() > 0) && sign_changes(c) == 1) {
            const auto f = [c](double x) { return value(c, x); };
            found.push_back(u.lo + u.length() * num::find_root(f, {0, 1}).at);
            return;
        }
        const Halves halves = split(c, 0.5);
        search(halves.left, {u.lo, u.middle()});
        search(halves.right, {u.middle(), u.hi});
    }
};

}  // namespace

double binomial(std::size_t n, std::size_t k) {
    if (n <= tabulated_degree) return pascal[n][k];
    double product = 1;
    for (std::size_t i = 1; i <= k; ++i) {
        product *= static_cast<double>(n - k + i) / static_cast<double>(i);
    }
    return product;
}

double value(View c, double u) {
    Coefficients work(c);
    double* const w = work.data();
    const double v = 1 - u;
    for (std::size_t n = c.size() - 1; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) w[i] = v * w[i] + u * w[i + 1];
    }
    return w[0];
}

double bound(View c) {
    double most = 0;
    for (const double x : c) most = std::fmax(most, std::fabs(x));
    return most;
}

Coefficients derivative(View c) {
    const std::size_t n = c.size() - 1;
    Coefficients result(std::max<std::size_t>(n, 1));
    for (std::size_t i = 0; i < n; ++i) {
        result[i] = static_cast<double>(n) * (c[i + 1] - c[i]);
    }
    return result;
}

Coefficients product(View a, View b) {
    const std::size_t n = a.size() - 1, m = b.size() - 1;
    Coefficients result(n + m + 1);
    double* const c = result.data();
    for (std::size_t i = 0; i <= n; ++i) {
        const double x = binomial(n, i) * a[i];
        for (std::size_t j = 0; j <= m; ++j) c[i + j] += x * (binomial(m, j) * b[j]);
    }
    for (std::size_t k = 0; k <= n + m; ++k) c[k] /= binomial(n + m, k);
    return result;
}

Coefficients combination(View a, double factor, View b) {
    assert(a.size() == b.size());
    Coefficients result(a);
    for (std::size_t i = 0; i < b.size(); ++i) result[i] += factor * b[i];
    return result;
}

Coefficients raised(View c, std::size_t degree) {
    Coefficients one(degree + 2 - c.size());
    std::fill(one.begin(), one.end(), 1.0);
    return product(c, one);
}

Halves split(View c, double u) {
    const std::size_t n = c.size() - 1;
    Halves halves{Coefficients(n + 1), Coefficients(c)};
    double* const left = halves.left.data();
    double* const work = halves.right.data();
    const double v = 1 - u;
    left[0] = work[0];
    for (std::size_t step = 1; step <= n; ++step) {
        for (std::size_t i = 0; i <= n - step; ++i) work[i] = v * work[i] + u * work[i + 1];
        left[step] = work[0];
    }
    return halves;
}

Coefficients restricted(View c, Interval part) {
    Coefficients result(c);
    if (part.hi < 1) result = split(result, part.hi).left;
    if (part.lo > 0) result = split(result, part.lo / part.hi).right;
    return result;
}

Coefficients without_zero_at_start(View c) {
    const std::size_t n = c.size() - 1;
    Coefficients result(n);
    for (std::size_t i = 0; i < n; ++i) {
        result[i] = c[i + 1] * static_cast<double>(n) / static_cast<double>(i + 1);
    }
    return result;
}

Coefficients without_zero_at_end(View c) {
    const std::size_t n = c.size() - 1;
    Coefficients result(n);
    for (std::size_t i = 0; i < n; ++i) {
        result[i] = c[i] * static_cast<double>(n) / static_cast<double>(n - i);
    }
    return result;
}

std::vector<double> roots(View c, double noise) {
    if (bound(c) <= noise) return {};
    RootSearch search{noise, {}};
    search.search(c, {0, 1});
    std::sort(search.found.begin(), search.found.end());
    std::vector<double> distinct;
    for (const double u : search.found) {
        const Interval gap{distinct.empty() ? u : distinct.back(), u};
        if (distinct.empty() ||
            (gap.length() > narrowest && std::fabs(value(c, gap.middle())) > noise)) {
            distinct.push_back(u);
        } else if (std::fabs(value(c, u)) < std::fabs(value(c, gap.lo))) {
            distinct.back() = u;
        }
    }
    return distinct;
}

std::vector<SignRun> sign_runs(View c, double noise) {
    std::vector<SignRun> runs;
    const auto add = [&](Interval where) {
        const double middle = value(c, where.middle());
        if (where.length() <= 0 || std::fabs(middle) <= noise) return;
        const int sign = middle > 0 ? 1 : -1;
        if (!runs.empty() && runs.back().sign == sign) {
            runs.back().where.hi = where.hi;
        } else {
            runs.push_back({where, sign});
        }
    };
    double start = 0;
    for (const double u : roots(c, noise)) {
        add({start, u});
        start = u;
    }
    add({start, 1});
    return runs;
}

}  // namespace batten::bernstein
