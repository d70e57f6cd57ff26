#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/text.hpp"
#include "batten/io/draw/surface_plots.hpp"
#include "batten/make/interpolate.hpp"
#include "errors.hpp"
#include "shared.hpp"

// Maps, sheets and what operations draw of surfaces. After a change on purpose:
// BATTEN_GOLDEN=accept, and look.
namespace batten::testing {
namespace surface_picture_test {

double two_hills(double x, double y) {
    const auto hill = [&](double a, double b, double size) {
        return std::exp(-((x - a) * (x - a) + (y - b) * (y - b)) / (2 * size * size));
    };
    return 80 + 40 * hill(18, 30, 6) - 25 * hill(40, 18, 8);
}

Heights hills(std::size_t nx, std::size_t ny) {
    Heights heights{even_places({0, 60}, nx), even_places({0, 50}, ny), Grid(nx, ny)};
    for (std::size_t i = 0; i < nx; ++i) {
        for (std::size_t j = 0; j < ny; ++j) {
            heights.z(i, j) = two_hills(heights.x[i], heights.y[j]);
        }
    }
    return heights;
}

std::string hills_table() {
    const Heights heights = hills(31, 26);
    std::string text = "x,y,f\n";
    for (std::size_t i = 0; i < heights.x.size(); ++i) {
        for (std::size_t j = 0; j < heights.y.size(); ++j) {
            const double a = static_cast<double>(i), b = static_cast<double>(j);
            const double wobble = std::sin(40 * a * a + 17 * b) + std::sin(29 * b * b);
            text += format_number(heights.x[i]) + "," + format_number(heights.y[j]) + "," +
                    format_fixed(heights.z(i, j) + 0.7 * wobble, 2) + "\n";
        }
    }
    return text;
}

/// A tube bent over, which hides parts of itself.
SheetLayer tube() {
    constexpr std::size_t around = 20, along = 24;
    SheetLayer sheet;
    sheet.nodes = Grid(around + 1, along + 1, 3);
    for (std::size_t i = 0; i <= around; ++i) {
        for (std::size_t j = 0; j <= along; ++j) {
            const double a = 6.283185307 * static_cast<double>(i) / around;
            const double b = 3.141592654 * static_cast<double>(j) / along;
            const double reach = 3 + std::cos(a);
            const double place[] = {reach * std::cos(b), std::sin(a), reach * std::sin(b)};
            for (int k = 0; k < 3; ++k) sheet.nodes(i, j, k) = place[k];
        }
    }
    return sheet;
}

Drawing of(std::vector<Panel> panels) {
    Drawing drawing;
    drawing.columns = 2;
    drawing.panels = std::move(panels);
    return drawing;
}

TEST(Picture, OfReliefsHidesWhatIsBehind) {
    const std::vector<double> levels{60, 65, 70, 75, 85, 90, 100, 110};
    Panel shaded = relief_plot(hills(25, 25), {levels}, "lit, with level lines");
    Panel wire = relief_plot(hills(21, 21), {}, "node lines and points");
    SheetLayer& sheet = std::get<SheetLayer>(wire.layers[0]);
    sheet.style = SheetStyle::wire;
    for (const double y : {5.0, 18.0, 30.0, 45.0}) {
        for (double x = 3; x < 60; x += 9) {
            sheet.dots.push_back(std::array{x, y, two_hills(x, y) + 2});
        }
    }
    wire.x_label = "width, mm";
    wire.y_label = "depth, mm";
    wire.z_label = "height, µm";
    EXPECT_TRUE(is_golden("reliefs.svg", svg(of({shaded, wire}))));
}

TEST(Picture, OfASheetOrdersItsCellsByNearness) {
    Drawing drawing;
    drawing.width = 480;
    drawing.add(tube());
    EXPECT_TRUE(is_golden("tube.svg", svg(drawing)));
}

TEST(Picture, OfMapsHasColourBarsAndHoles) {
    Heights heights = hills(31, 26), residuals = hills(31, 26);
    for (std::size_t i = 0; i < 31; ++i) {
        for (std::size_t j = 0; j < 26; ++j) {
            residuals.z(i, j) = 3 * std::sin(0.02 * static_cast<double>(i * i)) *
                                std::cos(0.3 * static_cast<double>(j));
        }
    }
    for (std::size_t i = 10; i < 16; ++i) {
        for (std::size_t j = 5; j < 9; ++j) heights.z.drop(i, j);
    }
    Panel levels = level_plot(heights, round_levels({55, 120}, 8), "level lines");
    EXPECT_TRUE(is_golden("maps.svg", svg(of({height_map(heights, "heights"), std::move(levels),
                                              residual_map(residuals, {}, "residuals")}))));
}

Outcome fitted(const std::vector<Setting>& settings) {
    const Input input{"hills.csv", Source{"hills.csv", hills_table()}};
    return find_operation("fit-surface")->run({&input, 1}, settings, {});
}

TEST(Picture, OfASurfaceFitShowsKnotLinesLevelsResidualsAndTheSurface) {
    const Drawing drawing = fitted({{"sigma", "0.7"}}).draw();
    ASSERT_EQ(drawing.panels.size(), 4u);
    EXPECT_TRUE(is_golden("fit_surface.svg", svg(drawing)));
}

std::string hills_rows() {
    std::string text = "x,y,z\n";
    for (int k = 0; k < 400; ++k) {
        const double x = 60 * std::fmod(0.5 + 0.7548776662 * k, 1);
        const double y = 50 * std::fmod(0.5 + 0.5698402910 * k, 1);
        text += format_fixed(x, 3) + "," + format_fixed(y, 3) + "," +
                format_fixed(two_hills(x, y) + std::sin(40.0 * k * k), 2) + "\n";
    }
    return text;
}

TEST(Picture, OfAScatteredFitColoursPointsByTheirResiduals) {
    const Input input{"hills.csv", Source{"hills.csv", hills_rows()}};
    const Drawing drawing =
        find_operation("fit-surface")->run({&input, 1}, {{"scattered", "true"}, {"sigma", "0.7"}},
                                           {}).draw();
    ASSERT_EQ(drawing.panels.size(), 4u);
    const auto* dots = std::get_if<ColoredPointsLayer>(&drawing.panels[2].layers[0]);
    ASSERT_NE(dots, nullptr);
    EXPECT_EQ(dots->points.size(), 400u);
    double sum_sq = 0;
    for (const double e : dots->values) sum_sq += e * e;
    EXPECT_NEAR(sum_sq / 400, 1, 0.3);
    EXPECT_TRUE(is_golden("fit_scattered.svg", svg(drawing)));
}

TEST(Picture, OfCrowdedDotsDrawsTheirMean) {
    const auto dots_of = [](const ColoredPointsLayer& layer) {
        Drawing drawing;
        drawing.add(layer);
        const std::string text = svg(drawing);
        std::size_t count = 0;
        for (std::size_t at = text.find("<circle"); at != text.npos;
             at = text.find("<circle", at + 1)) {
            ++count;
        }
        return std::pair{count, text};
    };
    ColoredPointsLayer layer{Points({0, 0, 1, 1}, 2), {-1, 1}, "e", Ramp::diverging};
    const auto [apart, two] = dots_of(layer);
    for (int k = 0; k < 5000; ++k) {
        layer.points.push_back(std::array{1e-5 * k / 5000, 0.0});
        layer.values.push_back(k % 2 == 0 ? -1 : 1);
    }
    const auto [crowded, many] = dots_of(layer);
    EXPECT_EQ(crowded, apart);
    EXPECT_LT(many.size(), two.size() + 200);
}

TEST(Picture, OfContoursShowsThemAsAMapAndUponTheSurface) {
    const Surface surface = std::get<Surface>(fitted({{"sigma", "0.7"}}).output);
    const Input input{"hills.json", surface};
    const Outcome traced = find_operation("contour")->run({&input, 1}, {{"levels", "70,90"}}, {});
    EXPECT_TRUE(is_golden("contour.svg", svg(traced.draw())));
    const Outcome none = find_operation("contour")->run({&input, 1}, {{"levels", "500"}}, {});
    EXPECT_EQ(none.draw().panels.size(), 1u);
}

TEST(Picture, OfACoonsPatchIsALitSheetWithItsParameterLinesAndMapsOfItsCurvatures) {
    const auto side = [](std::vector<double> ends) {
        return Input{"side", curve_through(Points(std::move(ends), 3), {})};
    };
    const std::vector<Input> sides{side({0, 0, 0, 1, 0, 1, 2, 0, 0}), side({0, 1, 0, 2, 1, 0}),
                                   side({0, 0, 0, 0, 1, 0}), side({2, 0, 0, 2, 1, 0})};
    const Drawing drawing = find_operation("coons")->run(sides, {}, {}).draw();
    ASSERT_EQ(drawing.panels[0].layers.size(), 1u);
    const auto* sheet = std::get_if<SheetLayer>(&drawing.panels[0].layers[0]);
    ASSERT_NE(sheet, nullptr);
    EXPECT_EQ(sheet->lines.size(), 20u);
    // The middle of the patch is halfway between its arched and its straight side.
    EXPECT_NEAR(sheet->nodes(18, 18, 2), 0.5, 1e-12);
    ASSERT_EQ(drawing.panels.size(), 3u);
    const auto* mean = std::get_if<MapLayer>(&drawing.panels[2].layers[0]);
    ASSERT_NE(mean, nullptr);
    EXPECT_GT(std::fabs(mean->values(30, 0)), 10 * std::fabs(mean->values(30, 60)));
    EXPECT_NE(svg(drawing).find("<path"), std::string::npos);
}

TEST(Picture, OfAFlatPatchSaysSoInPlaceOfAMapOfRounding) {
    const auto side = [](std::vector<double> ends) {
        return Input{"side", curve_through(Points(std::move(ends), 3), {})};
    };
    // Askew to the axes, so that no coordinate is the same all over.
    const std::vector<Input> sides{side({0, 0, 0.1, 3, 0.7, 1}), side({-0.3, 1, 0.6, 2.7, 1.7, 1.5}),
                                   side({0, 0, 0.1, -0.3, 1, 0.6}), side({3, 0.7, 1, 2.7, 1.7, 1.5})};
    const Drawing drawing = find_operation("coons")->run(sides, {}, {}).draw();
    EXPECT_EQ(drawing.panels[1].caption, "Gaussian curvature: 0 everywhere");
    EXPECT_EQ(drawing.panels[2].caption, "mean curvature: 0 everywhere");
}

std::string code_of_drawing(const Layer& layer) {
    return code_of([&] {
        Drawing drawing;
        drawing.add(layer);
        svg(drawing);
    });
}

TEST(Map, RefusesPlacesThatDoNotFitItsNumbers) {
    EXPECT_EQ(code_of_drawing(MapLayer{{0, 1}, {0, 1, 2}, Grid(2, 2)}), "drawing.option");
    EXPECT_EQ(code_of_drawing(MapLayer{{0, 1}, {1, 0}, Grid(2, 2)}), "drawing.option");
    EXPECT_EQ(code_of_drawing(MapLayer{{0}, {0, 1}, Grid(1, 2)}), "drawing.option");
    EXPECT_EQ(code_of_drawing(MapLayer{{0, 1}, {0, 1}, Grid(2, 2)}), "none");
}

TEST(ColoredPoints, RefuseNumbersThatAreNotTheirs) {
    const Points two({0, 0, 1, 1}, 2);
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{two, {1, 2}}), "none");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{two, {1, 1}}), "none");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{two, {1}}), "drawing.option");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{}), "drawing.option");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{two, {1, 2}, "", Ramp::rising, Interval{2, 1}}),
              "drawing.option");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{Points({0, 0, 0}, 3), {1}}), "drawing.dimension");
    EXPECT_EQ(code_of_drawing(ColoredPointsLayer{two, {1, std::nan("")}}), "points.not-finite");
}

