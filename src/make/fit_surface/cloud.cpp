#include "make/fit_surface/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/cloud_system.hpp"
#include "make/fit_surface/mixed_noise.hpp"

namespace batten::surface_fitting {
namespace {

void require_cloud(const ScatteredSamples& given) {
    const std::size_t n = given.x.size();
    if (given.y.size() != n || given.z.size() != n ||
        (!given.sigma.empty() && given.sigma.size() != n)) {
        throw Error("fit-surface.sizes", "samples", std::to_string(n) + " places",
                    "there are as many x, y, heights and errors");
    }
    const struct {
        std::span<const double> values;
        const char* name;
    } columns[] = {{given.x, "x"}, {given.y, "y"}, {given.z, "z"}};
    for (const auto& column : columns) {
        for (std::size_t i = 0; i < n; ++i) {
            if (std::isfinite(column.values[i])) continue;
            throw Error("points.not-finite", std::string("column ") + column.name,
                        format_number(column.values[i]), "coordinates must be finite", {i});
        }
    }
    for (std::size_t i = 0; i < given.sigma.size(); ++i) {
        if (given.sigma[i] > 0) continue;
        throw Error("fit.sigma", "sigma", format_number(given.sigma[i]), "errors must be above 0",
                    {i});
    }
}

Interval range_of_values(std::span<const double> values, const char* name) {
    if (values.size() < 2) {
        throw Error("fit.too-few", "samples", std::to_string(values.size()),
                    "at least two samples are needed");
    }
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    if (*least < *largest) return {*least, *largest};
    throw Error("fit.x-equal", name, format_number(*least), "the places are not all on one line");
}

void measure(const Cloud& cloud, const std::vector<double>& e, Misfit& misfit) {
    Psi beyond{};
    for (std::size_t n = 0; n < e.size(); ++n) {
        const double size = std::fabs(e[n]);
        misfit.delta2 += size * size;
        misfit.max_residual = std::max(misfit.max_residual, size / cloud.weight[n]);
        for (int w = 1; w <= psi_count && size > w; ++w) {
            beyond[static_cast<std::size_t>(w - 1)] += 1;
        }
    }
    const double count = static_cast<double>(e.size());
    for (std::size_t w = 0; w < psi_count; ++w) misfit.psi[w] = (count - beyond[w]) / count;
}

}  // namespace

Cloud prepared_cloud(const ScatteredSamples& given, const FitSurfaceOptions& options) {
    require_cloud(given);
    Cloud cloud{given.x, given.y, given.z, std::vector<double>(given.x.size(), 1.0),
                {range_of_values(given.x, "x"), range_of_values(given.y, "y")}};
    if (!given.sigma.empty()) {
        for (std::size_t i = 0; i < given.sigma.size(); ++i) cloud.weight[i] = 1 / given.sigma[i];
        cloud.source = SigmaSource::column;
        cloud.sigma_known = true;
    } else if (options.sigma) {
        std::fill(cloud.weight.begin(), cloud.weight.end(), 1 / *options.sigma);
        cloud.source = SigmaSource::number;
        cloud.sigma_known = true;
        cloud.sigma = options.sigma;
    } else {
        double largest = 0;
        for (const double z : given.z) largest = std::max(largest, std::fabs(z));
        cloud.least_delta2 = unavoidable_delta2(cloud.count(), direct_accuracy, largest, 1);
    }
    return cloud;
}

CloudFit fit_cloud(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y,
                   StripRule rule) {
    CloudSystem system(cloud, x, y);
    CloudFit fit = system.solved();
    const std::vector<double> e = system.weighted_residuals(fit.solution.coefficients);
    measure(cloud, e, fit.misfit);
    fit.misfit.x_strips = system.strips(e, x, true, rule);
    fit.misfit.y_strips = system.strips(e, y, false, rule);
    return fit;
}

}  // namespace batten::surface_fitting
