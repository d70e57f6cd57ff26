#pragma once

#include <vector>

#include "batten/make/fit_surface.hpp"
#include "batten/shape/curved_knot_surface.hpp"

namespace batten::surface_fitting {

/// Samples with x and y exchanged.
class ExchangedSamples {
public:
    explicit ExchangedSamples(const SurfaceSamples& given);

    SurfaceSamples view() const {
        return {given_.y, given_.x, z_, given_.y_sigma, given_.x_sigma, sigma_};
    }

private:
    SurfaceSamples given_;
    Grid z_;
    std::vector<double> sigma_;
};

/// The surface with x and y exchanged.
CurvedKnotSurface exchanged(const CurvedKnotSurface& surface);

}  // namespace batten::surface_fitting
