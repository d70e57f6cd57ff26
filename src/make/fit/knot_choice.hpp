#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batten/make/fit_options.hpp"
#include "make/fit/path.hpp"

namespace batten::fitting {

/// The knots of a fit, and how they were found.
struct KnotChoice {
    std::vector<double> knots;  ///< the full vector
    std::vector<FitStep> path;
    std::vector<std::string> notes;
    std::vector<Alternative> alternatives;
    std::optional<FixedFit> solved;  ///< the fit over them, where the search ended with it
    std::vector<HeldDerivative> held;  ///< smooth though the knots stand often enough to jump
    int moved = 0;             ///< knots whose places were optimised
    bool by_data = false;      ///< knots chosen by the data
    bool is_met = true;
    bool is_converged = true;
};

/// Where the knots come from: those given count where nothing else is asked for.
inline KnotPlacement placement_of(const FitOptions& options) {
    const bool is_default = options.knots == KnotPlacement::automatic;
    return is_default && !options.knots_values.empty() ? KnotPlacement::given : options.knots;
}

/// Throws what the contract of `fit` says about options; so that a pair that contradicts is never
/// met half-way through.
void require_options(const FitOptions& options);

/// The knots given, without the ends of the range.
std::vector<double> inner_knots(std::span<const double> values, Interval range);

/// Interior knots as given: inside `range`, rising, repeated degree + 1 times at most.
/// Throws `fit.knots`.
void require_inner_knots(std::span<const double> values, Interval range, int degree);
/// Throws `fit.too-few`.
void require_enough(std::size_t samples, std::size_t functions);

KnotChoice choose_knots(const Samples& samples, const LocalBasis& basis, const FitOptions& options);

/// The same with knots inserted as bic wants them: where the outliers are, and the parameters.
FitOptions by_insertion(const FitOptions& options);

StopPlan stop_plan(const Samples& samples, const FitOptions& options);

inline Ends ends_of(const FitOptions& options) {
    return options.closed ? Ends::closed : Ends::open;
}

}  // namespace batten::fitting
