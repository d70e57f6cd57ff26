#pragma once

#include "batten/make/fit_surface_chunks.hpp"

namespace batten::surface_fitting {

/// Throws what SurfaceChunk promises about columns.
void require_columns(const SurfaceColumns& columns, const BSplineBasis& y);

/// Throws what `SurfaceResiduals::add` promises about rows.
void require_rows(const SurfaceRows& rows, const SurfaceColumns& columns, const BSplineBasis& x,
                  double sigma);

/// Whether heights are missing. Throws `points.not-finite` for infinite ones; `first`: of the grid's
/// rows the first of these.
bool has_holes(std::span<const double> z, std::size_t columns, std::size_t first = 0);

/// Throws `points.not-finite`: rows are whole. `first`: of the grid's rows the first of these.
void require_finite_rows(std::span<const double> z, std::size_t columns, std::size_t first = 0);

}  // namespace batten::surface_fitting
