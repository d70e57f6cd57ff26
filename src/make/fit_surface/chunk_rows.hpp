#pragma once

#include "batten/make/fit_surface_chunks.hpp"

namespace batten::surface_fitting {

/// Throws what SurfaceChunk promises about columns.
void require_columns(const SurfaceColumns& columns, const BSplineBasis& y);

/// Throws what `SurfaceChunk::add` promises about rows.
void require_rows(const SurfaceRows& rows, const SurfaceColumns& columns, const BSplineBasis& x,
                  double sigma);

}  // namespace batten::surface_fitting
