#include "api/over_curves.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "batten/base/error.hpp"

namespace batten::api {
namespace {

using Outcomes = std::vector<Outcome>;

Outcomes outcomes_of(const Input& several, const std::function<Outcome(const Input&)>& run) {
    Outcomes all;
    for (const Input& each : single_curves(several)) {
        try {
            all.push_back(run(each));
        } catch (const Error& error) {
            throw error.at(each.name + ", " + error.place());
        }
    }
    return all;
}

/// Rows below one another; nothing where an outcome has none or other columns.
std::optional<Rows> joined_rows(const Outcomes& all) {
    Rows joined{{"curve"}, Points(0, 1)};
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Rows* rows = std::get_if<Rows>(&all[k].output);
        if (!rows) return std::nullopt;
        if (k == 0) {
            joined.names.insert(joined.names.end(), rows->names.begin(), rows->names.end());
            joined.cells = Points(0, rows->cells.dim() + 1);
        }
        if (rows->cells.dim() + 1 != joined.cells.dim()) return std::nullopt;
        std::vector<double> row(joined.names.size());
        for (std::size_t i = 0; i < rows->cells.size(); ++i) {
            row[0] = static_cast<double>(k);
            std::copy(rows->cells[i].begin(), rows->cells[i].end(), row.begin() + 1);
            joined.cells.push_back(row);
        }
    }
    return joined;
}

/// Panel by panel over one another.
Drawing joined_drawing(const std::vector<std::function<Drawing()>>& pictures) {
    Drawing joined = pictures.front()();
    for (std::size_t k = 1; k < pictures.size(); ++k) {
        Drawing drawing = pictures[k]();
        for (std::size_t p = 0; p < drawing.panels.size(); ++p) {
            if (p >= joined.panels.size()) {
                joined.panels.push_back(std::move(drawing.panels[p]));
                continue;
            }
            Panel& panel = joined.panels[p];
            for (auto& layer : drawing.panels[p].layers) panel.layers.push_back(std::move(layer));
            if (panel.y_range && drawing.panels[p].y_range) {
                panel.y_range->lo = std::min(panel.y_range->lo, drawing.panels[p].y_range->lo);
                panel.y_range->hi = std::max(panel.y_range->hi, drawing.panels[p].y_range->hi);
            }
        }
    }
    return joined;
}

}  // namespace

std::vector<Input> single_curves(const Input& several) {
    std::vector<Input> inputs;
    for (const Curve& curve : std::get<std::vector<Curve>>(several.content)) {
        inputs.push_back({several.name + " curve " + std::to_string(inputs.size()), curve});
    }
    return inputs;
}

std::vector<Input> with_single_curves(std::span<const Input> inputs) {
    std::vector<Input> all;
    for (const Input& input : inputs) {
        if (std::holds_alternative<std::vector<Curve>>(input.content)) {
            for (Input& each : single_curves(input)) all.push_back(std::move(each));
        } else {
            all.push_back(input);
        }
    }
    return all;
}

const Input* several_curves(std::span<const Input> inputs) {
    const bool is_several = inputs.size() == 1 &&
                            std::holds_alternative<std::vector<Curve>>(inputs.front().content);
    return is_several ? &inputs.front() : nullptr;
}

Outcome over_curves(const Input& several, const std::function<Outcome(const Input&)>& run) {
    const Outcomes all = outcomes_of(several, run);
    Outcome joined;
    ValueList reports;
    std::vector<std::function<Drawing()>> pictures;
    for (const Outcome& each : all) {
        if (joined.status == Status::met) joined.status = each.status;
        reports.push_back(each.report);
        if (each.draw) pictures.push_back(each.draw);
        if (const Curve* curve = std::get_if<Curve>(&each.output)) joined.curves.push_back(*curve);
    }
    joined.report = ValueMap{{"curves", std::move(reports)}};
    if (std::optional<Rows> rows = joined_rows(all)) joined.output = *std::move(rows);
    if (!pictures.empty()) joined.draw = [pictures] { return joined_drawing(pictures); };
    return joined;
}

Input only_curve(const Input& input, int only) {
    std::vector<Input> each;
    if (std::holds_alternative<std::vector<Curve>>(input.content)) each = single_curves(input);
    else each.push_back(input);
    if (only < 0 || static_cast<std::size_t>(only) >= each.size()) {
        throw Error("option.range", "only", std::to_string(only),
                    input.name + " holds " + std::to_string(each.size()) +
                        " curves, counted from 0");
    }
    return each[static_cast<std::size_t>(only)];
}

}  // namespace batten::api
