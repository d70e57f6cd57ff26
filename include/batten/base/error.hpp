#pragma once

#include <stdexcept>
#include <string>

namespace batten {

/// The caller's input breaks a rule. No result exists.
///
/// `what()` reads `code: place: value: rule`, for example
/// `points.not-finite: points.csv row 7, column y: nan: coordinates must be finite`.
/// Codes are permanent; docs/errors.md lists them all.
class Error : public std::runtime_error {
public:
    Error(std::string code, std::string place, std::string value, std::string rule);

    const std::string& code() const noexcept { return code_; }
    const std::string& place() const noexcept { return place_; }
    const std::string& value() const noexcept { return value_; }
    const std::string& rule() const noexcept { return rule_; }

    /// The same error seen from further out: `prefix` is put before the place.
    Error within(const std::string& prefix) const;

private:
    std::string code_, place_, value_, rule_;
};

}  // namespace batten
