#include "batten/make/sample.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "make/sample/walk.hpp"

namespace batten {
namespace {

using sampling::ChosenLaw;
using sampling::Places;
using sampling::Timing;

/// Chords that differ by more than this share of the length are not equal.
constexpr double chords_equal = 1e-9;

/// The parameter itself, so that joints are met exactly.
void place_by_parameter(const Curve& curve, const ArcLengthMap& map, const SampleOptions& options,
                        double duration, Places& places) {
    const std::size_t pieces = options.between ? curve.pieces() : 1;
    const std::size_t steps = places.size() - 1, each = steps / pieces;
    for (std::size_t i = 0; i <= steps; ++i) {
        const std::size_t piece = std::min(i / each, pieces - 1), inside = i - piece * each;
        const Interval part = options.between ? curve.piece(piece) : curve.domain();
        const double share = static_cast<double>(inside) / static_cast<double>(each);
        places.t[i] = inside == each ? part.hi : part.lo + part.length() * share;
        places.s[i] = map.s_of(places.t[i]);
        const Jet jet = curve.jet(places.t[i], 1);
        double speed = 0;
        for (const double x : jet[1]) speed = std::hypot(speed, x);
        places.speed[i] = speed * part.length() * static_cast<double>(pieces) / duration;
    }
}

}  // namespace

Sampling sample(const Curve& curve, const SampleOptions& options) {
    sampling::require_ranges(options);
    if (options.method != SampleMethod::exact) {
        throw Error("sample.options", "method", std::string(name_of(options.method)),
                    "this method starts from points");
    }
    if (options.between && options.law != Law::parameter) {
        throw Error("sample.options", "between", std::to_string(*options.between),
                    "points between joints are for law parameter");
    }
    if (options.walked_length != WalkedLength::exact) {
        throw Error("sample.options", "walked_length", std::string(name_of(options.walked_length)),
                    "goes with method harada-nakamae only");
    }
    const ArcLengthMap map(curve);
    const ChosenLaw chosen = sampling::choose_law(curve, map, options);
    const Timing timing = sampling::timing_of(chosen, map.length(), options);
    Places places = sampling::places_of(map, chosen.law, timing);
    double error = 0;
    if (options.law == Law::parameter) {
        place_by_parameter(curve, map, options, timing.duration, places);
    };
    if (options.law == Law::chord) {
        sampling::EqualChords found = sampling::equal_chords(curve, map, places.size());
        places.s = std::move(found.s);
        error = found.error;
        map.t_of(places.s, places.t);
    } else {
        error = sampling::spacing_error(map, places);
    }
    Sampling result = sampling::table_of(curve, places, options);
    const bool is_by_law = options.law != Law::parameter && options.law != Law::chord;
    if (is_by_law) result.speeds = sampling::speeds_of(map, chosen.law, timing);
    result.report.length = map.length();
    result.report.max_spacing_error = error;
    result.report.duration = timing.duration;
    result.report.samples = places.size();
    if (chosen.corners > 0) {
        result.report.notes.push_back("the walk stops at corners of the curve: " +
                                      std::to_string(chosen.corners));
    }
    if (options.law == Law::chord && error > chords_equal * map.length()) {
        result.report.status = Status::not_converged;
        result.report.notes.push_back("the chords could not be made equal: too few for the bends");
    }
    return result;
}

}  // namespace batten
