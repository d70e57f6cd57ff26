#include "make/fit/knot_system.hpp"

#include <algorithm>
#include <limits>

#include "make/fit/smooth_equations.hpp"
#include "num/clones.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

/// R B and the sides beside it. Unrolls where k and width are known beforehand.
BATTEN_INLINE void multiply(const double* b, const double* triangle, int k, int width,
                            double* block) {
    for (int i = 0; i < k; ++i) {
        double row[num::most_order];
        for (int j = 0; j < k; ++j) row[j] = 0;
        for (int l = i; l < k; ++l) {
            const double r = triangle[i * width + l];
            for (int j = 0; j < k; ++j) row[j] += r * b[l * k + j];
        }
        std::copy_n(row, k, block + i * width);
        for (int s = k; s < width; ++s) block[i * width + s] = triangle[i * width + s];
    }
}

}  // namespace

std::vector<double> open_knots(Interval domain, std::span<const double> inside, int order) {
    std::vector<double> knots(static_cast<std::size_t>(order), domain.lo);
    knots.insert(knots.end(), inside.begin(), inside.end());
    knots.insert(knots.end(), static_cast<std::size_t>(order), domain.hi);
    return knots;
}

std::vector<double> closed_knots(std::span<const double> breaks, int order) {
    const double period = breaks.back() - breaks.front();
    const int n = static_cast<int>(breaks.size()) - 1;
    std::vector<double> knots;
    for (int i = 1 - order; i <= n + order - 1; ++i) {
        const int turn = i >= 0 ? i / n : -((n - 1 - i) / n);
        const int at = i - turn * n;
        const bool is_end = i == n;
        knots.push_back(is_end ? breaks.back()
                               : breaks[static_cast<std::size_t>(at)] + turn * period);
    }
    return knots;
}

std::vector<std::size_t> spans_of(std::span<const double> knots, int order) {
    std::vector<std::size_t> spans;
    const std::size_t last = knots.size() - static_cast<std::size_t>(order);
    for (std::size_t s = static_cast<std::size_t>(order) - 1; s < last; ++s) {
        if (knots[s] < knots[s + 1]) spans.push_back(s);
    }
    return spans;
}

void KnotSystem::to_chebyshev(std::span<const double> knots, std::size_t span, double* b) const {
    to_chebyshev(knots, span, {knots[span], knots[span + 1]}, b);
}

void KnotSystem::to_chebyshev(std::span<const double> knots, std::size_t span, Interval part,
                              double* b) const {
    const int k = shape_.order;
    double x[num::most_order];
    double values[num::most_order * num::most_order];
    const double half = 0.5 * part.length();
    const double middle = part.lo + half;
    for (int i = 0; i < k; ++i) x[i] = middle + half * basis_->nodes()[static_cast<std::size_t>(i)];
    num::basis_values_at(knots, span, k, x, k, values);
    basis_->coefficients(values, k, b);
}

void KnotSystem::make_block(std::span<const double> knots, std::size_t span,
                            const double* triangle, double* block) const {
    double b[num::most_order * num::most_order];
    to_chebyshev(knots, span, b);
    make_block_from(b, triangle, block);
}

void KnotSystem::make_block_from(const double* b, const double* triangle, double* block) const {
    if (shape_.order == 4 && shape_.sides == 1) return multiply(b, triangle, 4, 5, block);
    multiply(b, triangle, shape_.order, shape_.width(), block);
}

void KnotSystem::solve(int functions, std::span<const int> firsts,
                       std::span<const double> blocks) {
    factor(functions, firsts, blocks);
    take_solution();
}

void KnotSystem::factor(int functions, std::span<const int> firsts,
                        std::span<const double> blocks, std::span<const double> floors) {
    functions_ = functions;
    const int border = ends_ == Ends::closed ? std::min(shape_.order - 1, functions) : 0;
    const int columns = functions - border;
    if (ends_ == Ends::closed && columns < shape_.order) {
        qr_.restart({0, 0, functions, shape_.sides});
    } else {
        qr_.restart({shape_.order, columns, border, shape_.sides});
    }
    if (!floors.empty()) set_floors(floors);
    if (ends_ == Ends::open) return qr_.reduce(firsts, blocks);
    scratch_.resize(static_cast<std::size_t>(shape_.order * qr_.shape().row_width()));
    for (std::size_t i = 0; i < firsts.size(); ++i) {
        add_closed(firsts[i], blocks.data() + i * block_size());
    }
    qr_.finish();
}