TEST(Map, HatchesMissingNodesAndNamesThemInTheLegend) {
    Heights heights = hills(31, 26);
    const auto drawn = [&] { return svg(of({height_map(heights, "heights")})); };
    EXPECT_EQ(drawn().find(">missing<"), std::string::npos);
    for (std::size_t i = 10; i < 16; ++i) {
        for (std::size_t j = 5; j < 9; ++j) heights.z.drop(i, j);
    }
    const std::string with_hole = drawn();
    EXPECT_NE(with_hole.find(">missing<"), std::string::npos);
    // The ground of the hatching, once in the legend and once on the map.
    const std::string ground = "fill=\"#f1f2f4\"";
    const std::size_t first = with_hole.find(ground);
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(with_hole.find(ground, first + 1), std::string::npos);
}

TEST(Map, LeavesOutMarksOfItsBarThatWouldCross) {
    Heights residuals = hills(11, 11);
    const auto has_sigma = [&] {
        return svg(of({residual_map(residuals, {}, "residuals")})).find(">−σ<") != std::string::npos;
    };
    for (std::size_t i = 0; i < 121; ++i) residuals.z(i / 11, i % 11) = i % 2 == 0 ? 3 : -3;
    EXPECT_TRUE(has_sigma());
    residuals.z(3, 3) = 90;
    EXPECT_FALSE(has_sigma());
}

