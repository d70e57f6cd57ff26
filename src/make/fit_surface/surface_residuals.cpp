#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/chunk_rows.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/grid_lines.hpp"

namespace batten {

using namespace surface_fitting;

namespace {

void take_heights(Nodes& nodes, std::span<const double> z) {
    nodes.z = z;
    if (has_holes(z, nodes.y.size())) {
        nodes.filled.assign(z.begin(), z.end());
        nodes.cell_factor_sq.assign(z.size(), 1.0);
        for (std::size_t k = 0; k < z.size(); ++k) {
            if (!std::isnan(z[k])) continue;
            nodes.filled[k] = nodes.cell_factor_sq[k] = 0;
            ++nodes.missing;
        }
        nodes.z = nodes.filled;
    }
    nodes.count = z.size() - nodes.missing;
}

}  // namespace

struct SurfaceResiduals::Frame {
    SplineSurface surface;
    SurfaceColumns columns;
    std::vector<double> y_weight;
    Axis y;
};

SurfaceResiduals::SurfaceResiduals(const SplineSurface& surface, SurfaceColumns columns) {
    require_columns(columns, surface.y_basis());
    std::vector<double> weights = weights_of(columns.y_sigma, columns.y.size());
    Axis y(surface.y_basis(), columns.y, weights, columns.y);
    frame_.reset(new Frame{surface, std::move(columns), std::move(weights), std::move(y)});
}

void SurfaceResiduals::add(const SurfaceRows& rows, double sigma) {
    require_rows(rows, frame_->columns, frame_->surface.x_basis(), sigma);
    if (rows.x.empty()) return;
    Nodes nodes;
    nodes.x = rows.x;
    nodes.y = frame_->columns.y;
    take_heights(nodes, rows.z);
    nodes.x_weight = weights_of(rows.x_sigma, rows.x.size());
    for (double& weight : nodes.x_weight) weight /= sigma;
    nodes.y_weight = frame_->y_weight;
    const Axis x(frame_->surface.x_basis(), rows.x, nodes.x_weight, rows.x);
    const std::span<const double> c = frame_->surface.coefficients();
    const Misfit part = misfit(nodes, x, frame_->y, {c.begin(), c.end()}, std::nullopt);
    delta2_ += part.delta2;
    largest_ = std::max(largest_, part.max_residual);
    for (std::size_t w = 0; w < within_.size(); ++w) {
        within_[w] += std::round(part.psi[w] * static_cast<double>(nodes.count));
    }
    samples_ += nodes.count;
    missing_ += nodes.missing;
}

void SurfaceResiduals::merge(const SurfaceResiduals& other) {
    delta2_ += other.delta2_;
    largest_ = std::max(largest_, other.largest_);
    for (std::size_t w = 0; w < within_.size(); ++w) within_[w] += other.within_[w];
    samples_ += other.samples_;
    missing_ += other.missing_;
}

void SurfaceResiduals::fill(FitSurfaceReport& report) const {
    Misfit all;
    all.delta2 = delta2_;
    all.max_residual = largest_;
    for (std::size_t w = 0; w < within_.size(); ++w) {
        all.psi[w] = within_[w] / static_cast<double>(samples_);
    }
    report.chi2_p.reset();
    fill_criteria(report, all,
                  {samples_, missing_, report.sigma_source != SigmaSource::estimated, report.sigma_source,
                   report.sigma});
    require_finite_solution({}, delta2_);
}

}  // namespace batten
