#include "make/fit/free_fit.hpp"

#include <algorithm>
#include <limits>

#include "make/fit/interval_rows.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

/// Scaled pivots of a closed spline's triangle below are taken as rank deficiency.
constexpr double least_free_pivot = 1e-6;
/// Of the largest column: a function that is smaller at all samples is known from its tail alone.
constexpr double least_column = 1e-2;

}  // namespace

int KnotSet::count() const {
    int sum = 0;
    for (const int t : times) sum += t;
    return sum;
}

std::vector<double> KnotSet::flat() const {
    std::vector<double> result;
    for (std::size_t j = 0; j < at.size(); ++j) {
        result.insert(result.end(), static_cast<std::size_t>(times[j]), at[j]);
    }
    return result;
}

KnotSet KnotSet::of(std::span<const double> knots, Interval range) {
    KnotSet set;
    for (const double t : knots) {
        if (!(t > range.lo && t < range.hi)) continue;
        if (!set.at.empty() && set.at.back() == t) {
            ++set.times.back();
        } else {
            set.at.push_back(t);
            set.times.push_back(1);
        }
    }
    return set;
}

FreeFit::FreeFit(const Samples& samples, const LocalBasis& basis, Ends ends)
    : samples_(samples),
      basis_(basis),
      reduced_(samples, basis),
      ends_(ends),
      system_(basis, reduced_.shape(), ends),
      slopes_system_(basis, reduced_.shape(), ends) {}

int FreeFit::most_times() const {
    return sides() == 1 && ends_ == Ends::open ? order() : order() - 1;
}

std::vector<double> FreeFit::knots_of(const KnotSet& set) const {
    const std::vector<double> inside = set.flat();
    if (ends_ == Ends::open) return open_knots(domain(), inside, order());
    std::vector<double> breaks{domain().lo};
    breaks.insert(breaks.end(), inside.begin(), inside.end());
    breaks.push_back(domain().hi);
    return closed_knots(breaks, order());
}

int FreeFit::functions_of(const KnotSet& set) const {
    return set.count() + (ends_ == Ends::open ? order() : 1);
}

int FreeFit::parameters_of(const KnotSet& set) const {
    return functions_of(set) * static_cast<int>(samples_.directions());
}

bool FreeFit::set_knots(const KnotSet& set) {
    const int k = order();
    const int functions = functions_of(set);
    if (static_cast<std::size_t>(functions) > samples_.size()) return false;
    knots_ = knots_of(set);
    spans_ = spans_of(knots_, k);
    firsts_.resize(spans_.size());
    triangles_.resize(spans_.size() * reduced_.shape().size());
    blocks_.resize(spans_.size() * system_.block_size());
    cells_.clear();
    rest_ = 0;
    rests_.resize(spans_.size());
    Rows left{0, samples_.size()};
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const Interval span{knots_[spans_[i]], knots_[spans_[i] + 1]};
        const RightEnd end = i + 1 == spans_.size() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples_, left, span, end);
        left.first = rows.last;
        if (ends_ == Ends::open) add_cells(knots_, k, spans_[i], samples_, rows, cells_);
        const double* const t = reduced_.triangle(span, rows, end);
        std::copy_n(t, reduced_.shape().size(), triangles_.data() + i * reduced_.shape().size());
        firsts_[i] = static_cast<int>(spans_[i]) - k + 1;
        rests_[i] = t[reduced_.shape().rest()];
        rest_ += rests_[i];
    }
    if (ends_ == Ends::open && rank_of(cells_, functions) < functions) return false;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        system_.make_block(knots_, spans_[i], triangles_.data() + i * reduced_.shape().size(),
                           blocks_.data() + i * system_.block_size());
    }
    system_.solve(functions, firsts_, blocks_);
    return is_determined(functions);
}

bool FreeFit::is_determined(int functions) {
    if (ends_ == Ends::open && sides() == 1) return true;
    double largest = 0, least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < functions; ++j) {
        if (!(system_.qr().scaled_pivot(j) > least_free_pivot)) return false;
        largest = std::max(largest, system_.qr().column_sq(j));
        least = std::min(least, system_.qr().column_sq(j));
    }
    return least > least_column * least_column * largest;
}

double FreeFit::value(const KnotSet& set) {
    samples_.work.step();
    if (!set_knots(set)) return std::numeric_limits<double>::infinity();
    double sum = 0;
    part_sums_.resize(spans_.size());
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        part_sums_[i] = rests_[i] + system_.squared_rest(firsts_[i],
                                                         blocks_.data() + i * system_.block_size());
        sum += part_sums_[i];
    }
    return sum;
}

/// What is beyond the ends of a closed spline's list has no part in the domain: 0 there.
void FreeFit::make_falls(std::size_t l) {
    const int k = order(), first = static_cast<int>(l) - k + 1, last = static_cast<int>(l);
    falls_.assign(sides() * static_cast<std::size_t>(k), 0.0);
    for (std::size_t side = 0; side < sides(); ++side) {
        const std::span<const double> c = system_.coefficients(static_cast<int>(side));
        const int stored = static_cast<int>(c.size());
        for (int i = std::max(first, 0); i <= std::min(last, stored); ++i) {
            const double before = i > 0 ? c[static_cast<std::size_t>(i - 1)] : 0;
            const double here = i < stored ? c[static_cast<std::size_t>(i)] : 0;
            const double gap = knots_[static_cast<std::size_t>(i + k - 1)] -
                               knots_[static_cast<std::size_t>(i)];
            falls_[side * static_cast<std::size_t>(k) + static_cast<std::size_t>(i - first)] =
                gap > 0 ? (before - here) / gap : 0;
        }
    }
}

