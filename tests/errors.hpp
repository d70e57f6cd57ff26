/// What a call throws, as a test reads it; and the numbers that are none.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "batten/base/error.hpp"

namespace batten::testing {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// `words(error)` of the error that `call` throws, whose place, value and rule must be told;
/// "none" where it throws none.
template <class Call, class Words>
std::string thrown_by(Call&& call, Words&& words) {
    try {
        std::forward<Call>(call)();
    } catch (const Error& error) {
        EXPECT_FALSE(error.place().empty());
        EXPECT_FALSE(error.value().empty());
        EXPECT_FALSE(error.rule().empty());
        return words(error);
    }
    return "none";
}

/// The id of the error that `call` throws, or "none".
template <class Call>
std::string code_of(Call&& call) {
    return thrown_by(call, [](const Error& error) { return error.code(); });
}

/// The id and the place of the error that `call` throws, or "none".
template <class Call>
std::string code_and_place_of(Call&& call) {
    return thrown_by(call, [](const Error& error) { return error.code() + " " + error.place(); });
}

/// The whole message of the error that `call` throws, or "none".
template <class Call>
std::string complaint_of(Call&& call) {
    return thrown_by(call, [](const Error& error) { return std::string(error.what()); });
}

}  // namespace batten::testing
