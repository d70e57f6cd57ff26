#include "make/densify/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "make/densify/bubble.hpp"

namespace batten::lagrange {
namespace {

void require_degree(int degree, const char* option) {
    if (degree < 1 || degree > highest_degree) {
        throw Error("option.range", option, std::to_string(degree),
                    "must be from 1 to " + std::to_string(highest_degree));
    }
}

}  // namespace

CellMaker::CellMaker(PointsView points, const DensifyOptions& options)
    : points_(points),
      windows_{static_cast<std::ptrdiff_t>(points.size()), options.degree,
               options.end_degree.value_or(options.degree), options.closed},
      blend_(options.blend),
      tames_(!options.keep_spikes) {
    require_sound(options);
    const bool by_index =
        options.parameter == LagrangeParameter::index && options.parameter_values.empty();
    if (!by_index) parameters_ = parameters_of(points, options);
    const int highest =
        options.closed ? windows_.degree : std::max(windows_.degree, windows_.end_degree);
    terms_ = static_cast<std::size_t>(highest - 1 + (blend_ ? 1 : 0));
    if (by_index && !blend_) set_uniform();
}

void CellMaker::require_sound(const DensifyOptions& options) const {
    require_degree(windows_.degree, "degree");
    require_degree(windows_.end_degree, "end_degree");
    if (blend_ && std::min(windows_.degree, windows_.end_degree) < 2) {
        throw Error("densify.blend-degree", "degree",
                    std::to_string(std::min(windows_.degree, windows_.end_degree)),
                    "a blend needs polynomials of degree 2 or more");
    }
    const int needed = options.closed ? std::max(windows_.degree + 1, 3)
                                      : std::max(windows_.degree, windows_.end_degree) + 1;
    require_count(points_, static_cast<std::size_t>(needed));
}

const double* CellMaker::at(std::ptrdiff_t point) const {
    const std::ptrdiff_t n = windows_.points;
    const std::ptrdiff_t row = point >= 0 && point < n ? point : (point % n + n) % n;
    return points_.coordinates().data() + row * points_.dim();
}

double CellMaker::parameter(std::ptrdiff_t point) const {
    if (parameters_.empty()) return static_cast<double>(point);
    const std::ptrdiff_t n = windows_.points;
    if (point >= 0 && point < n) return parameters_[static_cast<std::size_t>(point)];
    const std::ptrdiff_t turns = point >= 0 ? point / n : -((n - 1 - point) / n);
    const double period = parameters_.back() - parameters_.front();
    return parameters_[static_cast<std::size_t>(point - turns * n)] +
           static_cast<double>(turns) * period;
}

void CellMaker::set_uniform() {
    const std::ptrdiff_t cells = windows_.cells(), back = (windows_.degree - 1) / 2;
    if (static_cast<std::size_t>(windows_.degree - 1) != terms_) return;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(back, 1);
    const std::ptrdiff_t last =
        std::min<std::ptrdiff_t>(cells - 1, windows_.points - windows_.degree + back);
    if (last <= first) return;
    uniform_.first = static_cast<std::size_t>(first);
    uniform_.last = static_cast<std::size_t>(last);
    uniform_.recipe = recipe(uniform_.first, windows_.of_cell(first));
}

Recipe CellMaker::recipe(std::size_t cell, Window window) const {
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(cell);
    std::array<double, highest_degree + 1> nodes;
    for (int i = 0; i <= window.degree; ++i) {
        nodes[static_cast<std::size_t>(i)] = parameter(window.first + i);
    }
    return recipe_of({nodes.data(), static_cast<std::size_t>(window.degree) + 1},
                     static_cast<int>(start - window.first));
}

Recipe CellMaker::recipe_by_length(std::size_t cell, Window window,
                                   LagrangeParameter parameter) const {
    Points rows(0, points_.dim());
    for (int i = 0; i <= window.degree; ++i) rows.push_back({at(window.first + i), dim()});
    return recipe_of(cumulative(rows, parameter, false),
                     static_cast<int>(static_cast<std::ptrdiff_t>(cell) - window.first));
}

void CellMaker::apply(const Recipe& recipe, std::size_t cell, std::span<double> g) const {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(cell);
    make_bubble(
        RunTimeSize{static_cast<std::size_t>(recipe.terms), dim()}, recipe, start(cell), end(cell),
        [&](std::size_t i) { return at(first + recipe.other[i]); }, g.data());
}

void CellMaker::make_with(std::size_t cell, const LagrangeParameter* others,
                          std::span<double> g) const {
    const auto recipe_for = [&](Window window) {
        return others ? recipe_by_length(cell, window, *others) : recipe(cell, window);
    };
    std::fill(g.begin(), g.end(), 0.0);
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(cell);
    if (!blend_) return apply(recipe_for(windows_.of_cell(k)), cell, g);
    // (1 - s) g_left + s g_right
    std::vector<double> left(g.size()), right(g.size());
    const std::ptrdiff_t next = windows_.closed ? k + 1 : std::min(k + 1, windows_.points - 1);
    apply(recipe_for(windows_.of_point(k)), cell, left);
    apply(recipe_for(windows_.of_point(next)), cell, right);
    for (std::size_t i = 0; i < g.size(); ++i) {
        g[i] = left[i];
        if (i >= dim()) g[i] += right[i - dim()] - left[i - dim()];
    }
}

void CellMaker::require_sound_ends(std::size_t cell) const {
    const double *p = start(cell), *q = end(cell);
    bool finite = true;
    for (std::size_t k = 0; k < dim(); ++k) {
        finite = finite && std::isfinite(p[k]) && std::isfinite(q[k]);
    }
    if (!finite) require_finite(points_);
    if (std::equal(p, p + dim(), q)) require_distinct(points_, windows_.closed);
}

void CellMaker::require_finite_curve(std::size_t cell, std::span<const double> g) const {
    bool finite = true;
    for (std::size_t k = 0; k < dim(); ++k) {
        double sum = std::fabs(start(cell)[k]) + std::fabs(end(cell)[k] - start(cell)[k]);
        for (std::size_t j = 0; j < terms_; ++j) sum += std::fabs(g[j * dim() + k]);
        finite = finite && std::isfinite(sum);
    }
    if (!finite) {
        throw Error("number.overflow", "cell " + std::to_string(cell), "beyond a double",
                    "scale the points down or spread them out");
    }
}

bool CellMaker::is_tame(std::size_t cell, std::span<const double> g) const {
    const double *p = start(cell), *q = end(cell);
    if (is_surely_tame(RunTimeSize{terms_, dim()}, p, q, g.data())) return true;
    constexpr int steps = 16;
    double scale = 0;  // so that no square is lost or infinite
    for (std::size_t k = 0; k < dim(); ++k) scale = std::fmax(scale, std::fabs(q[k] - p[k]));
    for (int i = 1; i < steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        double off_sq = 0, chord_sq = 0;
        for (std::size_t k = 0; k < dim(); ++k) {
            const double d = (q[k] - p[k]) / scale;
            double value = 0;
            for (std::size_t j = terms_; j-- > 0;) value = value * s + g[j * dim() + k] / scale;
            const double off = (s - 0.5) * d - s * (1 - s) * value;
            off_sq += off * off;
            chord_sq += d * d;
        }
        if (!(off_sq <= chord_sq)) return false;
    }
    return true;
}

bool CellMaker::make(std::size_t cell, std::span<double> g) const {
    require_sound_ends(cell);
    make_with(cell, nullptr, g);
    const bool as_asked = !tames_ || is_tame(cell, g);
    if (!as_asked) tame(cell, g);
    require_finite_curve(cell, g);
    return as_asked;
}

void CellMaker::tame(std::size_t cell, std::span<double> g) const {
    for (const LagrangeParameter other :
         {LagrangeParameter::centripetal, LagrangeParameter::chord}) {
        make_with(cell, &other, g);
        if (is_tame(cell, g)) return;
    }
    std::fill(g.begin(), g.end(), 0.0);
}

}  // namespace batten::lagrange
