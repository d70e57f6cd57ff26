#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ends the test as skipped, with a notice, where the reference file is not beside the checkout.
#define SKIP_UNLESS_SHARED(name)                                   \
    if (!batten::testing::shared_file(name)) {                     \
        GTEST_SKIP() << "needs ../shared/" << (name);              \
    }                                                              \
    static_assert(true, "")

namespace batten::testing {

/// A table of text cells, as read from a .csv file with a header.
struct CsvTable {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;

    /// The cell as a number; fails the test by an exception where it is none.
    double number(std::size_t row, std::string_view name) const;
    const std::string& text(std::size_t row, std::string_view name) const;
    /// A whole column as numbers.
    std::vector<double> column(std::string_view name) const;
    std::size_t index(std::string_view name) const;
};

/// Path of `../shared/NAME`, for example shared_file("reference/pseudo-spline/circle.csv"), if the
/// file is there.
std::optional<std::string> shared_file(std::string_view name);
/// The content of a file of ../shared: after SKIP_UNLESS_SHARED(name).
CsvTable shared_csv(std::string_view name);

/// Path of a file of this checkout, for example source_file("cases/circle.json").
std::string source_file(std::string_view name);

/// Path of an output file of this run in the build folder; its folders are made.
std::string scratch_file(std::string_view name);

/// The whole file; throws where it cannot be read.
std::string read_text(const std::string& path);
void write_text(const std::string& path, std::string_view text);
CsvTable parse_csv(std::string_view text);

/// Passes where `text` is, byte for byte, tests/picture/golden/NAME. Where it is not, the new text
/// is left in the build folder and the message says where; with BATTEN_GOLDEN=accept in the
/// environment it is also written over the golden file (and the test fails all the same).
::testing::AssertionResult is_golden(std::string_view name, std::string_view text);

}  // namespace batten::testing