/// The numbers of the first path of that stroke: x, y, x, y, ...
std::vector<double> numbers_of_path(const std::string& text, const std::string& stroke) {
    const std::size_t at = text.find("stroke=\"" + stroke + "\"");
    const std::size_t begin = text.rfind("d=\"", at) + 3;
    std::vector<double> numbers;
    std::string word;
    for (std::size_t i = begin; i < text.find('"', begin) + 1; ++i) {
        const char c = text[i];
        const bool belongs = (c >= '0' && c <= '9') || c == '.' || c == '-';
        if (belongs) word += c;
        if (belongs || word.empty()) continue;
        numbers.push_back(*parse_number(word));
        word.clear();
    }
    return numbers;
}

TEST(Map, HasGridLinesThatEndWithIt) {
    Heights tall{even_places({0, 1}, 5), even_places({0, 2}, 5), Grid(5, 5)};
    for (std::size_t i = 0; i < 25; ++i) tall.z(i / 5, i % 5) = static_cast<double>(i);
    const std::vector<double> grid =
        numbers_of_path(svg(of({height_map(tall, "tall"), height_map(tall, "too")})), "#e9edf1");
    Interval x{grid[0], grid[0]}, y{grid[1], grid[1]};
    for (std::size_t i = 0; i + 1 < grid.size(); i += 2) {
        x = {std::min(x.lo, grid[i]), std::max(x.hi, grid[i])};
        y = {std::min(y.lo, grid[i + 1]), std::max(y.hi, grid[i + 1])};
    }
    EXPECT_NEAR(x.length() / y.length(), 0.5, 1e-3);
}