/// Adds dS/dt_l on every span, as rows of the reduced problem (R times Chebyshev coefficients), for
/// the knot with index l and every side to the slopes of place v of m.
void FreeFit::add_slopes(std::size_t l, std::size_t v, std::size_t m) {
    const int k = order(), width = reduced_.shape().width();
    longer_ = knots_;
    longer_.insert(longer_.begin() + static_cast<std::ptrdiff_t>(l), knots_[l]);
    make_falls(l);
    const int first = static_cast<int>(l) - k + 1, last = static_cast<int>(l);
    double x[num::most_order], q[num::most_order];
    double values[num::most_order * num::most_order] = {}, b[num::most_order * num::most_order];
    for (std::size_t s = 0; s < spans_.size(); ++s) {
        const std::size_t span = spans_[s] >= l ? spans_[s] + 1 : spans_[s];
        const int lowest = static_cast<int>(span) - k + 1;
        if (lowest > last || static_cast<int>(span) < first) continue;
        const double half = 0.5 * (longer_[span + 1] - longer_[span]);
        for (int i = 0; i < k; ++i) {
            x[i] = longer_[span] + half + half * basis_.nodes()[static_cast<std::size_t>(i)];
        }
        num::basis_values_at(longer_, span, k, x, k, values);
        basis_.coefficients(values, k, b);
        const double* const r = triangles_.data() + s * reduced_.shape().size();
        for (std::size_t side = 0; side < sides(); ++side) {
            const double* const d = falls_.data() + side * static_cast<std::size_t>(k);
            for (int a = 0; a < k; ++a) {
                q[a] = 0;
                for (int j = 0; j < k; ++j) {
                    const int f = lowest + j - first;
                    if (f >= 0 && f < k) q[a] += b[a * k + j] * d[f];
                }
            }
            double* const out = slopes_of(side, v, m) + s * static_cast<std::size_t>(k);
            for (int i = 0; i < k; ++i) {
                double sum = 0;
                for (int a = i; a < k; ++a) sum += r[i * width + a] * q[a];
                out[i] += sum;
            }
        }
    }
}

/// By every place and side; all copies of a closed spline's knot move with it.
void FreeFit::make_all_slopes(const KnotSet& set) {
    const std::size_t k = static_cast<std::size_t>(order()), m = set.size();
    const std::size_t turn = ends_ == Ends::open ? knots_.size()
                                                 : static_cast<std::size_t>(functions_of(set));
    slopes_.assign(sides() * m * slope_size(), 0.0);
    std::size_t l = k;
    for (std::size_t v = 0; v < m; ++v) {
        for (std::size_t copy = l % turn; copy < knots_.size(); copy += turn) {
            add_slopes(copy, v, m);
        }
        // A knot that stands several times moves as one: the derivatives add up, and are equal.
        for (std::size_t side = 0; side < sides() && set.times[v] > 1; ++side) {
            double* const slope = slopes_of(side, v, m);
            for (std::size_t i = 0; i < slope_size(); ++i) slope[i] *= set.times[v];
        }
        l += static_cast<std::size_t>(set.times[v]);
    }
}

double FreeFit::gradient(const KnotSet& set, std::vector<double>& g) {
    const double j = value(set);
    g.assign(set.size(), 0.0);
    if (!(j < std::numeric_limits<double>::infinity())) return j;
    const std::size_t k = static_cast<std::size_t>(order());
    const std::size_t width = static_cast<std::size_t>(reduced_.shape().width());
    make_all_slopes(set);
    for (std::size_t side = 0; side < sides(); ++side) {
        for (std::size_t s = 0; s < spans_.size(); ++s) {
            const double* const block = blocks_.data() + s * system_.block_size();
            const double* const c =
                system_.coefficients(static_cast<int>(side)).data() + firsts_[s];
            for (std::size_t i = 0; i < k; ++i) {
                const double* const row = block + i * width;
                double rest = row[k + side];
                for (std::size_t a = 0; a < k; ++a) rest -= row[a] * c[a];
                for (std::size_t v = 0; v < set.size(); ++v) {
                    g[v] -= 2 * rest * slopes_of(side, v, set.size())[s * k + i];
                }
            }
        }
    }
    return j;
}

double FreeFit::normal_matrix(const KnotSet& set, std::vector<double>& g,
                              std::vector<double>& matrix) {
    const double j = gradient(set, g);
    const std::size_t m = set.size(), k = static_cast<std::size_t>(order());
    matrix.assign(m * m, 0.0);
    if (m == 0 || !(j < std::numeric_limits<double>::infinity())) return j;
    const std::size_t width = static_cast<std::size_t>(reduced_.shape().width());
    slopes_system_.set_sides(static_cast<int>(m));
    rows_.resize(spans_.size() * k * (k + m));
    for (std::size_t side = 0; side < sides(); ++side) {
        for (std::size_t s = 0; s < spans_.size(); ++s) {
            const double* const block = blocks_.data() + s * system_.block_size();
            for (std::size_t i = 0; i < k; ++i) {
                double* const row = rows_.data() + (s * k + i) * (k + m);
                std::copy_n(block + i * width, k, row);
                for (std::size_t v = 0; v < m; ++v) {
                    row[k + v] = slopes_of(side, v, m)[s * k + i];
                }
            }
        }
        slopes_system_.factor(functions_of(set), firsts_, rows_);
        const std::span<const double> products = slopes_system_.qr().residual_products();
        for (std::size_t i = 0; i < m * m; ++i) matrix[i] += products[i];
    }
    return j;
}

}  // namespace batten::fitting
