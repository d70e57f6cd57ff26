#include "shape/surface/sheet.hpp"

#include <algorithm>

namespace batten::surfaces {
namespace {

constexpr std::size_t places_a_piece = 5;  // where lines are looked at for whether they part

bool has_kinks(const BSplineBasis& basis) {
    const std::span<const double> knots = basis.knots();
    const std::size_t degree = static_cast<std::size_t>(basis.degree());
    if (degree == 0) return true;
    for (std::size_t i = degree + 1; i + 2 * degree < knots.size(); ++i) {
        const bool is_inside = knots[i] > knots[degree] && knots[i] < knots[knots.size() - degree - 1];
        if (is_inside && knots[i] == knots[i + degree - 1]) return true;
    }
    return false;
}

}  // namespace

Sheet::Sheet(const SplineSurface& surface) : product_(&surface) { find_intervals(); }

Sheet::Sheet(const CurvedKnotSurface& surface) : curved_(&surface) {
    if (are_straight(surface.x_lines()) && !are_straight(surface.y_lines())) {
        transposed_ = std::make_shared<const CurvedKnotSurface>(surface.transposed());
        curved_ = transposed_.get();
    }
    find_intervals();
}

Sheet::Sheet(const Surface& surface)
    : Sheet(std::visit([](const auto& each) { return Sheet(each); }, surface)) {}

Rectangle Sheet::domain() const { return product_ ? product_->domain() : curved_->domain(); }

int Sheet::degree() const {
    if (!product_) return curved_->degree();
    return std::min(product_->x_basis().degree(), product_->y_basis().degree());
}

bool Sheet::has_kinks() const {
    if (!product_) return degree() <= 1;
    return surfaces::has_kinks(product_->x_basis()) || surfaces::has_kinks(product_->y_basis());
}

std::vector<double> Sheet::knots(double y) const {
    if (!product_) return curved_->x_knots(y);
    return {product_->x_basis().breaks().begin(), product_->x_basis().breaks().end()};
}

std::vector<double> Sheet::strips() const {
    if (product_) return {product_->y_basis().breaks().begin(), product_->y_basis().breaks().end()};
    const Interval domain = curved_->domain().y;
    std::vector<double> places{domain.lo, domain.hi};
    for (const SplineFunction& line : curved_->y_lines()) {
        if (are_straight({&line, 1})) places.push_back(domain.clamp(line.coefficients()[0]));
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

void Sheet::find_intervals() {
    if (product_) {
        for (std::size_t i = 0; i + 1 < product_->x_basis().breaks().size(); ++i) {
            intervals_.push_back(i);
        }
        return;
    }
    std::vector<double> places = strips();
    for (const SplineFunction& line : curved_->x_lines()) {
        places.insert(places.end(), line.breaks().begin(), line.breaks().end());
    }
    std::sort(places.begin(), places.end());
    std::vector<char> is_open(curved_->x_lines().size() + 1, 0);
    for (std::size_t p = 0; p + 1 < places.size(); ++p) {
        for (const double y : even_places({places[p], places[p + 1]}, places_a_piece)) {
            const std::vector<double> at = knots(y);
            for (std::size_t i = 0; i + 1 < at.size(); ++i) is_open[i] |= at[i] < at[i + 1];
        }
    }
    for (std::size_t i = 0; i < is_open.size(); ++i) {
        if (is_open[i]) intervals_.push_back(i);
    }
}

std::vector<SheetLine> Sheet::lines(std::span<const std::size_t> each) const {
    std::vector<SheetLine> result;
    for (std::size_t k = 0; k < intervals_.size(); ++k) {
        for (std::size_t j = 0; j < each[k]; ++j) {
            const double share = static_cast<double>(j) / static_cast<double>(each[k]);
            result.push_back({intervals_[k], share});
        }
        const bool is_last = k + 1 == intervals_.size();
        const bool is_wall = !is_last && !product_ && static_cast<int>(intervals_[k + 1] -
                                                                       intervals_[k]) > degree();
        if (is_last || is_wall) result.push_back({intervals_[k], 1});
    }
    return result;
}

double Sheet::place(const SheetLine& line, std::span<const double> knots) {
    const double lo = knots[line.interval], hi = knots[line.interval + 1];
    return line.share == 1 ? hi : lo + line.share * (hi - lo);
}

std::size_t Sheet::home_of(std::span<const SheetLine> lines, std::size_t c,
                           std::span<const double> knots) {
    const auto is_open = [&](std::size_t i) { return knots[i] < knots[i + 1]; };
    const std::size_t own = lines[c].interval;
    if (is_open(own) || c == 0 || column_after(lines[c - 1]).is_wall) return own;
    const std::size_t before = lines[c - 1].interval;
    return is_open(before) ? before : own;
}

double Sheet::along(double x, double from, double to) const {
    if (product_) return x;
    const std::vector<double> at = knots(from);
    const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, x);
    const std::size_t interval = static_cast<std::size_t>(above - at.begin()) - 1;
    const double width = at[interval + 1] - at[interval];
    const double share = width > 0 ? (x - at[interval]) / width : 0;
    return place({interval, share}, knots(to));
}

double Sheet::value_in(std::size_t interval, double x, double y) const {
    return product_ ? (*product_)(x, y) : curved_->value_in({interval, KnotCell::found}, x, y);
}

HeightJet Sheet::jet_in(std::size_t interval, double x, double y) const {
    return product_ ? product_->jet(x, y) : curved_->jet_in({interval, KnotCell::found}, x, y);
}

Grid Sheet::heights(std::span<const SheetLine> lines, std::span<const double> y) const {
    if (product_) {
        std::vector<double> x;
        for (const SheetLine& line : lines) x.push_back(place(line, product_->x_basis().breaks()));
        return product_->evaluate(x, y);
    }
    Grid z(lines.size(), y.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
        const std::vector<double> at = knots(y[j]);
        for (std::size_t c = 0; c < lines.size(); ++c) {
            z(c, j) = value_in(home_of(lines, c, at), place(lines[c], at), y[j]);
        }
    }
    return z;
}

}  // namespace batten::surfaces
