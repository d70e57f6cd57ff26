#include "batten/base/error.hpp"
#include "batten/shape/surface.hpp"

namespace batten {
namespace {

void require_value(Partial derivative) {
    if (derivative == Partial{}) return;
    throw Error("surface.derivative", "derivative",
                std::to_string(derivative.x) + ',' + std::to_string(derivative.y),
                "a surface with curved knot lines has values only");
}

}  // namespace

Rectangle domain_of(const Surface& surface) {
    return std::visit([](const auto& each) { return Rectangle(each.domain()); }, surface);
}

double height_at(const Surface& surface, double x, double y, Partial derivative) {
    if (const auto* product = std::get_if<SplineSurface>(&surface)) {
        return (*product)(x, y, derivative);
    }
    require_value(derivative);
    return std::get<CurvedKnotSurface>(surface)(x, y);
}

Grid heights_on(const Surface& surface, std::span<const double> x, std::span<const double> y,
                Partial derivative) {
    if (const auto* product = std::get_if<SplineSurface>(&surface)) {
        return product->evaluate(x, y, derivative);
    }
    require_value(derivative);
    const CurvedKnotSurface& curved = std::get<CurvedKnotSurface>(surface);
    Grid z(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) z(i, j) = curved(x[i], y[j]);
    }
    return z;
}

}  // namespace batten
