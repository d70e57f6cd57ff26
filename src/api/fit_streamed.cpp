#include <optional>
#include <utility>

#include "api/fit_table.hpp"
#include "batten/api/fit_outcome.hpp"
#include "batten/io/json.hpp"
#include "batten/io/table_stream.hpp"
#include "batten/make/fit_chunks.hpp"

namespace batten::api {
namespace {

TableStream table_stream_input(std::span<const Input> inputs) {
    const auto* file =
        inputs.size() == 1 ? std::get_if<StoredFile>(&inputs.front().content) : nullptr;
    if (file) return TableStream(StoredBytes(file->path));
    throw Error("table.streamed", "input", "a table in memory", "a file is read in blocks");
}

/// Throws where an option asks for what blocks cannot give: the fit knows which knots it takes.
void require_streamable(const FitTableOptions& options) {
    FitTableOptions plain;
    plain.x = options.x;
    plain.y = options.y;
    plain.stream = options.stream;
    plain.sigma = options.sigma;
    plain.fit.degree = options.fit.degree;
    plain.fit.knots = options.fit.knots;
    plain.fit.knots_values = options.fit.knots_values;
    plain.fit.intervals = options.fit.intervals;
    const Value asked = options_value(options), taken = options_value(plain);
    for (const auto& [name, value] : *asked.map()) {
        const std::string text = dump_json(value, JsonStyle::one_line);
        if (text == dump_json(*taken.find(name), JsonStyle::one_line)) continue;
        throw Error("fit.streamed", name, text,
                    "a table read in blocks takes columns, errors, degree and knots alone");
    }
    if (options.sigma.each.empty()) return;
    throw Error("fit.streamed", "sigma", "an error a row",
                "errors of a table read in blocks stand in a column of it, or are one of all");
}

}  // namespace

Outcome run_fit_streamed(std::span<const Input> inputs, const FitTableOptions& asked) {
    require_streamable(asked);
    FitTableOptions options = asked;
    options.fit.sigma = asked.sigma.all;
    options.fit.progress = asked.progress;
    TableStream table = table_stream_input(inputs);
    const auto read = [&](const Progress& progress, const FitStream::Take& take) {
        table.restart();
        while (std::optional<Table> block = table.next()) {
            const PointsInput input{*std::move(block), {}};
            naming_lines(input, [&] { take(data_of(input, options).view()); });
            progress.at(table.done(), table.size());
        }
    };
    return outcome_of(fit(FitStream{read}, options.fit));
}

}  // namespace batten::api
