#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit/whitney.hpp"
#include "make/fit_surface/chunk_rows.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/grid_lines.hpp"
#include "make/fit_surface/row_fits.hpp"
#include "make/fit_surface/shape_of_surface.hpp"
#include "make/fit_surface/strip_triangles.hpp"
#include "num/cox_de_boor.hpp"
#include "num/householder.hpp"

namespace batten {

using namespace surface_fitting;

namespace {

/// Of the largest spline: enough for a regular triangle, too little to move what data determine.
constexpr double faint_tie = 0x1p-20;
constexpr std::size_t shape_lines = 65;  // in place of the rows, of which no list is kept

}  // namespace

/// What all chunks of a grid share.
struct SurfaceChunk::Frame {
    BSplineBasis x;
    SurfaceColumns columns;
    RowFits fits;

    std::size_t order() const { return static_cast<std::size_t>(x.degree()) + 1; }
    std::size_t width() const { return order() + fits.axis().functions(); }
    std::size_t strips() const { return x.breaks().size() - 1; }
    Interval strip(std::size_t i) const { return {x.breaks()[i], x.breaks()[i + 1]}; }
};

SurfaceChunk::SurfaceChunk(BSplineBasis x_basis, BSplineBasis y_basis, SurfaceColumns columns) {
    require_columns(columns, y_basis);
    const std::vector<double> weights = weights_of(columns.y_sigma, columns.y.size());
    std::vector<double> y = columns.y;
    frame_.reset(new Frame{std::move(x_basis), std::move(columns),
                           {std::move(y_basis), y, weights}});
    strips_.resize(frame_->strips());
}

/// Rotates rows of splines in x and coefficients in y into the strip's triangle.
void SurfaceChunk::absorb(std::size_t strip, std::vector<double>& rows) {
    const std::size_t order = frame_->order(), width = frame_->width();
    std::vector<double>& triangle = strips_[strip].triangle;
    const std::size_t count = rows.size() / width;
    if (triangle.empty()) triangle.assign(order * width, 0.0);
    num::absorb({triangle.data(), width, static_cast<int>(order), static_cast<int>(width)},
                {rows.data(), static_cast<int>(count), width});
    for (std::size_t r = 0; r < count; ++r) {
        left_sq_ += frame_->fits.norm_sq(rows.data() + r * width + order);
    }
    rows.clear();
}

void SurfaceChunk::add(const SurfaceRows& given, double sigma) {
    require_rows(given, frame_->columns, frame_->x, sigma);
    require_finite_rows(given.z, frame_->columns.y.size());
    const std::size_t order = frame_->order(), q = frame_->fits.axis().functions();
    const std::size_t ny = frame_->columns.y.size();
    std::vector<double> rows, values(order);
    for (std::size_t first = 0; first < given.x.size(); first += RowFits::most_rows) {
        const std::size_t last = std::min(given.x.size(), first + RowFits::most_rows);
        const RowFits::Fitted fitted =
            frame_->fits.fit(given.z.subspan(first * ny, (last - first) * ny));
        for (std::size_t r = first; r < last; ++r) {
            const std::size_t strip = strip_of(frame_->x, given.x[r]);
            const double weight =
                1 / (sigma * (given.x_sigma.empty() ? 1 : given.x_sigma[r]));
            left_sq_ += weight * weight * fitted.left_sq[r - first];
            num::basis_values(frame_->x.knots(), frame_->x.span_of_piece(strip),
                              static_cast<int>(order), given.x[r], values.data());
            for (const double value : values) rows.push_back(weight * value);
            const double* const c = fitted.coefficients.data() + (r - first) * q;
            for (std::size_t j = 0; j < q; ++j) rows.push_back(weight * c[j]);
            const bool goes_on = r + 1 < last && strip_of(frame_->x, given.x[r + 1]) == strip;
            if (!goes_on) absorb(strip, rows);
        }
    }
    for (const double x : given.x) {
        const std::size_t strip = strip_of(frame_->x, x);
        fitting::remember_places(strips_[strip].places, {&x, 1}, frame_->strip(strip), order);
    }
    samples_ += given.z.size();
}

void SurfaceChunk::merge(const SurfaceChunk& other) {
    const Frame &own = *frame_, &its = *other.frame_;
    const bool is_same = own.x == its.x && own.fits.axis().basis() == its.fits.axis().basis() &&
                         own.columns.y == its.columns.y &&
                         own.columns.y_sigma == its.columns.y_sigma;
    if (!is_same) {
        throw Error("fit.chunks-differ", "knots", std::to_string(its.x.size()),
                    "chunks must have the same knots, degrees and columns");
    }
    const std::size_t order = own.order();
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        if (other.strips_[i].triangle.empty()) continue;
        std::vector<double> rows = other.strips_[i].triangle;
        absorb(i, rows);
        fitting::remember_places(strips_[i].places, other.strips_[i].places, own.strip(i), order);
    }
    left_sq_ += other.left_sq_;
    samples_ += other.samples_;
}

/// The largest value of a weighted spline in the triangles.
double SurfaceChunk::largest() const {
    double result = 0;
    for (const Strip& strip : strips_) {
        for (std::size_t k = 0; k < strip.triangle.size(); ++k) {
            if (k % frame_->width() >= frame_->order()) continue;
            result = std::max(result, std::fabs(strip.triangle[k]));
        }
    }
    return result;
}

std::vector<int> SurfaceChunk::open_x() const {
    std::vector<double> places;
    for (const Strip& strip : strips_) {
        places.insert(places.end(), strip.places.begin(), strip.places.end());
    }
    return open_splines(frame_->x, places);
}

SurfaceFit SurfaceChunk::solve() const {
    const Axis& y = frame_->fits.axis();
    const std::size_t p = frame_->x.size(), q = y.functions();
    require_enough_nodes(samples_, p * q);
    const std::vector<int> open = open_x();
    StripTriangles all(frame_->x, frame_->fits, open.empty() ? 0 : faint_tie * largest());
    for (const Strip& strip : strips_) all.take(strip.triangle);
    std::vector<double> coefficients = all.solve();
    const double delta2 = left_sq_ + all.left_sq();
    require_finite_solution(coefficients, delta2);
    SurfaceFit fit{SplineSurface(frame_->x, y.basis(), std::move(coefficients)), {}};
    FitSurfaceReport& report = fit.report;
    fill_lines(report, fit.surface);
    Misfit misfit;
    misfit.delta2 = delta2;
    fill_criteria(report, misfit, {samples_, 0, true, SigmaSource::column, std::nullopt});
    report.psi.clear();
    report.parameters_charged = report.parameters;
    for (std::size_t i = 0; i < p; ++i) {
        for (std::size_t j = 0; j < q; ++j) {
            const bool is_open =
                std::binary_search(open.begin(), open.end(), static_cast<int>(i)) ||
                std::binary_search(y.open().begin(), y.open().end(), static_cast<int>(j));
            if (is_open) report.undetermined.push_back({static_cast<int>(i), static_cast<int>(j)});
        }
    }
    if (!report.undetermined.empty()) report.status = Status::rank_deficient;
    const std::vector<double> lines = even_places(frame_->x.domain(), shape_lines);
    report.separability = separability(fit.surface, lines, frame_->columns.y);
    report.oscillation = oscillation(fit.surface, lines, frame_->columns.y);
    return fit;
}

}  // namespace batten
