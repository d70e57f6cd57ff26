#include "batten/make/fit_surface_chunks.hpp"
#include "errors.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace fit_surface_bad_test {

using namespace testing;

SurfaceTable plain() {
    return surface_of([](double x, double y) { return x * y; }, 9, 8);
}

std::string refused(const SurfaceSamples& samples, const FitSurfaceOptions& options = {}) {
    return code_of([&] { fit_surface(samples, options); });
}

TEST(BadSurface, AxesThatDoNotRiseAreRefused) {
    SurfaceTable table = plain();
    table.x[3] = table.x[2];
    EXPECT_EQ(refused(table.view()), "fit-surface.axis");
    table.x[3] = nan;
    EXPECT_EQ(refused(table.view()), "points.not-finite");
    SurfaceTable one = plain();
    one.x.resize(1);
    one.z = Grid(1, 8);
    EXPECT_EQ(refused(one.view()), "fit-surface.axis");
}

TEST(BadSurface, WrongSizesAreRefused) {
    SurfaceTable table = plain();
    table.x.push_back(2);
    EXPECT_EQ(refused(table.view()), "fit-surface.sizes");
    SurfaceTable errors = plain();
    errors.sigma.assign(5, 1.0);
    EXPECT_EQ(refused(errors.view()), "fit-surface.sizes");
    errors.sigma.assign(72, 1.0);
    errors.sigma[7] = 0;
    EXPECT_EQ(refused(errors.view()), "fit.sigma");
    errors.sigma[7] = nan;
    EXPECT_EQ(refused(errors.view()), "fit.sigma");
}

TEST(BadSurface, HeightsThatAreNoNumbersAreRefused) {
    SurfaceTable table = plain();
    table.z(2, 2) = nan;
    EXPECT_EQ(refused(table.view()), "points.not-finite");
    table.z.drop(2, 2);
    EXPECT_EQ(refused(table.view()), "none");
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < 8; ++j) table.z.drop(i, j);
    }
    EXPECT_EQ(refused(table.view()), "fit.too-few");
}

TEST(BadSurface, StripsBeyondTheDataAreRefused) {
    const SurfaceTable table = plain();
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    options.intervals = {7, 2};
    EXPECT_EQ(refused(table.view(), options), "fit.too-few");
    options.intervals = {2};
    EXPECT_EQ(refused(table.view(), options), "fit.intervals");
    options.intervals = {2, 1.5};
    EXPECT_EQ(refused(table.view(), options), "fit.intervals");
    options.intervals = {};
    options.x_knots = {0.5, 0.4};
    EXPECT_EQ(refused(table.view(), options), "fit.knots");
    options.x_knots = {0.5, 1.5};
    EXPECT_EQ(refused(table.view(), options), "fit.knots");
    options.x_knots = {0.5};
    EXPECT_EQ(refused(table.view(), options), "none");
    options.intervals = {2, 2};
    EXPECT_EQ(refused(table.view(), options), "fit.options");
    FitSurfaceOptions chances;
    chances.stop = StopRule::distribution;
    chances.distribution = {0.9, 0.5};
    EXPECT_EQ(refused(table.view(), chances), "fit.distribution");
}

TEST(BadSurface, OptionsThatContradictEachOtherAreRefused) {
    const SurfaceTable table = plain();
    const auto place = [&](auto&& change) {
        FitSurfaceOptions options;
        change(options);
        return code_and_place_of([&] { fit_surface(table.view(), options); });
    };
    using Options = FitSurfaceOptions;
    EXPECT_EQ(place([](Options& o) { o.distribution = {0.68}; }), "fit.options distribution");
    EXPECT_EQ(place([](Options& o) { o.stop = StopRule::none; }), "fit.options stop");
    EXPECT_EQ(place([](Options& o) {
                  o.intervals = {2, 2};
                  o.delta2 = 3;
              }), "fit.options delta2");
    EXPECT_EQ(place([](Options& o) {
                  o.x_knots = {0.5};
                  o.delta2 = 3;
              }), "fit.options delta2");
    EXPECT_EQ(place([](Options& o) {
                  o.knots = SurfaceKnots::given;
                  o.intervals = {2, 2};
              }), "fit.options intervals");
    EXPECT_EQ(place([](Options& o) { o.knots = SurfaceKnots::curved; }), "fit.options knots");
}

TEST(BadSurface, NumbersBeyondADoubleAreRefused) {
    SurfaceTable table = surface_of([](double x, double y) { return x < 0.5 ? 1e308 : -1e308 * y; },
                                    9, 8);
    FitSurfaceOptions options;
    options.sigma = 1;
    EXPECT_EQ(refused(table.view(), options), "number.overflow");
}

