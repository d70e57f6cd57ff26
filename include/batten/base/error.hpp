#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace batten {

/// The caller's input breaks a rule. No result exists.
///
/// `what()` reads `code: place: value: rule`, for example
/// `points.not-finite: points.csv row 7, column y: nan: coordinates must be finite`.
/// Codes are permanent; docs/errors.md lists them all.
class Error : public std::runtime_error {
public:
    Error(std::string code, std::string place, std::string value, std::string rule,
          std::vector<std::size_t> rows = {});

    const std::string& code() const noexcept { return code_; }
    const std::string& place() const noexcept { return place_; }
    const std::string& value() const noexcept { return value_; }
    const std::string& rule() const noexcept { return rule_; }
    /// The rows of the input that are to blame, from 0, where there are such.
    const std::vector<std::size_t>& rows() const noexcept { return rows_; }

    /// The same error with its place told by somebody who knows more, such as the file's name.
    Error at(std::string place) const { return {code_, std::move(place), value_, rule_, rows_}; }

private:
    std::string code_, place_, value_, rule_;
    std::vector<std::size_t> rows_;
};

}  // namespace batten
