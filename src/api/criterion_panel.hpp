#pragma once

#include "batten/io/draw/drawing.hpp"
#include "batten/make/fit.hpp"

namespace batten::api {

/// What the stopping rule saw: its criterion over the number of intervals, the one chosen marked.
Panel criterion_panel(const FitReport& report, const FitOptions& options);

}  // namespace batten::api
