#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "shared_json.hpp"

// cases/spline_reference.json is made by tools/make_spline_reference.py.
namespace batten {
namespace interpolate_scipy_test {

template <NamedEnum Enum>
Enum word_of(const nlohmann::json& name) {
    for (const auto& word : names_of(Enum{})) {
        if (word.name == name.get<std::string>()) return word.value;
    }
    throw std::invalid_argument(name.get<std::string>());
}

/// Sets the field that has the key's name from a JSON value.
struct FieldReader {
    const nlohmann::json& options;

    template <class Field>
    void operator()(const char* name, Field& field, Limits, const char*) const {
        const auto found = options.find(name);
        if (found == options.end()) return;
        if constexpr (NamedEnum<Field>) {
            field = word_of<Field>(*found);
        } else if constexpr (std::is_same_v<Field, std::optional<Parameter>>) {
            field = word_of<Parameter>(*found);
        } else if constexpr (std::is_same_v<Field, bool> ||
                             std::is_same_v<Field, std::vector<double>>) {
            field = found->get<Field>();
        }
    }
};

InterpolateOptions options_of(const nlohmann::json& json) {
    InterpolateOptions options;
    visit_fields(options, FieldReader{json});
    return options;
}

Points points_of(const nlohmann::json& rows) {
    Points points(static_cast<int>(rows[0].size()));
    for (const auto& row : rows) points.push_back(row.get<std::vector<double>>());
    return points;
}

double largest(const nlohmann::json& rows) {
    double most = 0;
    for (const auto& row : rows) {
        for (const double x : row.get<std::vector<double>>()) most = std::max(most, std::fabs(x));
    }
    return most;
}

TEST(Interpolate, AgreesWithSciPyOnSplinesAndPchip) {
    const nlohmann::json reference = testing::source_json("cases/spline_reference.json");
    const double place = reference["place"];
    ASSERT_GT(reference["cases"].size(), 100u);
    for (const auto& example : reference["cases"]) {
        const Points points = points_of(example["points"]);
        const Curve curve = curve_through(points, options_of(example["options"]));
        ASSERT_EQ(curve.pieces(), example["value"].size());
        // PchipInterpolator gives y alone.
        const std::size_t skip =
            static_cast<std::size_t>(points.dim()) - example["value"][0].size();
        const double size = largest(example["value"]), speed = largest(example["derivative"]);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const Interval piece = curve.piece(i);
            const Jet jet = curve.jet_on(i, piece.lo + place * piece.length(), 1);
            for (std::size_t k = 0; k < example["value"][i].size(); ++k) {
                ASSERT_NEAR(jet[0][k + skip], example["value"][i][k], 1e-13 * size)
                    << example["name"];
                ASSERT_NEAR(jet[1][k + skip], example["derivative"][i][k], 1e-12 * speed)
                    << example["name"];
            }
        }
    }
}

}  // namespace interpolate_scipy_test
}  // namespace batten
