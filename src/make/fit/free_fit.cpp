#include "make/fit/free_fit.hpp"

#include <algorithm>
#include <limits>

#include "num/cox_de_boor.hpp"

namespace batten::fitting {

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

FreeFit::FreeFit(const Samples& samples, const LocalBasis& basis)
    : samples_(samples),
      basis_(basis),
      reduced_(samples, basis),
      system_(basis, reduced_.shape(), Ends::open) {}

bool FreeFit::set_knots(const KnotSet& set) {
    const int k = order();
    knots_ = open_knots(domain(), set.flat(), k);
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
        add_cells(knots_, k, spans_[i], samples_, rows, cells_);
        const double* const t = reduced_.triangle(span, rows, end);
        std::copy_n(t, reduced_.shape().size(), triangles_.data() + i * reduced_.shape().size());
        firsts_[i] = static_cast<int>(spans_[i]) - k + 1;
        rests_[i] = t[reduced_.shape().rest()];
        rest_ += rests_[i];
    }
    const int functions = static_cast<int>(knots_.size()) - k;
    if (rank_of(cells_, functions) < functions) return false;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        system_.make_block(knots_, spans_[i], triangles_.data() + i * reduced_.shape().size(),
                           blocks_.data() + i * system_.block_size());
    }
    system_.solve(functions, firsts_, blocks_);
    return true;
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

/// dS/dt_l on every span, as rows of the reduced problem (R times Chebyshev coefficients), for
/// the knot with index l: out[span * order + row].
void FreeFit::make_slopes(std::size_t l, double* out) {
    const int k = order(), width = reduced_.shape().width();
    const std::span<const double> c = system_.coefficients(0);
    longer_ = knots_;
    longer_.insert(longer_.begin() + static_cast<std::ptrdiff_t>(l), knots_[l]);
    std::fill(out, out + spans_.size() * static_cast<std::size_t>(k), 0.0);
    const int first = static_cast<int>(l) - k + 1, last = static_cast<int>(l);
    double d[num::most_order], x[num::most_order], q[num::most_order];
    double values[num::most_order * num::most_order] = {}, b[num::most_order * num::most_order];
    for (int i = first; i <= last; ++i) {
        const double before = i > 0 ? c[static_cast<std::size_t>(i - 1)] : 0;
        const double here = i < static_cast<int>(c.size()) ? c[static_cast<std::size_t>(i)] : 0;
        const double gap = knots_[static_cast<std::size_t>(i + k - 1)] -
                           knots_[static_cast<std::size_t>(i)];
        d[i - first] = gap > 0 ? (before - here) / gap : 0;
    }
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
        for (int a = 0; a < k; ++a) {
            q[a] = 0;
            for (int j = 0; j < k; ++j) {
                const int f = lowest + j - first;
                if (f >= 0 && f < k) q[a] += b[a * k + j] * d[f];
            }
        }
        const double* const r = triangles_.data() + s * reduced_.shape().size();
        for (int i = 0; i < k; ++i) {
            double sum = 0;
            for (int a = i; a < k; ++a) sum += r[i * width + a] * q[a];
            out[s * static_cast<std::size_t>(k) + static_cast<std::size_t>(i)] = sum;
        }
    }
}

double FreeFit::gradient(const KnotSet& set, std::vector<double>& g) {
    const double j = value(set);
    g.assign(set.size(), 0.0);
    if (!(j < std::numeric_limits<double>::infinity())) return j;
    const std::size_t k = static_cast<std::size_t>(order());
    const int width = reduced_.shape().width();
    slopes_.resize(set.size() * spans_.size() * k);
    std::size_t l = k;
    for (std::size_t v = 0; v < set.size(); ++v) {
        double* const slope = slopes_.data() + v * spans_.size() * k;
        // A knot that stands several times moves as one: the derivatives add up, and are equal.
        make_slopes(l, slope);
        for (std::size_t i = 0; i < spans_.size() * k; ++i) slope[i] *= set.times[v];
        l += static_cast<std::size_t>(set.times[v]);
        double sum = 0;
        for (std::size_t s = 0; s < spans_.size(); ++s) {
            const double* const block = blocks_.data() + s * system_.block_size();
            const double* const c = system_.coefficients(0).data() + firsts_[s];
            for (std::size_t i = 0; i < k; ++i) {
                const double* const row = block + i * static_cast<std::size_t>(width);
                double rest = row[k];
                for (std::size_t a = 0; a < k; ++a) rest -= row[a] * c[a];
                sum += rest * slope[s * k + i];
            }
        }
        g[v] = -2 * sum;
    }
    return j;
}

double FreeFit::normal_matrix(const KnotSet& set, std::vector<double>& g,
                              std::vector<double>& matrix) {
    const double j = gradient(set, g);
    const int m = static_cast<int>(set.size()), k = order();
    matrix.assign(set.size() * set.size(), 0.0);
    if (m == 0 || !(j < std::numeric_limits<double>::infinity())) return j;
    slopes_qr_.restart({k, static_cast<int>(knots_.size()) - k, 0, m});
    rows_.resize(static_cast<std::size_t>(k * (k + m)));
    for (std::size_t s = 0; s < spans_.size(); ++s) {
        const double* const block = blocks_.data() + s * system_.block_size();
        for (int i = 0; i < k; ++i) {
            double* const row = rows_.data() + i * (k + m);
            std::copy_n(block + i * reduced_.shape().width(), k, row);
            for (int v = 0; v < m; ++v) {
                row[k + v] = slopes_[(static_cast<std::size_t>(v) * spans_.size() + s) *
                                         static_cast<std::size_t>(k) +
                                     static_cast<std::size_t>(i)];
            }
        }
        slopes_qr_.absorb(firsts_[s], rows_.data(), k);
    }
    slopes_qr_.finish();
    const std::span<const double> products = slopes_qr_.residual_products();
    std::copy(products.begin(), products.end(), matrix.begin());
    return j;
}

}  // namespace batten::fitting
