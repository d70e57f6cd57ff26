#include "make/fit_surface/exchanged.hpp"

namespace batten::surface_fitting {

ExchangedSamples::ExchangedSamples(const SurfaceSamples& given)
    : given_(given), z_(given.z.nv(), given.z.nu()) {
    const std::size_t m = given.z.nu(), n = given.z.nv();
    if (!given.sigma.empty()) sigma_.resize(m * n);
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (given.z.has(i, j)) z_(j, i) = given.z(i, j);
            else z_.drop(j, i);
            if (!sigma_.empty()) sigma_[j * m + i] = given.sigma[i * n + j];
        }
    }
}

CurvedKnotSurface exchanged(const CurvedKnotSurface& surface) {
    const std::size_t order = static_cast<std::size_t>(surface.degree()) + 1;
    const std::size_t p = surface.x_lines().size() + order, q = surface.y_lines().size() + order;
    std::vector<double> c(p * q);
    for (std::size_t i = 0; i < p; ++i) {
        for (std::size_t j = 0; j < q; ++j) c[j * p + i] = surface.coefficients()[i * q + j];
    }
    return {surface.degree(), {surface.domain().y, surface.domain().x},
            {surface.y_lines().begin(), surface.y_lines().end()},
            {surface.x_lines().begin(), surface.x_lines().end()}, std::move(c)};
}

}  // namespace batten::surface_fitting
