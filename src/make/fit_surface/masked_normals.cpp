#include "make/fit_surface/masked_normals.hpp"

#include <algorithm>

#include "num/rows.hpp"

namespace batten::surface_fitting {

MaskedRow::MaskedRow(const Axis& y)
    : products(y.functions()), gram(y.functions() * static_cast<std::size_t>(y.plain().order)),
      y_(y), heights_(y.plain().places()) {
    for (std::size_t s = 0; s < heights_.size(); s = runs_.back().last) {
        runs_.push_back(run_from(s));
    }
}

MaskedRow::Run MaskedRow::run_from(std::size_t first) const {
    const num::TensorSide &weighted = y_.weighted(), &normal = y_.normal();
    const std::size_t order = static_cast<std::size_t>(normal.order);
    Run run{first, first, {}, {}, {}};
    while (run.last < normal.places() && normal.first[run.last] == normal.first[first]) ++run.last;
    for (std::size_t j = 0; j < order; ++j) {
        for (std::size_t s = first; s < run.last; ++s) run.values.push_back(normal.at(s)[j]);
    }
    for (std::size_t b = 0; b < order; ++b) {
        for (std::size_t j = 0; j + b < order; ++j) {
            double sum = 0;
            for (std::size_t s = first; s < run.last; ++s) {
                run.pairs.push_back(weighted.at(s)[j] * weighted.at(s)[j + b]);
                sum += run.pairs.back();
            }
            run.whole.push_back(sum);
        }
    }
    return run;
}

void MaskedRow::take(std::span<const double> z, std::span<const double> factor_sq) {
    const std::size_t order = static_cast<std::size_t>(y_.plain().order), width = y_.functions();
    std::fill(products.begin(), products.end(), 0.0);
    std::fill(gram.begin(), gram.end(), 0.0);
    for (std::size_t s = 0; s < z.size(); ++s) heights_[s] = factor_sq[s] * z[s];
    for (const Run& run : runs_) {
        const std::size_t first = y_.plain().first[run.first], count = run.last - run.first;
        const std::span<const double> factors = factor_sq.subspan(run.first, count);
        num::add_dots(run.values, std::span(heights_).subspan(run.first, count),
                      std::span(products).subspan(first, order));
        if (std::all_of(factors.begin(), factors.end(), [](double f) { return f == 1; })) {
            sums_ = run.whole;
        } else {
            sums_.assign(run.whole.size(), 0.0);
            num::add_dots(run.pairs, factors, sums_);
        }
        const double* from = sums_.data();
        for (std::size_t b = 0; b < order; ++b) {
            for (std::size_t j = 0; j + b < order; ++j) gram[b * width + first + j] += *from++;
        }
    }
}

void add_band_product(const double* gram, std::size_t order, std::span<const double> c,
                      std::span<double> to) {
    const std::size_t functions = c.size();
    for (std::size_t b = 0; b < std::min(order, functions); ++b) {
        const double* const band = gram + b * functions;
        for (std::size_t j = 0; j + b < functions; ++j) to[j] += band[j] * c[j + b];
        if (b == 0) continue;
        for (std::size_t j = 0; j + b < functions; ++j) to[j + b] += band[j] * c[j];
    }
}

MaskedNormals::MaskedNormals(const Axis& x, const Axis& y)
    : x_(x), y_(y), order_(static_cast<std::size_t>(y.plain().order)), row_(y),
      products_(x.functions() * y.functions(), 0.0),
      matrix_(x.functions() * static_cast<std::size_t>(x.plain().order) * y.functions() * order_,
              0.0) {}

void MaskedNormals::add(const MaskedRows& rows, const Visit& visit) {
    const num::TensorSide &plain = x_.weighted(), &normal = x_.normal();
    const std::size_t width = y_.basis().size(), band = width * order_;
    const std::size_t x_order = static_cast<std::size_t>(plain.order);
    const std::size_t columns = y_.plain().places();
    for (std::size_t at = 0; at < rows.z.size(); at += columns) {
        const std::size_t r = rows.first + at / columns, i = plain.first[r];
        row_.take(rows.z.subspan(at, columns), rows.factor_sq.subspan(at, columns));
        if (visit) visit(r, row_);
        for (std::size_t k = 0; k < x_order; ++k) {
            num::add_times(normal.at(r)[k], row_.products,
                           std::span(products_).subspan((i + k) * width, width));
            for (std::size_t a = 0; k + a < x_order; ++a) {
                num::add_times(plain.at(r)[k] * plain.at(r)[k + a], row_.gram,
                               std::span(matrix_).subspan(((i + k) * x_order + a) * band, band));
            }
        }
    }
}

std::vector<double> MaskedNormals::times(std::span<const double> c) const {
    std::vector<double> result(c.size(), 0.0);
    const std::size_t width = y_.functions(), functions = x_.functions();
    const std::size_t x_order = static_cast<std::size_t>(x_.plain().order);
    const auto row = [&](std::size_t i) { return std::span(result).subspan(i * width, width); };
    for (std::size_t i = 0; i < functions; ++i) {
        for (std::size_t a = 0; a < std::min(x_order, functions - i); ++a) {
            const double* const gram = matrix_.data() + (i * x_order + a) * width * order_;
            add_band_product(gram, order_, c.subspan((i + a) * width, width), row(i));
            if (a > 0) add_band_product(gram, order_, c.subspan(i * width, width), row(i + a));
        }
    }
    return result;
}

Solution MaskedNormals::solution(int steps) const {
    return conjugate_gradients(
        products_, [this](const std::vector<double>& c) { return times(c); }, x_, y_, steps);
}

std::vector<double> MaskedNormals::diagonal() const {
    std::vector<double> result;
    const std::size_t width = y_.functions();
    const std::size_t x_order = static_cast<std::size_t>(x_.plain().order);
    for (std::size_t i = 0; i < x_.functions(); ++i) {
        const auto from = matrix_.begin() +
                          static_cast<std::ptrdiff_t>(i * x_order * width * order_);
        result.insert(result.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
    return result;
}

}  // namespace batten::surface_fitting
