#include "api/row.hpp"
#include "batten/api/operation.hpp"

namespace batten {

const std::vector<Operation>& operations() {
    static const std::vector<Operation> table = {
        api::interpolate_row(), api::densify_row(),       api::thin_row(),
        api::arcs_row(),        api::sample_row(),        api::fit_row(),
        api::fit_surface_row(), api::fair_row(),          api::fair_surface_row(),
        api::log_aesthetic_row(), api::coons_row(),       api::measure_row(),
        api::evaluate_row(),    api::contour_row(),       api::section_row(),
        api::compare_row(),
        api::convert_row(),     api::draw_row(),
    };
    return table;
}

const Operation* find_operation(std::string_view name) {
    for (const Operation& operation : operations()) {
        if (operation.name == name) return &operation;
    }
    return nullptr;
}

Value envelope(const Operation& operation, const Outcome& outcome) {
    return ValueMap{{"batten", version()},
                    {"operation", operation.name},
                    {"status", name_of(outcome.status)},
                    {"options", outcome.options},
                    {"report", outcome.report}};
}

std::string_view version() { return BATTEN_VERSION; }

}  // namespace batten
