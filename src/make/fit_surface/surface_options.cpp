#include "make/fit_surface/surface_options.hpp"

#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::surface_fitting {
namespace {

[[noreturn]] void refuse(const char* option, std::string_view value, const char* rule) {
    throw Error("fit.options", option, std::string(value), rule);
}

/// What tells the number of strips: one thing at a time.
void require_one_number(const FitSurfaceOptions& options) {
    const bool is_given = has_given_lines(options), has_number = !options.intervals.empty();
    if (is_given && has_number) refuse("intervals", "given", "given knot lines are already so many");
    if (options.delta2 && (is_given || has_number)) {
        refuse("delta2", format_number(*options.delta2),
               "decides on the number of strips, which is given");
    }
    if (options.stop == StopRule::none && !is_given && !has_number && !options.delta2) {
        refuse("stop", "none", "needs the numbers of strips");
    }
}

}  // namespace

void require_surface_options(const FitSurfaceOptions& options) {
    if (options.degree < 0 || options.degree > 9) {
        throw Error("option.range", "degree", std::to_string(options.degree),
                    "must lie between 0 and 9");
    }
    if (options.knots == SurfaceKnots::curved) {
        refuse("knots", "curved", "curved knot lines are made by fit_front");
    }
    require_one_number(options);
    if (options.stop != StopRule::distribution && !options.distribution.empty()) {
        refuse("distribution", "given", "goes with the stopping rule distribution only");
    }
}

}  // namespace batten::surface_fitting
