/// How often a front is seen where there is none: fit_front on heights of a smooth surface under
/// fresh normal noise, one seed after another.
///
/// usage: front_null GRID.csv SIGMA SEEDS; the grid's own automatic spline is the truth.
#include <cstdio>
#include <random>
#include <string>

#include "batten/base/text.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/make/fit_front.hpp"

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    using namespace batten;
    const GridFile file = read_grid(argv[1]);
    const double sigma = *parse_number(argv[2]);
    const int seeds = std::stoi(argv[3]);
    FitSurfaceOptions smooth;
    smooth.sigma = sigma;
    const Grid truth =
        fit_surface({file.x, file.y, file.z}, smooth).surface.evaluate(file.x, file.y);
    FitFrontOptions options;
    options.sigma = sigma;
    int seen = fit_front({file.x, file.y, file.z}, options).report.has_front;
    for (int seed = 1; seed < seeds; ++seed) {
        std::mt19937_64 engine(static_cast<std::uint64_t>(seed));
        std::normal_distribution<double> noise(0, sigma);
        Grid z = truth;
        for (std::size_t i = 0; i < z.nu(); ++i) {
            for (std::size_t j = 0; j < z.nv(); ++j) z(i, j) += noise(engine);
        }
        const FrontReport report = fit_front({file.x, file.y, z}, options).report;
        if (report.has_front) std::printf("seed %d: bic %g against %g\n", seed, report.bic, *report.tensor_bic);
        seen += report.has_front;
    }
    std::printf("a front is seen in %d of %d\n", seen, seeds);
    return 0;
}