TEST(Map, WritesNoHeightUponLinesThatRunTogether) {
    Drawing drawing;
    Panel& panel = drawing.panels[0];
    for (int i = 0; i < 8; ++i) {
        const double x = 0.5 + 0.002 * i;
        panel.add(PolylineLayer{{Points({x, 0, x, 1}, 2)}, {}, {}, "70" + std::to_string(i)});
    }
    panel.add(PolylineLayer{{Points({0, 0.2, 0.3, 0.9}, 2)}, {}, {}, "801"});
    const std::string text = svg(drawing);
    EXPECT_EQ(text.find(">70"), std::string::npos);
    EXPECT_NE(text.find(">801<"), std::string::npos);
}

TEST(Picture, OfASurfaceFitSaysWhatItCameTo) {
    const Drawing drawing = fitted({{"sigma", "0.7"}}).draw();
    EXPECT_EQ(drawing.title, "Least-squares spline surface");
    for (const char* const words : {"806 samples", " strips, ", " coefficients, δ² = ", "χ² p "}) {
        EXPECT_NE(drawing.subtitle.find(words), std::string::npos) << words;
    }
}

TEST(Picture, OfASectionNamesItsAxesAndMarksItsKnots) {
    const Outcome made = fitted({{"sigma", "0.7"}});
    const Input input{"hills.json", std::get<Surface>(made.output)};
    const Drawing drawing = find_operation("section")->run({&input, 1}, {{"y", "20"}}, {}).draw();
    const Panel& panel = drawing.panels[0];
    EXPECT_EQ(drawing.title, "Section of the surface at y = 20");
    EXPECT_EQ(panel.x_label, "x");
    EXPECT_EQ(panel.y_label, "z");
    ASSERT_EQ(panel.layers.size(), 2u);
    const auto* knots = std::get_if<PolylineLayer>(&panel.layers[1]);
    ASSERT_NE(knots, nullptr);
    EXPECT_EQ(knots->runs.size(),
              std::get<SplineSurface>(std::get<Surface>(made.output)).x_basis().breaks().size());
}

