#include <string>

#include "batten/api/argument.hpp"
#include "batten/api/job.hpp"
#include "batten/io/json.hpp"
#include "errors.hpp"
#include "shared.hpp"

namespace batten {
namespace job_bad_test {

/// `code: place` of what is wrong with a job.
std::string complaint(const std::string& text) {
    return testing::thrown_by(
        [&] { job_of(parse_json(text, "j"), "j"); },
        [](const Error& error) { return error.code() + ": " + error.place(); });
}

/// A job whose only step has these entries more.
std::string step(const std::string& more) {
    return R"({"operation": "interpolate", "input": "p.csv")" + more + "}";
}

TEST(JobBad, AJobIsAMapOrAListOfMaps) {
    EXPECT_EQ(complaint("3"), "job.entry: j");
    EXPECT_EQ(complaint("[]"), "job.empty: j");
    EXPECT_EQ(complaint(R"({"steps": []})"), "job.empty: j");
    EXPECT_EQ(complaint("[3]"), "job.entry: j step 1");
    EXPECT_EQ(complaint(R"({"steps": [], "more": 1})"), "job.key: j");
}

TEST(JobBad, OperationsKeysAndEntriesAreNamed) {
    EXPECT_EQ(complaint("{}"), "job.operation: j, operation");
    EXPECT_EQ(complaint(R"([{"operation": "magic"}])"), "job.operation: j step 1, operation");
    EXPECT_EQ(complaint(step(R"(, "colour": "red")")), "job.key: j");
    EXPECT_EQ(complaint(step(R"(, "": 1)")), "job.key: j");
    EXPECT_EQ(complaint(R"({"operation": ""})"), "job.operation: j, operation");
    EXPECT_EQ(complaint(step(R"(, "output": 3)")), "job.entry: j, output");
    EXPECT_EQ(complaint(step(R"(, "draw": "")")), "job.entry: j, draw");
    EXPECT_EQ(complaint(step(R"(, "options": [])")), "job.entry: j, options");
    EXPECT_EQ(complaint(step(R"(, "inputs": [])")), "job.key: j");
}

TEST(JobBad, OptionsAreCheckedBeforeAnythingRuns) {
    const auto option = [](const std::string& entry) {
        return complaint(step(R"(, "options": {)" + entry + "}"));
    };
    EXPECT_EQ(option(R"("speed": 3)"), "option.unknown: j, speed");
    EXPECT_EQ(option(R"("method": "magic")"), "option.choice: j, method");
    EXPECT_EQ(option(R"("closed": "")"), "option.value: j, closed");
    EXPECT_EQ(option(R"("": 1)"), "option.unknown: j, ");
    EXPECT_EQ(option(R"("closed": "perhaps")"), "option.value: j, closed");
    EXPECT_EQ(option(R"("closed": [true])"), "option.value: j, closed");
    EXPECT_EQ(option(R"("weight_exponent": 1e9)"), "option.range: j, weight_exponent");
    EXPECT_EQ(option(R"("weight_exponent": {"a": 1})"), "option.value: j, weight_exponent");
    EXPECT_EQ(option(R"("tangent": [[0, 90]])"), "option.value: j, tangent");
    EXPECT_EQ(option(R"("weight_exponent": null, "corner": [1, 2], "tangent": ["0:90"])"),
              "none");
}

TEST(JobBad, StepsTakeWhatStepsBeforeThemMake) {
    const std::string first = R"([{"name": "a", "operation": "interpolate", "input": "p.csv"}, )";
    const auto second = [&](const std::string& entries) { return complaint(first + entries + "]"); };
    EXPECT_EQ(second(R"({"operation": "measure", "input": "a"})"), "none");
    EXPECT_EQ(second(R"({"operation": "compare", "input": "a", "options": {"to": "a"}})"),
              "none");
    EXPECT_EQ(second(R"({"operation": "densify", "input": "a"})"), "job.input: j step 2, input");
    EXPECT_EQ(second(R"({"name": "a", "operation": "measure", "input": "a"})"), "job.name: j");
    EXPECT_EQ(second(R"({"name": "b", "operation": "measure", "input": "b"})"),
              "job.name: j step 2");
    EXPECT_EQ(second(R"({"operation": "measure", "inputs": ["a", "a"]})"), "job.input: j step 2");
    EXPECT_EQ(second(R"({"operation": "measure"})"), "job.input: j step 2");
    EXPECT_EQ(second(R"({"operation": "measure", "input": 3})"), "job.entry: j step 2, input");
    EXPECT_EQ(second(R"({"operation": "measure", "input": [[0, 0], [1, 1]]})"),
              "job.input: j step 2, input");
}

TEST(JobBad, InputsInPlaceAreReadAsFilesAre) {
    const auto input = [](const std::string& value) {
        return complaint(R"({"operation": "interpolate", "input": )" + value + "}");
    };
    EXPECT_EQ(input("[[0, 0], [1, 1]]"), "none");
    EXPECT_EQ(input("[[0, 0], [1]]"), "table.ragged: j, input row 2");
    EXPECT_EQ(input("{}"), "job.input: j, input");
    EXPECT_EQ(complaint(R"({"operation": "measure", "input": {}})"),
              "curve.format: j, input, entry format");
}

TEST(Error, SaysSoWhereANameOrATextIsEmpty) {
    const Error error("option.value", "", "", "must be a number");
    EXPECT_STREQ(error.what(), "option.value: an empty name: an empty text: must be a number");
    EXPECT_EQ(error.place(), "an empty name");
    EXPECT_EQ(error.value(), "an empty text");
}

TEST(JobBad, TwoStepsWriteToDifferentPlaces) {
    EXPECT_EQ(complaint(step(R"(, "output": "a", "report": "a")")), "output.twice: j");
    EXPECT_EQ(complaint(step(R"(, "output": "a", "report": "b")")), "none");
}

TEST(JobBad, AReportIsNoInput) {
    EXPECT_EQ(testing::code_of([] { input_of(Outcome(), "a", *find_operation("measure")); }),
              "job.input");
}

}  // namespace job_bad_test
}  // namespace batten
