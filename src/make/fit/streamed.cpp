#include <algorithm>
#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_chunks.hpp"
#include "make/fit/finish.hpp"
#include "make/fit/growth.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/tally.hpp"

namespace batten {
namespace {

using namespace fitting;

void require_fixed_knots(const FitOptions& options) {
    const KnotPlacement placement = placement_of(options);
    const bool is_equal = placement == KnotPlacement::equal && options.intervals;
    if (placement == KnotPlacement::given || is_equal) return;
    throw Error("fit.streamed", "knots", std::string(name_of(placement)),
                "samples read in blocks take given knots, or equal ones with intervals: search for "
                "them on some of the samples");
}

/// What knots cannot be placed without.
struct Span {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    bool has_column = false;
};

Span span_of(const FitStream& stream, const Progress& progress) {
    Span span;
    stream.read(progress, [&](const FitSamples& samples) {
        for (const double x : samples.x) {
            span.lo = std::min(span.lo, x);
            span.hi = std::max(span.hi, x);
        }
        span.has_column = span.has_column || !samples.sigma.empty();
    });
    if (!(span.lo < span.hi)) {
        throw Error(span.lo > span.hi ? "fit.too-few" : "fit.x-equal", "x",
                    span.lo > span.hi ? "none" : format_number(span.lo),
                    "there must be at least two different abscissae");
    }
    return span;
}

std::vector<double> knots_inside(const Span& span, const FitOptions& options) {
    const Interval range{span.lo, span.hi};
    if (placement_of(options) == KnotPlacement::given) {
        return inner_knots(options.knots_values, range);
    }
    std::vector<double> breaks = equal_breaks(range, static_cast<std::size_t>(*options.intervals));
    return {breaks.begin() + 1, breaks.end() - 1};
}

/// What blocks leave: psi as counts.
struct Left {
    Psi within{};
    double largest = 0;
};

void add_left(Left& left, const FitSamples& given, const SplineFunction& spline,
              const FitOptions& options) {
    const Samples samples = prepared_part(given, options, spline.domain());
    if (samples.size() == 0) return;
    const ResidualTally block = tally(samples, spline);
    left.largest = std::max(left.largest, block.max_residual);
    for (std::size_t w = 0; w < left.within.size(); ++w) {
        left.within[w] += std::round(block.psi[w] * static_cast<double>(samples.size()));
    }
}

}  // namespace

Fit fit(const FitStream& stream, const FitOptions& options) {
    require_options(options);
    require_fixed_knots(options);
    const Progress& progress = options.progress;
    const Span span = span_of(stream, progress.stage(0, 0.3));
    if (!span.has_column && !options.sigma) {
        throw Error("fit.streamed", "sigma", "not given",
                    "samples read in blocks have known errors: sigma, or a column");
    }
    FitOptions each = options;
    each.progress = {};
    FitChunk chunk({span.lo, span.hi}, knots_inside(span, options), options.degree);
    stream.read(progress.stage(0.3, 0.65), [&](const FitSamples& samples) {
        chunk.add(samples, options.sigma.value_or(1));
    });
    Fit made = chunk.solve();
    Left left;
    stream.read(progress.stage(0.65, 1), [&](const FitSamples& samples) {
        add_left(left, samples, made.spline, each);
    });
    made.report.max_residual = left.largest;
    for (const double count : left.within) {
        made.report.psi.push_back(count / static_cast<double>(chunk.samples()));
    }
    if (!span.has_column) {
        made.report.sigma_source = SigmaSource::number;
        made.report.sigma = options.sigma;
    }
    return made;
}

}  // namespace batten
