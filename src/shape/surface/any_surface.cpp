#include "batten/shape/surface.hpp"

namespace batten {

Rectangle domain_of(const Surface& surface) {
    return std::visit([](const auto& each) { return Rectangle(each.domain()); }, surface);
}

double height_at(const Surface& surface, double x, double y, Partial derivative) {
    return std::visit([&](const auto& each) { return each(x, y, derivative); }, surface);
}

HeightJet jet_at(const Surface& surface, double x, double y) {
    return std::visit([&](const auto& each) { return each.jet(x, y); }, surface);
}

Grid heights_on(const Surface& surface, std::span<const double> x, std::span<const double> y,
                Partial derivative) {
    if (const auto* product = std::get_if<SplineSurface>(&surface)) {
        return product->evaluate(x, y, derivative);
    }
    const CurvedKnotSurface& curved = std::get<CurvedKnotSurface>(surface);
    Grid z(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) z(i, j) = curved(x[i], y[j], derivative);
    }
    return z;
}

double integral(const Surface& surface, const Rectangle& part) {
    return std::visit([&](const auto& each) { return integral(each, part); }, surface);
}

SplineFunction section_at_y(const Surface& surface, double y) {
    return std::visit([&](const auto& each) { return section_at_y(each, y); }, surface);
}

SplineFunction section_at_x(const Surface& surface, double x) {
    return std::visit([&](const auto& each) { return section_at_x(each, x); }, surface);
}

}  // namespace batten
