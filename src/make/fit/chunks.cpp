#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_chunks.hpp"
#include "make/fit/finish.hpp"
#include "make/fit/interval_rows.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/whitney.hpp"

namespace batten {
namespace {

using namespace fitting;

/// A stand-in for samples where there are only triangles.
Samples no_samples() {
    Samples none;
    none.sides.resize(1);
    return none;
}

}  // namespace

FitChunk::FitChunk(Interval domain, std::vector<double> interior_knots, int degree)
    : degree_(degree) {
    FitOptions options;
    options.degree = degree;
    require_options(options);
    if (!(domain.lo < domain.hi) || !std::isfinite(domain.length())) {
        throw Error("fit.knots", "domain", format_number(domain.lo), "must have positive length");
    }
    require_inner_knots(interior_knots, domain, degree);
    knots_ = open_knots(domain, interior_knots, degree + 1);
    const TriangleShape shape{degree + 1, 1};
    const std::size_t spans = spans_of(knots_, degree + 1).size();
    triangles_.assign(spans * shape.size(), 0.0);
    places_.resize(spans);
}

void FitChunk::add(const FitSamples& given, double sigma) {
    FitOptions options;
    options.sigma = sigma;
    const Interval domain{knots_.front(), knots_.back()};
    const Samples samples = prepared_part(given, options, domain);
    if (samples.size() == 0) return;
    for (const double x : {samples.range.lo, samples.range.hi}) {
        if (domain.contains(x)) continue;
        throw Error("fit.outside", "x", format_number(x), "must lie in the knots' domain");
    }
    const LocalBasis basis(degree_ + 1);
    const Reducer reducer(samples, basis);
    const std::size_t size = reducer.shape().size();
    std::vector<double> fresh(size);
    const std::vector<std::size_t> spans = spans_of(knots_, degree_ + 1);
    Rows rest{0, samples.size()};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Interval span{knots_[spans[i]], knots_[spans[i] + 1]};
        const RightEnd end = i + 1 == spans.size() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples, rest, span, end);
        rest.first = rows.last;
        if (rows.count() == 0) continue;
        reducer.reduce(rows, span, Rest::wanted, fresh.data());
        reducer.merge(fresh.data(), span, span, triangles_.data() + i * size);
        remember_places(places_[i], samples.x.subspan(rows.first, rows.count()), span,
                        static_cast<std::size_t>(degree_) + 1);
    }
    samples_ += samples.size();
}

void FitChunk::merge(const FitChunk& other) {
    if (other.knots_ != knots_ || other.degree_ != degree_) {
        throw Error("fit.chunks-differ", "knots", std::to_string(other.knots_.size()),
                    "chunks must have the same knots and degree");
    }
    const LocalBasis basis(degree_ + 1);
    const Samples none = no_samples();
    const Reducer reducer(none, basis);
    const std::size_t size = reducer.shape().size();
    const std::vector<std::size_t> spans = spans_of(knots_, degree_ + 1);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Interval span{knots_[spans[i]], knots_[spans[i] + 1]};
        reducer.merge(other.triangles_.data() + i * size, span, span, triangles_.data() + i * size);
        remember_places(places_[i], other.places_[i], span,
                        static_cast<std::size_t>(degree_) + 1);
    }
    samples_ += other.samples_;
}

Fit FitChunk::solve() const {
    const LocalBasis basis(degree_ + 1);
    const TriangleShape shape{degree_ + 1, 1};
    const std::vector<std::size_t> spans = spans_of(knots_, degree_ + 1);
    require_enough(samples_, knots_.size() - static_cast<std::size_t>(degree_) - 1);
    Samples places;
    std::vector<double> x;
    for (const auto& list : places_) x.insert(x.end(), list.begin(), list.end());
    places.x = x;
    const std::vector<Cell> cells = cells_of(knots_, degree_ + 1, places);
    const FixedFit fixed = solve_from(knots_, basis, shape, Ends::open, triangles_, cells);
    double delta2 = 0;
    std::vector<double> block(fixed.system.block_size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const double* const triangle = triangles_.data() + i * shape.size();
        fixed.system.make_block(knots_, spans[i], triangle, block.data());
        delta2 += triangle[shape.rest()] +
                  fixed.system.squared_rest(static_cast<int>(spans[i]) - degree_, block.data());
    }
    FitReport report;
    SplineFunction spline = spline_of(fixed);
    fill_criteria(report, fixed, {delta2, samples_, SigmaKnowledge::known});
    fill_spline(report, spline);
    report.sigma_source = SigmaSource::column;
    const FitCovariance covariance(std::make_shared<FitCovariance::Model>(
        FitCovariance::Model{CoefficientLaw(spline, fixed.system), {}, {}}));
    if (report.undetermined.empty()) fill_band(report, spline, covariance);
    return {std::move(spline), covariance, std::move(report)};
}

}  // namespace batten
