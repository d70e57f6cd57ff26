#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "batten/make/implicit_cubic.hpp"
#include "batten/make/sample.hpp"
#include "curves.hpp"
#include "figure_8.hpp"
#include "shared_json.hpp"

namespace batten {
namespace sample_figures_test {

using namespace batten::testing;

struct Figure {
    const char* file;
    SampleOptions options;
};

std::vector<Figure> figures() {
    SampleOptions even;
    even.count = 41;
    SampleOptions bends = even;
    bends.law = Law::curvature_proxy;
    SampleOptions cosine;
    cosine.law = Law::relative;
    std::vector<double> steps;
    for (int i = 1; i <= 42; ++i) steps.push_back(std::fabs(std::cos(std::numbers::pi * i / 21)));
    cosine.weights = Points(steps, 1);
    return {{"fig4_equal41", even}, {"fig5_K41", bends}, {"fig6_cos43", cosine}};
}

CsvTable table_of(const Figure& figure) {
    return shared_csv(std::string("reference/sampling/") + figure.file + ".csv");
}

TEST(PaperFigures, HaveTheExactPlacesOfTheReference) {
    SKIP_UNLESS_SHARED("reference/sampling/fig5_K41.csv");
    const Curve curve = figure_8();
    for (const Figure& figure : figures()) {
        const CsvTable wanted = table_of(figure);
        const Sampling made = sample(curve, figure.options);
        ASSERT_EQ(made.rows.size(), wanted.rows.size());
        for (std::size_t i = 0; i < made.rows.size(); ++i) {
            const std::size_t piece = static_cast<std::size_t>(wanted.number(i, "seg_exact")) - 1;
            EXPECT_NEAR(made.rows(i, 2), wanted.number(i, "s_target"), 1e-10) << figure.file << i;
            EXPECT_NEAR(made.rows(i, 3) - curve.breaks()[piece], wanted.number(i, "t_exact"), 1e-10)
                << figure.file << i;
            EXPECT_NEAR(made.rows(i, 4), wanted.number(i, "x_exact"), 1e-10) << figure.file << i;
            EXPECT_NEAR(made.rows(i, 5), wanted.number(i, "y_exact"), 1e-10) << figure.file << i;
        }
    }
}

TEST(PaperMethod, StepsAsTheReferenceDoes) {
    SKIP_UNLESS_SHARED("reference/sampling/fig5_K41.csv");
    const Points points = figure_8_points();
    const auto summary = shared_json("reference/sampling/sampling_summary.json");
    const Curve curve = harada_nakamae_curve(points);
    for (Figure figure : figures()) {
        figure.options.method = SampleMethod::harada_nakamae;
        const CsvTable wanted = table_of(figure);
        const Sampling made = sample_harada_nakamae(points, figure.options);
        for (std::size_t i = 0; i < made.rows.size(); ++i) {
            const std::size_t piece = static_cast<std::size_t>(wanted.number(i, "seg_paper")) - 1;
            EXPECT_NEAR(made.rows(i, 3) - curve.breaks()[piece], wanted.number(i, "t_paper"), 1e-9)
                << figure.file << i;
            EXPECT_NEAR(made.rows(i, 2), wanted.number(i, "s_paper"), 1e-9) << figure.file << i;
            EXPECT_NEAR(made.rows(i, 4), wanted.number(i, "x_paper"), 1e-9) << figure.file << i;
            EXPECT_NEAR(made.rows(i, 5), wanted.number(i, "y_paper"), 1e-9) << figure.file << i;
        }
        const auto& known = summary[figure.file];
        EXPECT_NEAR(*made.report.overrun, known["raw_last_arc_minus_L"].get<double>(), 1e-9);
        EXPECT_NEAR(*made.report.correction,
                    known["corrected"]["linear_correction_factor"].get<double>(), 1e-12);
        EXPECT_NEAR(*made.report.max_position_error,
                    known["corrected"]["max_abs_arc_error"].get<double>(), 1e-9);
    }
}

TEST(PaperMethod, WalksThePolylineOfItsFirstMethodWhereAsked) {
    SKIP_UNLESS_SHARED("reference/sampling/sampling_summary.json");
    const Points points = figure_8_points();
    const auto summary = shared_json("reference/sampling/sampling_summary.json");
    SampleOptions options;
    options.method = SampleMethod::harada_nakamae;
    options.walked_length = WalkedLength::polyline;
    options.count = 41;
    for (const int between : {1, 3, 5, 10, 20}) {
        options.between = between;
        const Sampling made = sample_harada_nakamae(points, options);
        const std::string name = "polyline_length_m" + std::to_string(between);
        EXPECT_NEAR(*made.report.walked_length, summary[name].get<double>(), 1e-10) << between;
    }
}

TEST(PaperMethod, SaysWhenAStepIsTooLongForTheBend) {
    SKIP_UNLESS_SHARED("reference/sampling/figure8_points20.csv");
    const Points points = figure_8_points();
    SampleOptions options;
    options.method = SampleMethod::harada_nakamae;
    // max |kappa| = 0.0333: the step may be 12.4 at most, which is 43 points.
    options.count = 45;
    EXPECT_EQ(*sample_harada_nakamae(points, options).report.steep_steps, 0);
    options.count = 21;
    EXPECT_GT(*sample_harada_nakamae(points, options).report.steep_steps, 0);
}

TEST(ImplicitForm, HasThe102TermsOfThePaperTable) {
    std::map<char, int> counts;
    for (const ImplicitTerm& term : implicit_terms()) ++counts[term.coefficient];
    const std::map<char, int> table{{'A', 1}, {'B', 1}, {'C', 1}, {'D', 1},  {'E', 7},
                                    {'F', 7}, {'G', 8}, {'H', 21}, {'I', 21}, {'J', 34}};
    EXPECT_EQ(counts, table);
    EXPECT_EQ(implicit_terms().size(), 102U);
}

TEST(ImplicitForm, IsZeroOnTheCubicAndItsGradientIsNormal) {
    const std::array<double, 4> a{0.3, 1, -0.7, 0.4}, b{-0.2, 0.5, 1.1, -0.9};
    const ImplicitCubic form = implicit_cubic(a, b);
    for (int i = 0; i <= 20; ++i) {
        const double t = 0.1 * i - 0.5;
        const double x = a[0] + t * (a[1] + t * (a[2] + t * a[3]));
        const double y = b[0] + t * (b[1] + t * (b[2] + t * b[3]));
        const double dx = a[1] + t * (2 * a[2] + t * 3 * a[3]);
        const double dy = b[1] + t * (2 * b[2] + t * 3 * b[3]);
        const double fx = form.along_x(x, y), fy = form.along_y(x, y);
        EXPECT_NEAR(form(x, y), 0, 1e-13);
        EXPECT_NEAR((fx * dx + fy * dy) / (std::hypot(fx, fy) * std::hypot(dx, dy)), 0, 1e-12);
    }
}

TEST(ImplicitForm, OfTheFigureEightIsNormalToTheCurveToRounding) {
    SKIP_UNLESS_SHARED("reference/sampling/figure8_points20.csv");
    const Curve curve = figure_8();
    double worst = 0;
    for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
        const Interval part = curve.piece(piece);
        const Jet start = curve.jet_on(piece, part.lo, 3);
        std::array<double, 4> a, b;
        double factorial = 1;
        for (int k = 0; k < 4; ++k) {
            if (k > 0) factorial *= k;
            a[k] = k == 0 ? 0 : start[k][0] / factorial;
            b[k] = k == 0 ? 0 : start[k][1] / factorial;
        }
        const ImplicitCubic form = implicit_cubic(a, b);
        for (int i = 0; i <= 10; ++i) {
            const Jet jet = curve.jet_on(piece, part.lo + part.length() * i / 10, 1);
            const double x = jet[0][0] - start[0][0], y = jet[0][1] - start[0][1];
            const double fx = form.along_x(x, y), fy = form.along_y(x, y);
            worst = std::fmax(worst, std::fabs(fx * jet[1][0] + fy * jet[1][1]) /
                                         (std::hypot(fx, fy) * std::hypot(jet[1][0], jet[1][1])));
        }
    }
    EXPECT_LE(worst, 2e-14);
}

}  // namespace sample_figures_test
}  // namespace batten
