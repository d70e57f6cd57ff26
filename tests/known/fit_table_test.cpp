#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/text.hpp"
#include "errors.hpp"

// What `fit` makes of a table, as every face shows it.
namespace batten {
namespace fit_table_test {

/// Forty samples of a parabola; the one on line 12 is far off, with the error `sigma`.
std::string parabola_with(const std::string& sigma) {
    std::string text = "x,y,sigma\n";
    for (int i = 0; i < 40; ++i) {
        const double x = 0.1 * i;
        text += format_number(x) + ',' + format_number(x * x + (i == 10 ? 7 : 0)) + ',' +
                (i == 10 ? sigma : "0.01") + '\n';
    }
    return text;
}

Outcome outcome(const std::string& text, const std::vector<Setting>& settings = {}) {
    const Input input{"table.csv", PointsInput{parse_table({"table.csv", text}), {}}};
    return find_operation("fit")->run({&input, 1}, settings, {});
}

TEST(FitOfATable, GivesNoWeightToASampleWhoseSigmaIsInfinite) {
    const Outcome made = outcome(parabola_with("inf"));
    EXPECT_EQ(made.report.find("samples")->number(), 39);
    EXPECT_LT(made.report.find("max_residual")->number(), 1e-12);
    EXPECT_EQ(made.rows().cells.size(), 39u);
    EXPECT_FALSE(made.draw().panels.empty());
}

TEST(FitOfATable, RefusesACellOfSigmaThatIsNoNumber) {
    const auto refusal = [](const std::string& sigma) {
        return testing::code_and_place_of([&] { outcome(parabola_with(sigma)); });
    };
    EXPECT_EQ(refusal("nan"), "points.not-finite table.csv row 12, column sigma");
    EXPECT_EQ(refusal("-inf"), "points.not-finite table.csv row 12, column sigma");
    EXPECT_EQ(refusal("1e999"), "number.overflow table.csv row 12, column sigma");
    EXPECT_EQ(refusal("?"), "table.not-a-number table.csv row 12, column sigma");
}

}  // namespace fit_table_test
}  // namespace batten
