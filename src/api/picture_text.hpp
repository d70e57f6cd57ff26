#pragma once

#include <string>

/// Numbers of a fit as the line below a picture's title writes them.
namespace batten::api {

/// After the name of a probability: `= 0.25`, rounded, but never to a certainty that it is not.
std::string probability_text(double p);

/// A number and what is counted: `1 sample`, `2 samples`.
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace batten::api
