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

std::vector<std::string> notes_of(const Outcome& made) {
    std::vector<std::string> notes;
    if (const Value* list = made.report.find("notes")) {
        for (const Value& note : *list->list()) notes.push_back(*note.text());
    }
    return notes;
}

TEST(FitOfATable, NamesTheLinesOfRejectedSamples) {
    const Outcome made = outcome(parabola_with("0.01"), {{"robust", "reject"}});
    ASSERT_EQ(made.report.find("rejected")->list()->size(), 1u);
    EXPECT_EQ(made.report.find("rejected")->list()->front().number(), 10);
    EXPECT_EQ(notes_of(made), std::vector<std::string>{"rejected: line 12 of table.csv"});
}

/// Samples of `f` at 60 abscissae, no errors stated.
template <class Function>
std::string exact(Function f) {
    std::string text = "x,y\n";
    for (int i = 0; i < 60; ++i) {
        text += format_number(0.1 * i) + ',' + format_number(f(0.1 * i)) + '\n';
    }
    return text;
}

TEST(FitOfATable, TakesOneIntervalForAnExactParabola) {
    EXPECT_EQ(outcome(exact([](double x) { return 1 + x - x * x; })).report.find("intervals")
                  ->number(), 1);
}

TEST(FitOfATable, SeesNoExtremumAndNoNoiseInAConstant) {
    const Outcome made = outcome(exact([](double) { return 3.7; }));
    EXPECT_TRUE(made.report.find("extrema")->list()->empty());
    EXPECT_LT(made.report.find("sigma")->number(), 1e-15);
    EXPECT_LT(made.report.find("integral")->find("deviation")->number(), 1e-14);
}

}  // namespace fit_table_test
}  // namespace batten
