#include "make/fit/broken_fit.hpp"

#include <algorithm>
#include <limits>

#include "make/fit/interval_rows.hpp"

namespace batten::fitting {
namespace {

/// How often a site stands in the stacked knots.
int multiplicity(const BrokenSite& site, int order) {
    return site.jump ? order : site.corner ? std::max(site.times, order - 1) : site.times;
}

}  // namespace

int knots_in(const BrokenSites& sites) {
    int sum = 0;
    for (const BrokenSite& site : sites) sum += site.times;
    return sum;
}

int alone_in(const BrokenSites& sites) {
    int sum = 0;
    for (const BrokenSite& site : sites) sum += site.alone();
    return sum;
}

StackedKnots stacked(const BrokenSites& sites, Interval domain, int order) {
    StackedKnots result;
    std::vector<double> inner;
    for (const BrokenSite& site : sites) {
        const int times = multiplicity(site, order);
        inner.insert(inner.end(), static_cast<std::size_t>(times), site.at);
        for (int d = order - times; d < order - site.times; ++d) {
            const bool is_broken = (d == 0 && site.jump) || (d == 1 && site.corner);
            if (!is_broken) result.held.push_back({site.at, d});
        }
    }
    result.knots = open_knots(domain, inner, order);
    return result;
}

BrokenFit::BrokenFit(const Samples& samples, const LocalBasis& basis)
    : samples_(samples),
      basis_(basis),
      reduced_(samples, basis),
      system_(basis, reduced_.shape(), Ends::open) {}

bool BrokenFit::lay_out(const BrokenSites& sites) {
    const int k = order();
    const std::size_t ends = static_cast<std::size_t>(k);
    knots_.assign(ends, domain().lo);
    stacked_.assign(ends, domain().lo);
    breaks_.clear();
    for (const BrokenSite& site : sites) {
        knots_.insert(knots_.end(), static_cast<std::size_t>(site.times), site.at);
        stacked_.insert(stacked_.end(), static_cast<std::size_t>(multiplicity(site, k)), site.at);
        if (site.jump) breaks_.push_back({site.at, 0});
        if (site.corner) breaks_.push_back({site.at, 1});
    }
    knots_.insert(knots_.end(), ends, domain().hi);
    stacked_.insert(stacked_.end(), ends, domain().hi);
    pieces_.clear();
    cells_.clear();
    Rows left{0, samples_.size()};
    std::size_t knot = ends - 1, stacked_knot = knot;
    double lo = domain().lo;
    for (std::size_t i = 0; i <= sites.size(); ++i) {
        const bool is_last = i == sites.size();
        const Interval span{lo, is_last ? domain().hi : sites[i].at};
        const Rows rows =
            rows_in(samples_, left, span, is_last ? RightEnd::closed : RightEnd::open);
        left.first = rows.last;
        add_cells(stacked_, k, stacked_knot, samples_, rows, cells_);
        pieces_.push_back({span, rows, knot});
        if (is_last) break;
        lo = span.hi;
        knot += static_cast<std::size_t>(sites[i].times);
        stacked_knot += static_cast<std::size_t>(multiplicity(sites[i], k));
    }
    const int functions = static_cast<int>(stacked_.size()) - k;
    return rank_of(cells_, functions) == functions;
}

void BrokenFit::absorb(const Piece& piece, std::size_t index) {
    const int k = order();
    const RightEnd end = index + 1 == pieces_.size() ? RightEnd::closed : RightEnd::open;
    const double* const r = reduced_.triangle(piece.span, piece.rows, end);
    rest_ += r[reduced_.shape().rest()];
    system_.to_chebyshev(knots_, piece.knot, piece.span, map_.data());
    system_.make_block_from(map_.data(), r, block_.data());
    const int width = reduced_.shape().width(), row_width = qr_.shape().row_width();
    for (int i = 0; i < k; ++i) {
        double* const row = rows_.data() + i * row_width;
        std::copy_n(block_.data() + i * width, k, row);
        row[row_width - 1] = block_[static_cast<std::size_t>(i * width + k)];
    }
    const double half = 0.5 * piece.span.length(), middle = piece.span.lo + half;
    for (std::size_t b = 0; b < breaks_.size(); ++b) {
        const bool is_right = breaks_[b].at <= piece.span.lo, is_corner = breaks_[b].derivative == 1;
        // Chebyshev coefficients of (x - t)^d over the domain's length.
        const double unit = is_right ? (is_corner ? 1 / domain().length() : 1) : 0;
        const double c0 = is_corner ? (middle - breaks_[b].at) * unit : unit;
        const double c1 = is_corner ? half * unit : 0;
        for (int i = 0; i < k; ++i) {
            double value = i == 0 ? r[0] * c0 : 0;
            if (i < 2 && k > 1) value += r[i * width + 1] * c1;
            rows_[static_cast<std::size_t>(i * row_width + k) + b] = value;
        }
    }
    qr_.absorb(static_cast<int>(piece.knot) - k + 1, rows_.data(), k);
}

double BrokenFit::value(const BrokenSites& sites) {
    samples_.work.step();
    if (!lay_out(sites)) return std::numeric_limits<double>::infinity();
    const int k = order();
    qr_.restart({k, static_cast<int>(knots_.size()) - k, static_cast<int>(breaks_.size()), 1});
    map_.resize(static_cast<std::size_t>(k * k));
    block_.resize(system_.block_size());
    rows_.resize(static_cast<std::size_t>(k * qr_.shape().row_width()));
    rest_ = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) absorb(pieces_[i], i);
    qr_.finish();
    return rest_ + qr_.residual_products()[0];
}

}  // namespace batten::fitting
