#include "make/fit/ring_rank.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/interval_rows.hpp"
#include "make/fit/knot_system.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

constexpr double floor_of_rows = 1e-10;  // of rows of B-splines, whose sum is 1
constexpr double least_share = 1e-7;     // of a coefficient in what the samples leave open

/// Up to `most` distinct abscissae of an interval; where there are as many as its polynomials need,
/// any others say the same: then those that spread best.
std::vector<double> places_in(const Samples& samples, Rows rows, Interval span,
                              const LocalBasis& basis) {
    const std::size_t most = static_cast<std::size_t>(basis.order());
    std::vector<double> places;
    for (std::size_t r = rows.first; r < rows.last && places.size() < most; ++r) {
        if (places.empty() || samples.x[r] != places.back()) places.push_back(samples.x[r]);
    }
    if (places.size() < most) return places;
    const double half = 0.5 * span.length();
    for (std::size_t i = 0; i < most; ++i) places[i] = span.lo + half * (1 + basis.nodes()[i]);
    return places;
}

/// The rows of all intervals, one block each.
std::vector<double> unit_blocks(std::span<const double> knots, const LocalBasis& basis,
                                const Samples& samples) {
    const int k = basis.order();
    const std::vector<std::size_t> spans = spans_of(knots, k);
    const std::size_t size = static_cast<std::size_t>(k * k);
    std::vector<double> blocks(spans.size() * size, 0.0);
    Rows rest{0, samples.size()};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Interval span{knots[spans[i]], knots[spans[i] + 1]};
        const RightEnd end = i + 1 == spans.size() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples, rest, span, end);
        rest.first = rows.last;
        double* row = blocks.data() + i * size;
        for (const double x : places_in(samples, rows, span, basis)) {
            num::basis_values(knots, spans[i], k, x, row);
            row += k;
        }
    }
    return blocks;
}

/// A vector that the rows do not see, of all that they leave open a mixture.
std::vector<double> unseen(const KnotSystem& system, const std::vector<char>& is_dependent) {
    const num::BandedQr& qr = system.qr();
    const int band = qr.shape().columns, width = qr.shape().width, border = qr.shape().border;
    std::vector<double> v(is_dependent.size(), 0.0), z(v.size(), 0.0), rest(v.size());
    double share = 0;
    for (std::size_t j = 0; j < v.size(); ++j) {
        if (!is_dependent[j]) continue;
        share = std::fmod(share + 0.6180339887498949, 1.0);
        v[static_cast<std::size_t>(system.unknown(static_cast<int>(j)))] = 1 + share;
    }
    for (int j = 0; j < band; ++j) {
        double& sum = z[static_cast<std::size_t>(j)];
        for (int l = 1; l < width && j + l < band; ++l) {
            sum -= qr.row(j)[l] * v[static_cast<std::size_t>(j + l)];
        }
        for (int b = 0; b < border; ++b) {
            sum -= qr.row(j)[width + b] * v[static_cast<std::size_t>(band + b)];
        }
    }
    for (int j = 0; j < border; ++j) {
        for (int b = j + 1; b < border; ++b) {
            z[static_cast<std::size_t>(band + j)] -=
                qr.border_row(j)[b] * v[static_cast<std::size_t>(band + b)];
        }
    }
    qr.solve_for(z, rest);
    for (std::size_t j = 0; j < v.size(); ++j) v[j] += rest[j];
    return v;
}

}  // namespace

RingRank ring_rank(std::span<const double> knots, const LocalBasis& basis,
                   const Samples& samples) {
    const int order = basis.order();
    const int functions = static_cast<int>(knots.size()) - 2 * order + 1;
    std::vector<int> firsts(static_cast<std::size_t>(functions));
    for (int i = 0; i < functions; ++i) firsts[static_cast<std::size_t>(i)] = i;
    KnotSystem system(basis, {order, 0}, Ends::closed);
    system.factor(functions, firsts, unit_blocks(knots, basis, samples),
                  std::vector<double>(firsts.size(), floor_of_rows));
    RingRank result{functions, std::vector<char>(firsts.size(), 0), {}};
    for (int j = 0; j < functions; ++j) {
        if (system.qr().scaled_pivot(system.unknown(j)) > 0) continue;
        result.is_dependent[static_cast<std::size_t>(j)] = 1;
        --result.rank;
    }
    if (result.rank == functions) return result;
    const std::vector<double> v = unseen(system, result.is_dependent);
    double largest = 0;
    for (const double x : v) largest = std::max(largest, std::fabs(x));
    for (int j = 0; j < functions; ++j) {
        const double share = v[static_cast<std::size_t>(system.unknown(j))];
        if (std::fabs(share) > least_share * largest) result.undetermined.push_back(j);
    }
    return result;
}

}  // namespace batten::fitting