TEST(Picture, OfACurvedReliefHasNodesAlongItsLines) {
    const SplineFunction line({0, 0, 1, 1}, {0.2, 0.7}, 1);
    const CurvedKnotSurface surface(1, {{0, 1}, {0, 1}}, {line}, {}, {0, 0, 1, 1, 0, 0});
    const Panel panel = relief_plot(surface, {0.5}, "ridge");
    const SheetLayer& sheet = std::get<SheetLayer>(panel.layers[0]);
    EXPECT_EQ(sheet.lines.size(), 2u);
    for (std::size_t j = 0; j < sheet.nodes.nv(); ++j) {
        double nearest = 1, highest = 0;
        for (std::size_t i = 0; i < sheet.nodes.nu(); ++i) {
            nearest = std::min(nearest, std::fabs(sheet.nodes(i, j, 0) - line(sheet.nodes(i, j, 1))));
            highest = std::max(highest, sheet.nodes(i, j, 2));
        }
        EXPECT_LT(nearest, 1e-12);
        EXPECT_NEAR(highest, 1, 1e-12) << "the ridge";
    }
}

TEST(Sheet, RefusesLinesBesideIt) {
    SheetLayer sheet = tube();
    sheet.lines.push_back({Points({0, 0, 0, 25}, 2)});
    EXPECT_EQ(code_of_drawing(sheet), "drawing.option");
    sheet.lines.clear();
    sheet.nodes = Grid(1, 5, 3);
    EXPECT_EQ(code_of_drawing(sheet), "drawing.option");
}

TEST(Sheet, LooksTheSameAtAnyScale) {
    const auto drawn = [](double factor) {
        Heights heights = hills(9, 9);
        for (double& x : heights.x) x *= factor;
        for (double& y : heights.y) y *= factor;
        for (std::size_t i = 0; i < 81; ++i) heights.z(i / 9, i % 9) *= factor;
        Drawing drawing;
        drawing.panels = {relief_plot(heights, {{70 * factor}}, "")};
        drawing.panels[0].axes = AxesStyle::hidden;
        return svg(drawing);
    };
    EXPECT_EQ(drawn(1), drawn(1024));
    EXPECT_EQ(drawn(1), drawn(0x1p-20));
}

/// A table of 17 x 17 points of space over u and v.
Outcome faired(const std::function<std::array<double, 3>(double, double)>& at) {
    std::string text = "u,v,x,y,z\n";
    for (double u = 0; u < 17; ++u) {
        for (double v = 0; v < 17; ++v) {
            const std::array<double, 3> p = at(u / 16, v / 16);
            text += format_number(u / 16) + "," + format_number(v / 16);
            for (const double x : p) text += "," + format_number(x);
            text += "\n";
        }
    }
    const Input input{"nodes.csv", Source{"nodes.csv", text}};
    return find_operation("fair-surface")->run({&input, 1}, {}, {});
}

TEST(Picture, OfAFairedSurfaceHasMapsOfBothCurvatures) {
    const Drawing drawing = faired([](double u, double v) {
                                const double wobble = std::sin(997 * u * u + 311 * v);
                                const double z = 0.15 * std::sin(4 * u) * std::cos(3 * v);
                                return std::array{u, v, z + 0.001 * wobble};
                            }).draw();
    ASSERT_EQ(drawing.panels.size(), 4u);
    for (const std::size_t panel : {2u, 3u}) {
        const auto* map = std::get_if<MapLayer>(&drawing.panels[panel].layers[0]);
        ASSERT_NE(map, nullptr);
        EXPECT_EQ(map->ramp, Ramp::diverging);
    }
    EXPECT_TRUE(is_golden("fair_surface.svg", svg(drawing)));
}

TEST(Picture, OfAFairedPlaneAskewSaysThatItIsFlat) {
    const Drawing drawing = faired([](double u, double v) {
                                return std::array{3.3 + 0.7 * u - 0.6 * v, 0.6 * u + 0.7 * v - 1.7,
                                                  0.9 + 0.3 * u + 0.1 * v};
                            }).draw();
    EXPECT_EQ(drawing.panels[2].caption, "Gaussian curvature, faired: 0 everywhere");
    EXPECT_EQ(drawing.panels[3].caption, "mean curvature, faired: 0 everywhere");
}

}  // namespace surface_picture_test
}  // namespace batten::testing
