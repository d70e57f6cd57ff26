#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/make/interpolate.hpp"
#include "make/sample/walk.hpp"
#include "num/roots.hpp"
#include "num/sum.hpp"

namespace batten {
namespace {

using sampling::Places;

/// Beyond this turning in a step along the tangent no root need exist: sqrt 2 - 1.
constexpr double steepest_step = 0.41421356237309503;

Points with_point_beyond(PointsView points) {
    require_count(points, 2);
    require_dimension(points, 2, 2);
    Points result(points);
    const std::size_t n = points.size();
    const std::array<double, 2> beyond{2 * points(n - 1, 0) - points(n - 2, 0),
                                       2 * points(n - 1, 1) - points(n - 2, 1)};
    result.push_back(beyond);
    return result;
}

Curve natural_spline(PointsView points) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    return curve_through(points, options);
}

/// What came of the march.
struct March {
    std::vector<double> t;  ///< raw, on the spline that reaches beyond the end
    int steps_without_root = 0, steep_steps = 0;
};

/// Steps along tangents on the spline that reaches a piece beyond the end.
class Marcher {
public:
    explicit Marcher(const Curve& spline) : spline_(spline), t_(spline.domain().lo) {}

    March through(const std::vector<double>& steps) {
        March march;
        march.t.push_back(t_);
        for (const double step : steps) {
            advance(step, march);
            march.t.push_back(t_);
        }
        return march;
    }

private:
    void advance(double rest, March& march) {
        bool is_first = true, found_root = false;
        while (true) {
            const Interval part = spline_.piece(piece_);
            const Jet jet = spline_.jet_on(piece_, t_, 3);
            if (is_first) note_steepness(jet, rest, march);
            const std::optional<double> dt = root(jet, rest);
            found_root = dt && t_ + *dt <= part.hi;
            if (found_root) {
                t_ += *dt;
                return;
            }
            // To the joint, and on with what is left. Not printed in the paper, but without it
            // every joint costs a step.
            const Jet joint = spline_.jet_on(piece_, part.hi, 0);
            const double walked = std::hypot(joint[0][0] - jet[0][0], joint[0][1] - jet[0][1]);
            rest = std::fmax(rest - walked, 0);
            t_ = part.hi;
            if (!dt) ++march.steps_without_root;
            if (piece_ + 1 == spline_.pieces()) return;
            ++piece_;
            is_first = false;
        }
    }

    void note_steepness(const Jet& jet, double step, March& march) const {
        const std::optional<double> kappa = curvature(jet);
        if (kappa && std::fabs(*kappa) * step > steepest_step) ++march.steep_steps;
    }

    /// The smallest positive dt at which the coordinate that moves faster has moved as far as a
    /// step along the tangent does. In the paper unsigned, which fails where it falls.
    // differs from [HaradaNakamae, eq. 11]: M = T x' / |r'|, signed
    std::optional<double> root(const Jet& jet, double step) const {
        if (step == 0) return 0;
        const double speed = std::hypot(jet[1][0], jet[1][1]);
        const int k = std::fabs(jet[1][0]) >= std::fabs(jet[1][1]) ? 0 : 1;
        if (speed == 0) return std::nullopt;
        const double move = step * jet[1][k] / speed;
        const num::RealRoots roots =
            num::real_roots(std::array<double, 4>{-move, jet[1][k], jet[2][k] / 2, jet[3][k] / 6});
        for (const double dt : roots) {
            if (dt > 0) return dt;
        }
        return std::nullopt;
    }

    const Curve& spline_;
    double t_;
    std::size_t piece_ = 0;
};

/// The length of the polyline through `between` points in each piece and the joints.
double polyline_length(const Curve& curve, int between) {
    num::Sum sum;
    std::vector<double> before = curve(curve.domain().lo);
    for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
        const Interval part = curve.piece(piece);
        for (int j = 1; j <= between + 1; ++j) {
            const double t = j > between ? part.hi : part.lo + part.length() * j / (between + 1);
            const Jet at = curve.jet_on(piece, t, 0);
            sum.add(std::hypot(at[0][0] - before[0], at[0][1] - before[1]));
            before.assign(at[0].begin(), at[0].end());
        }
    }
    return sum.value();
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
    return largest;
}

void require_options(const SampleOptions& options) {
    sampling::require_ranges(options);
    if (options.law == Law::parameter || options.law == Law::chord) {
        throw Error("sample.options", "law", std::string(name_of(options.law)),
                    "the paper's method divides the arc length: it takes no such law");
    }
    if (options.between && options.walked_length == WalkedLength::exact) {
        throw Error("sample.options", "between", std::to_string(*options.between),
                    "points between joints are for the length of a polyline");
    }
}

}  // namespace

Curve harada_nakamae_curve(PointsView points) {
    const Curve spline = natural_spline(with_point_beyond(points));
    return trimmed(spline, {spline.breaks()[0], spline.breaks()[points.size() - 1]});
}

Sampling sample_harada_nakamae(PointsView points, const SampleOptions& options) {
    require_options(options);
    constexpr int usual_between = 3;
    const Curve spline = natural_spline(with_point_beyond(points));
    const Curve curve = harada_nakamae_curve(points);
    const ArcLengthMap map(curve);
    const sampling::ChosenLaw chosen = sampling::choose_law(curve, map, options);
    const sampling::Timing timing = sampling::timing_of(chosen, map.length(), options);
    Places places = sampling::places_of(map, chosen.law, timing);
    const std::vector<double> wanted = places.s;

    const double walked = options.walked_length == WalkedLength::exact
                              ? map.length()
                              : polyline_length(curve, options.between.value_or(usual_between));
    const double way = wanted.back() - wanted.front();
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < wanted.size(); ++i) {
        steps.push_back((wanted[i + 1] - wanted[i]) * (walked / way));
    }
    const March march = Marcher(spline).through(steps);

    const Interval domain = curve.domain();
    const double reached = march.t.back() - domain.lo;
    const double correction = domain.length() / reached;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double t = domain.lo + (march.t[i] - domain.lo) * correction;
        places.t[i] = i + 1 == places.size() ? domain.hi : std::fmin(t, domain.hi);
        places.s[i] = map.s_of(places.t[i]);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, places.size() - 1);
        places.speed[i] =
            (places.s[after] - places.s[before]) / (places.time[after] - places.time[before]);
    }
    Sampling result = sampling::table_of(curve, places, options);
    SampleReport& report = result.report;
    report.length = map.length();
    report.duration = timing.duration;
    report.samples = places.size();
    report.walked_length = walked;
    const ArcLengthMap beyond(spline);
    report.overrun = beyond.s_of(march.t.back()) - map.length();
    report.correction = correction;
    report.max_position_error = largest_difference(places.s, wanted);
    Places against = places;
    against.s = wanted;
    report.max_spacing_error = sampling::spacing_error(map, against);
    report.steps_without_root = march.steps_without_root;
    report.steep_steps = march.steep_steps;
    if (march.steps_without_root > 0) {
        report.status = Status::not_met;
        report.notes.push_back("some steps are too long for the bends: they ended at a joint");
    }
    return result;
}

}  // namespace batten
