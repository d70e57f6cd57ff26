#include "make/fair/request.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fair/smooth.hpp"

namespace batten::fairing {
namespace {

constexpr std::size_t fewest_points = 5;
/// Of the extent: what rounding leaves of points in a straight line, and of exact data's noise.
constexpr double straight = 1e-13, least_sigma = 1e-9;

/// An option of one engine, or of space, is refused with the other: it would be ignored.
void require_its_use(const FairOptions& o, int dim) {
    const FairOptions usual;
    const auto refuse_if = [](bool is_idle, const char* name, const char* value,
                              const char* rule) {
        if (is_idle) throw Error("fair.options", name, value, rule);
    };
    const auto filter_only = [&](bool is_given, const char* name) {
        refuse_if(is_given && o.engine != FairEngine::filter, name, "with engine gauss-newton",
                  "goes with engine filter only");
    };
    filter_only(o.sweeps != usual.sweeps, "sweeps");
    filter_only(o.window != usual.window, "window");
    filter_only(o.spacing != usual.spacing, "spacing");
    filter_only(o.split, "split");
    refuse_if(o.lambda && o.engine == FairEngine::filter, "lambda", "with engine filter",
              "goes with engine gauss-newton only");
    refuse_if(o.beta != usual.beta && dim == 2, "beta", "in the plane",
              "torsion is for points in space");
}

void require_options(const FairOptions& o) {
    const auto require = [](bool is_good, const char* name, double value, const char* rule) {
        if (!is_good) throw Error("option.range", name, format_number(value), rule);
    };
    const double alpha = o.alpha.value.value_or(-1);
    require(std::fabs(alpha) <= 20, "alpha", alpha, "must be at least -20 and at most 20");
    require(std::fabs(o.beta) <= 20, "beta", o.beta, "must be at least -20 and at most 20");
    const auto require_positive = [&](std::optional<double> value, const char* name) {
        if (value) require(*value > 0 && std::isfinite(*value), name, *value, "must be above 0");
    };
    require_positive(o.sigma, "sigma");
    require_positive(o.lambda, "lambda");
    if (o.tolerance) {
        const double value = o.tolerance->value;
        require(value > 0 && std::isfinite(value), "tolerance", value, "must be above 0");
    }
    require(o.sweeps >= 1, "sweeps", o.sweeps, "must be at least 1");
    require(o.window >= 1, "window", o.window, "must be at least 1");
    if (o.closed && o.fix_ends != FixEnds::none) {
        throw Error("fair.closed-has-no-ends", "fix_ends", std::string(name_of(o.fix_ends)),
                    "a closed row of points has no ends to fix");
    }
}

Track working(PointsView points, double unit, bool closed) {
    Track track;
    track.closed = closed;
    for (std::size_t i = 0; i < points.size(); ++i) {
        track.x.push_back((points(i, 0) - points(0, 0)) / unit);
        track.y.push_back((points(i, 1) - points(0, 1)) / unit);
    }
    return track;
}

/// Whether all points lie on the line through the first and the one furthest from it.
bool is_straight(const Track& t) {
    if (t.x.empty()) return true;
    std::size_t far = 0;
    const auto reach = [&](std::size_t i) { return std::hypot(t.x[i], t.y[i]); };
    for (std::size_t i = 1; i < t.size(); ++i) {
        if (reach(i) > reach(far)) far = i;
    }
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double off = t.x[far] * t.y[i] - t.y[far] * t.x[i];
        if (std::fabs(off) > straight * reach(far)) return false;
    }
    return true;
}

}  // namespace

Request checked(PointsView points, const FairOptions& options) {
    require_options(options);
    require_dimension(points, 2, 3);
    require_its_use(options, points.dim());
    require_count(points, fewest_points);
    require_finite(points);
    const bool repeats = options.closed && points.size() > fewest_points &&
                         std::equal(points[0].begin(), points[0].end(),
                                    points[points.size() - 1].begin());
    Request request;
    if (repeats) {
        points = points.part(0, points.size() - 1);
        request.notes.push_back("the last point repeats the first of the closed row: it follows it");
    }
    require_distinct(points, options.closed);
    const double size = extent(points);
    if (!std::isfinite(size)) {
        throw Error("number.overflow", "points", "extent", "must lie within a double");
    }
    request.unit = std::scalbn(1.0, std::ilogb(size));
    request.data = working(points, request.unit, options.closed);
    if (points.dim() == 3) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            request.z.push_back((points(i, 2) - points(0, 2)) / request.unit);
        }
    }
    request.held_ends = static_cast<std::size_t>(options.fix_ends);
    request.is_straight = is_straight(request.data) && is_straight({request.z, request.data.x});
    const double given = options.tolerance ? options.tolerance->in_units(size) : 0;
    if (options.sigma && given > 0 && given < *options.sigma) {
        throw Error("fair.tolerance-below-sigma", "tolerance", format_number(given),
                    "must not be below sigma, " + format_number(*options.sigma));
    }
    request.bound = given / request.unit;
    if (options.sigma) {
        request.sigma = *options.sigma / request.unit;
    } else {
        request.sigma = std::fmax(noise_of(request.data), least_sigma);
        if (points.dim() == 3) {
            request.sigma = std::fmax(request.sigma, noise_of({request.z, request.data.x}));
        }
        if (request.bound > 0) request.sigma = std::fmin(request.sigma, request.bound / 2);
        request.notes.push_back("sigma is estimated from what cubics over six points at a time leave");
    }
    if (options.lambda) request.lambda = *options.lambda / std::pow(request.unit, 5);
    return request;
}

std::optional<double> in_data_units(double lambda, const Request& request) {
    const double result = lambda * std::pow(request.unit, 5);
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace batten::fairing
