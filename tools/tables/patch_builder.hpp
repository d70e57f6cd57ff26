#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "num/patches.hpp"

/// Builds the tables that num/patches.hpp reads, from anything that can find the least of several
/// minima at a point and follow one of them from point to point.
namespace batten::patches {

/// A rectangle and how often the table's box was halved to get it.
struct Rectangle {
    Box box;
    int x_level = 0, y_level = 0;

    double x(double u) const { return box.x.middle() + 0.5 * box.x.length() * u; }
    double y(double v) const { return box.y.middle() + 0.5 * box.y.length() * v; }
};

/// Whole numbers as text; see `Table`.
class Writer {
public:
    void number(std::uint64_t n) {
        for (; n > 31; n >>= 5) text_ += digit(static_cast<unsigned>(n & 31) | 32);
        text_ += digit(static_cast<unsigned>(n));
    }
    void signed_number(double n) {
        const std::uint64_t size = static_cast<std::uint64_t>(std::fabs(n));
        number(size << 1 | (n < 0 ? 1 : 0));
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// One of the functions on a rectangle: Chebyshev coefficients [i][j][output].
struct Function {
    std::vector<Outputs> coefficients;
    double tail_x = 0, tail_y = 0;  // largest coefficients of the highest degrees
    Outputs units{};                // what they may be rounded to
};

/// What became of the patches.
struct Census {
    int patches = 0, functions = 0, empty = 0;
    double empty_share = 0;  // of the box
};

/// `Problem` offers shape(), box(), x_levels(), y_levels(); concerns(x, y): whether the table is
/// ever asked there; Solution least(x, y) and follow(x, y, Solution start); Solution
/// extrapolated(a, b, w) = a + w (a - b); agrees(x, y, Outputs, Solution); energy(x, y, Outputs);
/// units(Rectangle, outputs at the nodes). A Solution has outputs, energy and is_converged.
template <class Problem>
class Builder {
public:
    using Solution = typename Problem::Solution;

    explicit Builder(const Problem& problem) : problem_(problem), shape_(problem.shape()) {
        for (const int n : {shape_.width, shape_.height, shape_.outputs}) {
            writer_.number(static_cast<std::uint64_t>(n));
        }
        writer_.number(static_cast<std::uint64_t>(problem.x_levels()));
        writer_.number(static_cast<std::uint64_t>(problem.y_levels()));
        build({problem.box(), 0, 0});
    }
    const std::string& text() const { return writer_.text(); }
    const Census& census() const { return census_; }

private:
    struct Attempt {
        std::vector<Function> functions;
        bool is_good = true;
        bool is_asked = false;  // for any of the points looked at
    };

    void build(const Rectangle& r);
    void put(const Rectangle& r, const std::vector<Function>& functions);
    Attempt attempt(const Rectangle& r);
    bool settle(const Rectangle& r, double u, double v, Attempt& a);
    bool follow_over(const Rectangle& r, double u, double v, const Solution& seed, Function& out);
    Function transformed(const std::vector<Outputs>& values) const;
    Outputs value(const Function& f, double u, double v) const;
    static double node(int i, int n) {
        return n == 1 ? 0 : std::cos(std::numbers::pi * (2 * i + 1) / (2.0 * n));
    }
    std::size_t at(int i, int j) const { return static_cast<std::size_t>(i * shape_.height + j); }

    const Problem& problem_;
    Shape shape_;
    Writer writer_;
    Census census_;
    std::mt19937 random_{5};
};

template <class Problem>
void Builder<Problem>::build(const Rectangle& r) {
    const Attempt a = attempt(r);
    if (a.is_good) return put(r, a.is_asked ? a.functions : std::vector<Function>{});
    const bool x_is_done = r.x_level == problem_.x_levels();
    const bool y_is_done = r.y_level == problem_.y_levels();
    if (x_is_done && y_is_done) {
        ++census_.empty;
        census_.empty_share += std::ldexp(1.0, -r.x_level - r.y_level);
        return put(r, {});
    }
    double tail_x = 0, tail_y = 0;
    for (const Function& f : a.functions) {
        tail_x = std::max(tail_x, f.tail_x);
        tail_y = std::max(tail_y, f.tail_y);
    }
    bool in_x = tail_x == tail_y ? r.x_level <= r.y_level : tail_x > tail_y;
    in_x = y_is_done || (in_x && !x_is_done);
    Rectangle lower = r, upper = r;
    Interval& low = in_x ? lower.box.x : lower.box.y;
    Interval& high = in_x ? upper.box.x : upper.box.y;
    low.hi = high.lo = low.middle();
    ++(in_x ? lower.x_level : lower.y_level);
    ++(in_x ? upper.x_level : upper.y_level);
    writer_.number(in_x ? 0 : 1);
    build(lower);
    build(upper);
}

/// Looks at 97 points for a least minimum that the functions so far do not have, or do not have
/// well enough.
template <class Problem>
auto Builder<Problem>::attempt(const Rectangle& r) -> Attempt {
    constexpr std::array<double, 5> grid{-1, -0.6, 0, 0.6, 1};
    std::uniform_real_distribution<double> anywhere(-1, 1);
    Attempt a;
    for (const double u : grid) {
        for (const double v : grid) {
            if (!settle(r, u, v, a)) return a;
        }
    }
    for (int i = 0; i < 72; ++i) {
        const double u = anywhere(random_), v = anywhere(random_);
        if (!settle(r, u, v, a)) return a;
    }
    return a;
}

template <class Problem>
bool Builder<Problem>::settle(const Rectangle& r, double u, double v, Attempt& a) {
    constexpr std::size_t most_functions = 4;
    const double x = r.x(u), y = r.y(v);
    if (!problem_.concerns(x, y)) return true;
    a.is_asked = true;
    const Solution exact = problem_.least(x, y);
    for (bool is_new = false;; is_new = true) {
        const Function* least = nullptr;
        double lowest = 0;
        bool has_exact = false;
        for (const Function& f : a.functions) {
            const Outputs outputs = value(f, u, v);
            const double energy = problem_.energy(x, y, outputs);
            has_exact |= problem_.agrees(x, y, outputs, exact);
            if (!least || energy < lowest) {
                least = &f;
                lowest = energy;
            }
        }
        // Where two are least, the exact one need not be the one the table would take.
        if (has_exact && lowest > exact.energy * (1 - problem_.energy_tolerance())) return true;
        a.is_good = false;
        if (is_new || a.functions.size() == most_functions) return false;
        Function f;
        if (!follow_over(r, u, v, exact, f)) return false;
        a.functions.push_back(std::move(f));
        a.is_good = true;
    }
}

/// Follows a minimum from (u, v) to all nodes: along one line in x, from there along y.
template <class Problem>
bool Builder<Problem>::follow_over(const Rectangle& r, double u, double v, const Solution& seed,
                                   Function& out) {
    const int width = shape_.width, height = shape_.height;
    const auto nearest = [](double at, int n) {
        int best = 0;
        for (int i = 1; i < n; ++i) {
            if (std::fabs(node(i, n) - at) < std::fabs(node(best, n) - at)) best = i;
        }
        return best;
    };
    std::vector<Solution> found(static_cast<std::size_t>(width * height));
    const auto go_to = [&](int i, int j, const Solution& start) {
        Solution& s = found[at(i, j)];
        s = problem_.follow(r.x(node(i, width)), r.y(node(j, height)), start);
        return s.is_converged;
    };
    const auto line = [&](int from, int n, const auto& cell, const auto& go) {
        for (const int step : {1, -1}) {
            for (int i = from + step; i >= 0 && i < n; i += step) {
                const Solution& last = found[cell(i - step)];
                Solution start = last;
                if (i - 2 * step >= 0 && i - 2 * step < n && (i - 2 * step - from) * step >= 0) {
                    const double before = node(i - 2 * step, n), at_last = node(i - step, n);
                    start = problem_.extrapolated(last, found[cell(i - 2 * step)],
                                                  (node(i, n) - at_last) / (at_last - before));
                }
                if (!go(i, start)) return false;
            }
        }
        return true;
    };
    const int first_i = nearest(u, width), first_j = nearest(v, height);
    if (!go_to(first_i, first_j, seed)) return false;
    if (!line(first_i, width, [&](int i) { return at(i, first_j); },
              [&](int i, const Solution& s) { return go_to(i, first_j, s); })) {
        return false;
    }
    for (int i = 0; i < width; ++i) {
        if (!line(first_j, height, [&](int j) { return at(i, j); },
                  [&](int j, const Solution& s) { return go_to(i, j, s); })) {
            return false;
        }
    }
    std::vector<Outputs> values;
    for (const Solution& s : found) values.push_back(s.outputs);
    out = transformed(values);
    out.units = problem_.units(r, values);
    return true;
}

template <class Problem>
Function Builder<Problem>::transformed(const std::vector<Outputs>& values) const {
    const int width = shape_.width, height = shape_.height;
    const auto cosine = [](int k, int i, int n) {
        return std::cos(std::numbers::pi * k * (2 * i + 1) / (2.0 * n)) * (k == 0 ? 1 : 2) / n;
    };
    Function f;
    f.coefficients.resize(values.size());
    std::vector<Outputs> half(values.size());
    const std::size_t outputs = static_cast<std::size_t>(shape_.outputs);
    for (int k = 0; k < width; ++k) {
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                for (std::size_t q = 0; q < outputs; ++q) {
                    half[at(k, j)][q] += values[at(i, j)][q] * cosine(k, i, width);
                }
            }
        }
    }
    for (int k = 0; k < width; ++k) {
        for (int l = 0; l < height; ++l) {
            for (int j = 0; j < height; ++j) {
                for (std::size_t q = 0; q < outputs; ++q) {
                    f.coefficients[at(k, l)][q] += half[at(k, j)][q] * cosine(l, j, height);
                }
            }
        }
    }
    for (std::size_t q = 0; q < std::min<std::size_t>(outputs, 2); ++q) {
        for (int j = 0; j < height; ++j) {
            f.tail_x = std::max(f.tail_x, std::fabs(f.coefficients[at(width - 1, j)][q]));
        }
        for (int i = 0; i < width && height > 1; ++i) {
            f.tail_y = std::max(f.tail_y, std::fabs(f.coefficients[at(i, height - 1)][q]));
        }
    }
    return f;
}

inline std::vector<double> chebyshev_values(double x, int n) {
    std::vector<double> t(static_cast<std::size_t>(std::max(n, 2)), 1.0);
    t[1] = x;
    for (std::size_t k = 2; k < t.size(); ++k) t[k] = 2 * x * t[k - 1] - t[k - 2];
    return t;
}

template <class Problem>
Outputs Builder<Problem>::value(const Function& f, double u, double v) const {
    const std::vector<double> tu = chebyshev_values(u, shape_.width);
    const std::vector<double> tv = chebyshev_values(v, shape_.height);
    Outputs out{};
    for (int i = 0; i < shape_.width; ++i) {
        for (int j = 0; j < shape_.height; ++j) {
            const double both = tu[static_cast<std::size_t>(i)] * tv[static_cast<std::size_t>(j)];
            for (std::size_t q = 0; q < most_outputs; ++q) {
                out[q] += both * f.coefficients[at(i, j)][q];
            }
        }
    }
    return out;
}

/// The coefficients of T_k in powers: row k.
inline std::vector<std::vector<double>> chebyshev_powers(int n) {
    const std::size_t size = static_cast<std::size_t>(n);
    std::vector<std::vector<double>> rows(size, std::vector<double>(size));
    rows[0][0] = 1;
    if (n > 1) rows[1][1] = 1;
    for (std::size_t k = 2; k < size; ++k) {
        for (std::size_t i = 0; i < size; ++i) {
            rows[k][i] = (i > 0 ? 2 * rows[k - 1][i - 1] : 0) - rows[k - 2][i];
        }
    }
    return rows;
}

template <class Problem>
void Builder<Problem>::put(const Rectangle&, const std::vector<Function>& functions) {
    ++census_.patches;
    census_.functions += static_cast<int>(functions.size());
    writer_.number(2 + functions.size());
    const auto in_u = chebyshev_powers(shape_.width), in_v = chebyshev_powers(shape_.height);
    const std::size_t width = in_u.size(), height = in_v.size();
    for (const Function& f : functions) {
        for (int q = 0; q < shape_.outputs; ++q) {
            writer_.signed_number(std::log2(f.units[static_cast<std::size_t>(q)]));
        }
        for (std::size_t i = 0; i < width; ++i) {
            for (std::size_t j = 0; j < height; ++j) {
                Outputs sum{};
                for (std::size_t k = i; k < width; ++k) {
                    for (std::size_t l = j; l < height; ++l) {
                        for (std::size_t q = 0; q < most_outputs; ++q) {
                            sum[q] +=
                                in_u[k][i] * in_v[l][j] * f.coefficients[k * height + l][q];
                        }
                    }
                }
                for (std::size_t q = 0; q < static_cast<std::size_t>(shape_.outputs); ++q) {
                    writer_.signed_number(std::round(sum[q] / f.units[q]));
                }
            }
        }
    }
}

}  // namespace batten::patches