TEST(BadSurfaceChunk, TakesNothingInThatDoesNotBelongToIt) {
    const SurfaceTable table = plain();
    const std::span<const double> z = table.z.view().values();
    const BSplineBasis x = BSplineBasis::over(std::vector<double>{0, 0.5, 1}, 3);
    const BSplineBasis y = BSplineBasis::over(std::vector<double>{0, 1}, 3);
    SurfaceChunk chunk(x, y, {table.y});
    const auto code = [&](const SurfaceRows& rows, double sigma = 1) {
        return code_of([&] { chunk.add(rows, sigma); });
    };
    const std::vector<double> one(1, 1.0), beyond{1.5}, falling{0.5, 0.25}, nothing{nan};
    EXPECT_EQ(code({table.x, z.first(71)}), "fit-surface.sizes");
    EXPECT_EQ(code({table.x, z, one}), "fit-surface.sizes");
    EXPECT_EQ(code({table.x, z}, 0), "fit.sigma");
    EXPECT_EQ(code({beyond, z.first(8)}), "fit.outside");
    EXPECT_EQ(code({falling, z.first(16)}), "fit-surface.axis");
    EXPECT_EQ(code({nothing, z.first(8)}), "points.not-finite");
    SurfaceTable holed = plain();
    holed.z(8, 7) = nan;
    EXPECT_EQ(code({holed.x, holed.z.view().values()}), "points.not-finite");
    EXPECT_EQ(chunk.samples(), 0u);
    EXPECT_EQ(code_of([&] { chunk.solve(); }), "fit.too-few");
    EXPECT_EQ(code_of([&] { chunk.merge(SurfaceChunk(y, y, {table.y})); }), "fit.chunks-differ");
    EXPECT_EQ(code_of([&] { SurfaceChunk(x, y, {{0.5}}); }), "fit-surface.axis");
    EXPECT_EQ(code_of([&] { SurfaceChunk(x, y, {{0.5, 2}}); }), "fit.outside");
    EXPECT_EQ(code_of([&] { SurfaceChunk(x, y, {{0, 1}, {1, 1, 1}}); }), "fit-surface.sizes");
    EXPECT_EQ(code({table.x, z}), "none");
    EXPECT_EQ(chunk.samples(), 72u);
}

/// The heights x + 2 y; number `bad` is infinite.
SurfaceStream plane(std::span<const double> x, std::span<const double> y, std::size_t bad) {
    return {x, y, [=](std::size_t first, std::span<double> z) {
                for (std::size_t k = 0; k < z.size(); ++k) {
                    const std::size_t at = first * y.size() + k;
                    z[k] = at == bad ? std::numeric_limits<double>::infinity()
                                     : x[at / y.size()] + 2 * y[at % y.size()];
                }
            }};
}

constexpr std::size_t none_bad = std::size_t(-1);

TEST(BadSurfaceStream, TakesOnlyWhatNeedsNotAllHeightsAtOnce) {
    const std::vector<double> x = even_places({0, 1}, 250), y = even_places({0, 1}, 200);
    const auto code = [&](FitSurfaceOptions options) {
        options.sigma = 0.01;
        return code_of([&] { fit_surface(plane(x, y, none_bad), options); });
    };
    EXPECT_EQ(code({}), "none");
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    EXPECT_EQ(code(options), "fit-surface.streamed");
    options.intervals = {2, 2};
    EXPECT_EQ(code(options), "none");
    options.intervals = {300, 2};
    EXPECT_EQ(code(options), "fit.too-few");
    options.intervals = {};
    options.x_knots = {0.5};
    EXPECT_EQ(code(options), "none");
    options.knots = SurfaceKnots::free;
    EXPECT_EQ(code(options), "fit-surface.streamed");
    options = {};
    options.rule = StripRule::marginal;
    EXPECT_EQ(code(options), "fit-surface.streamed");
    options = {};
    options.stop = StopRule::distribution;
    EXPECT_EQ(code(options), "fit-surface.streamed");
    options = {};
    options.degree = 0;
    EXPECT_EQ(code(options), "fit-surface.streamed");
    options.degree = 9;
    EXPECT_EQ(code(options), "none");
}

TEST(BadSurfaceStream, NamesTheNodeThatIsNone) {
    const std::vector<double> x = even_places({0, 1}, 250), y = even_places({0, 1}, 200);
    SurfaceStream stream = plane(x, y, 123 * 200 + 45);
    stream.rows_at_once = 7;
    try {
        fit_surface(stream, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "points.not-finite");
        EXPECT_EQ(error.place(), "node 123,45");
    }
}

TEST(BadSurfaceStream, NeedsMoreLinesThanTheDegree) {
    const std::vector<double> x = even_places({0, 1}, 30'000), y{0, 1, 2};
    FitSurfaceOptions options;
    options.sigma = 0.01;
    const auto code = [&] {
        return code_of([&] { fit_surface(plane(x, y, none_bad), options); });
    };
    EXPECT_EQ(code(), "fit.too-few");
    options.degree = 2;
    EXPECT_EQ(code(), "none");
}

}  // namespace fit_surface_bad_test
}  // namespace batten
