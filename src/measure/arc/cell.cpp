#include "measure/arc/cell.hpp"

#include <algorithm>
#include <cmath>

#include "measure/arc/series.hpp"
#include "num/gauss.hpp"

namespace batten::arc {
namespace {

constexpr int most_newton_steps = 8;
constexpr double newton_done = 0x1p-44;  // of the cell; the step after it is below rounding

/// A stretch with its hodograph in the Chebyshev basis of x = 2 w - 1.
struct Path {
    int dim = 0, zeros_lo = 0, zeros_hi = 0;
    std::size_t terms = 0;  ///< of each coordinate of p
    bernstein::Coefficients p;
};

template <std::size_t N>
BATTEN_INLINE void speeds(const Path& path, const double* w, double* out) {
    Values<N> x, value, sum{};
    for (std::size_t i = 0; i < N; ++i) x[i] = 2 * w[i] - 1;
    for (int k = 0; k < path.dim; ++k) {
        sums_at<N>(path.p.data() + static_cast<std::size_t>(k) * path.terms, path.terms, x, value);
        for (std::size_t i = 0; i < N; ++i) sum[i] += value[i] * value[i];
    }
    for (std::size_t i = 0; i < N; ++i) sum[i] = std::sqrt(sum[i]);
    for (int zero = 0; zero < path.zeros_lo; ++zero) {
        for (std::size_t i = 0; i < N; ++i) sum[i] *= w[i];
    }
    for (int zero = 0; zero < path.zeros_hi; ++zero) {
        for (std::size_t i = 0; i < N; ++i) sum[i] *= 1 - w[i];
    }
    for (std::size_t i = 0; i < N; ++i) out[i] = sum[i];
}

BATTEN_CLONES void all_speeds(const Path& path, std::span<const double> w,
                                  std::span<double> out) {
    std::size_t i = 0;
    for (; i + 8 <= w.size(); i += 8) speeds<8>(path, &w[i], &out[i]);
    for (; i < w.size(); ++i) speeds<1>(path, &w[i], &out[i]);
}

double last_three(const double* c, std::size_t terms) {
    return std::fabs(c[terms - 1]) + std::fabs(c[terms - 2]) + std::fabs(c[terms - 3]);
}

/// The sum's first terms, as many as leave out no more than `allowed`.
std::size_t terms_needed(const double* c, std::size_t terms, double allowed) {
    double left_out = 0;
    while (terms > 2) {
        left_out += std::fabs(c[terms - 1]);
        if (left_out > allowed) break;
        --terms;
    }
    return terms;
}

/// The integral from -1, whose sum over k T_k(x) has one term more: the last is left out.
template <std::size_t N>
BATTEN_INLINE void integrate(const Values<N>& c, double half, Values<N>& out) {
    double start = 0, sign = 1;  // the sum of (-1)^(k + 1) out[k]
    for (std::size_t k = 1; k < N; ++k) {
        const double before = k == 1 ? 2 * c[0] : c[k - 1];
        const double after = k + 1 < N ? c[k + 1] : 0;
        out[k] = half * (before - after) / (2 * static_cast<double>(k));
        start += sign * out[k];
        sign = -sign;
    }
    out[0] = start;
}

template <std::size_t N>
double length_of(const Values<N>& integral) {
    double sum = 0;
    for (std::size_t k = N / 2; k-- > 0;) sum += integral[2 * k + 1];
    return 2 * sum;
}

/// x with integral(x) = length (1 + sigma) / 2 for every node sigma; whether Newton got there.
template <std::size_t N>
BATTEN_INLINE bool invert(const Values<N>& integral, const Values<N>& speed, double half,
                              double length, const Nodes<N>& nodes, Values<N>& x) {
    Values<N> s, v;
    x = nodes.at;
    for (int step = 0; step < most_newton_steps; ++step) {
        sums_at<N>(integral.data(), N, x, s);
        sums_at<N>(speed.data(), N, x, v);
        double largest = 0;
        for (std::size_t i = 0; i < N; ++i) {
            const double wanted = 0.5 * length * (1 + nodes.at[i]);
            double next = x[i] - (s[i] - wanted) / (half * v[i]);
            next = next > -1 ? next : -1;
            next = next < 1 ? next : 1;
            const double moved = std::fabs(next - x[i]);
            largest = largest > moved ? largest : moved;
            x[i] = next;
        }
        if (largest <= newton_done) return true;
    }
    return false;
}

/// The largest error in arc length of the inverse, between its nodes and at both ends.
template <std::size_t N>
BATTEN_INLINE double inverse_error(const Values<N>& integral, double length, double end_speed,
                                       const Values<N>& inverse, std::size_t terms,
                                       const Nodes<N>& nodes) {
    Values<N> x, s;
    sums_at<N>(inverse.data(), terms, nodes.between, x);
    sums_at<N>(integral.data(), N, x, s);
    double start = 1, sign = 1, largest = 0;
    for (std::size_t k = 0; k < terms; ++k) {
        start += sign * inverse[k];
        sign = -sign;
    }
    for (std::size_t i = 0; i < N; ++i) {
        const double error = std::fabs(s[i] - 0.5 * length * (1 + nodes.between[i]));
        largest = largest > error ? largest : error;
    }
    return std::fmax(largest, std::fabs(start) * end_speed);
}

Cell even_cell(double length, double error) {
    Cell cell;
    cell.length = length;
    cell.error = error;
    cell.forward_terms = cell.inverse_terms = 2;
    cell.forward[0] = cell.forward[1] = cell.inverse[0] = cell.inverse[1] = 0.5;
    return cell;
}

enum class Outcome { made, more_terms, halve };

/// What to do about an error with N terms that is too large: errors shrink as powers of one ratio,
/// so `most_terms` of them are worth a try where they promise enough.
template <std::size_t N>
Outcome another_try(double error, double size, double allowed) {
    const double more = static_cast<double>(most_terms - N) / static_cast<double>(N);
    const bool promises = error * std::pow(error / size, more) <= allowed;
    return N < most_terms && promises ? Outcome::more_terms : Outcome::halve;
}

template <std::size_t N>
BATTEN_INLINE Outcome make(const Rate& rate, Interval part, const Allowed& allowed,
                               Cell& out) {
    const Nodes<N>& table = nodes<N>();
    const double half = 0.5 * part.length();
    Values<N> w, speed, c, integral, x, inverse;
    for (std::size_t i = 0; i < N; ++i) w[i] = part.middle() + half * table.at[i];
    rate(w, speed);
    double fastest = 0;
    for (std::size_t i = 0; i < N; ++i) fastest = fastest > speed[i] ? fastest : speed[i];
    coefficients_of<N>(table, speed, c);
    const double error = 2 * half * last_three(c.data(), N);
    const bool is_short = 4 * half * fastest <= std::fmin(allowed.length, allowed.place);
    if (!is_short && !(error <= allowed.length)) {
        return another_try<N>(error, half * fastest, allowed.length);
    }
    integrate<N>(c, half, integral);
    const double length = length_of<N>(integral);
    if (is_short) {
        out = even_cell(std::fmax(length, 0), error);
        return Outcome::made;
    }
    if (!invert<N>(integral, c, half, length, table, x)) return Outcome::halve;
    coefficients_of<N>(table, x, inverse);
    const std::size_t terms =
        terms_needed(inverse.data(), N, 0.25 * allowed.place / (half * fastest));
    const double wrong =
        inverse_error<N>(integral, length, half * fastest, inverse, terms, table);
    if (!(wrong <= allowed.place)) return another_try<N>(wrong, length, allowed.place);
    out.length = length;
    out.error = error;
    out.forward_terms = terms_needed(integral.data(), N, 0.25 * allowed.length);
    out.inverse_terms = terms;
    for (std::size_t k = 0; k < N; ++k) {
        out.forward[k] = integral[k] / length;
        out.inverse[k] = 0.5 * inverse[k];
    }
    out.inverse[0] += 0.5;
    return Outcome::made;
}

BATTEN_CLONES Outcome make_16(const Rate& rate, Interval part, const Allowed& allowed,
                                  Cell& out) {
    return make<16>(rate, part, allowed, out);
}

BATTEN_CLONES Outcome make_24(const Rate& rate, Interval part, const Allowed& allowed,
                                  Cell& out) {
    return make<24>(rate, part, allowed, out);
}

}  // namespace

Rate speed_of(const bezier::Stretch& stretch, const std::vector<chebyshev::Basis>& bases) {
    Path path{stretch.dim, stretch.zeros_lo, stretch.zeros_hi, stretch.count(),
              bernstein::Coefficients(stretch.p.size())};
    for (int k = 0; k < stretch.dim; ++k) {
        bases[stretch.degree()].from_bernstein(
            stretch.coordinate(k), path.p.data() + static_cast<std::size_t>(k) * path.terms);
    }
    return [path](std::span<const double> w, std::span<double> out) { all_speeds(path, w, out); };
}

std::optional<Cell> cell_over(const Rate& rate, Interval part, const Allowed& allowed) {
    Cell cell;
    Outcome outcome = make_16(rate, part, allowed, cell);
    if (outcome == Outcome::more_terms) outcome = make_24(rate, part, allowed, cell);
    if (outcome != Outcome::made) return std::nullopt;
    return cell;
}

Cell even_cell_over(const Rate& rate, Interval part) {
    const auto at = [&](double w) {
        double value;
        rate({&w, 1}, {&value, 1});
        return value;
    };
    return even_cell(num::integrate(at, part, num::gauss_legendre(8)), 0);
}

}  // namespace batten::arc