void KnotSystem::set_floors(std::span<const double> floors) {
    std::vector<double> of_unknowns(floors.size());
    for (std::size_t j = 0; j < floors.size(); ++j) {
        of_unknowns[static_cast<std::size_t>(unknown(static_cast<int>(j)))] = floors[j];
    }
    qr_.set_floors(std::move(of_unknowns));
}

void KnotSystem::add_closed(int first, const double* block) {
    const num::BandShape& band = qr_.shape();
    const int k = shape_.order;
    const int start = std::clamp(first - band.border, 0, std::max(0, band.columns - band.width));
    std::fill(scratch_.begin(), scratch_.end(), 0.0);
    for (int j = 0; j < k; ++j) {
        const int f = (first + j) % functions_;
        const int at = f < band.border ? band.width + f : f - band.border - start;
        for (int i = 0; i < k; ++i) {
            scratch_[static_cast<std::size_t>(i * band.row_width() + at)] +=
                block[i * shape_.width() + j];
        }
    }
    for (int i = 0; i < k; ++i) {
        std::copy(block + i * shape_.width() + k, block + (i + 1) * shape_.width(),
                  scratch_.begin() + i * band.row_width() + band.width + band.border);
    }
    qr_.absorb(start, scratch_.data(), k);
}

void KnotSystem::solve_smoothly(int functions, std::span<const int> firsts,
                                std::span<const double> blocks,
                                std::span<const char> is_dependent) {
    std::vector<double> floors;
    int rank = 0;
    for (const char is : is_dependent) {
        floors.push_back(is ? std::numeric_limits<double>::infinity() : 0);
        rank += !is;
    }
    factor(functions, firsts, blocks, floors);
    SmoothEquations equations(functions, ends_, shape_);
    equations.add_triangle(*this);
    equations.add_differences(std::min(shape_.order, rank), ends_);
    const std::vector<double> c = equations.solution();
    qr_ = equations.triangle();
    const std::size_t p = static_cast<std::size_t>(functions), stored = stored_coefficients();
    solution_.resize(stored * static_cast<std::size_t>(shape_.sides));
    for (std::size_t i = 0; i < solution_.size(); ++i) {
        solution_[i] = c[i / stored * p + i % stored % p];
    }
}

std::size_t KnotSystem::stored_coefficients() const {
    return static_cast<std::size_t>(functions_ + (ends_ == Ends::closed ? shape_.order - 1 : 0));
}

void KnotSystem::take_solution() {
    const int stored = static_cast<int>(stored_coefficients());
    solution_.resize(static_cast<std::size_t>(stored * shape_.sides));
    std::vector<double>& raw = scratch_;
    raw.resize(static_cast<std::size_t>(functions_));
    for (int s = 0; s < shape_.sides; ++s) {
        qr_.solve(s, raw);
        for (int j = 0; j < stored; ++j) {
            solution_[static_cast<std::size_t>(s * stored + j)] =
                raw[static_cast<std::size_t>(unknown(j % functions_))];
        }
    }
}

int KnotSystem::unknown(int j) const {
    const num::BandShape& band = qr_.shape();
    return j < band.border ? band.columns + j : j - band.border;
}

std::span<const double> KnotSystem::coefficients(int side) const {
    const std::size_t stored = solution_.size() / static_cast<std::size_t>(shape_.sides);
    return std::span(solution_).subspan(static_cast<std::size_t>(side) * stored, stored);
}

double KnotSystem::squared_rest(int first, const double* block) const {
    const int k = shape_.order, width = shape_.width();
    double sum = 0;
    for (int s = 0; s < shape_.sides; ++s) {
        const double* const c = coefficients(s).data() + first;
        for (int i = 0; i < k; ++i) {
            const double* const row = block + i * width;
            double rest = row[k + s];
            for (int j = 0; j < k; ++j) rest -= row[j] * c[j];
            sum += rest * rest;
        }
    }
    return sum;
}

}  // namespace batten::fitting
