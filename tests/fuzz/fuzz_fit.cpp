#include <cmath>

#include "batten/api/operation.hpp"
#include "promises.hpp"

/// `name=value` on the lines before an empty one are options of the fit, what follows is the table.
/// Whatever is asked, there is a finite fit or an error that says why not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    const std::string text(reinterpret_cast<const char*>(data), std::min<std::size_t>(size, 2000));
    std::vector<Setting> settings;
    std::size_t start = 0;
    while (start < text.size() && text[start] != '\n') {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = text.substr(start, end - start);
        const std::size_t equals = std::min(line.find('='), line.size());
        settings.push_back({line.substr(0, equals),
                            equals < line.size() ? line.substr(equals + 1) : std::string()});
        start = end + 1;
    }
    try {
        const Table table = parse_table({"input.csv", text.substr(std::min(start, text.size()))},
                                        TableFormat::text);
        if (table.cells.size() > 200) return 0;
        const Input input{"input.csv", PointsInput{table, {}}};
        const Outcome outcome = find_operation("fit")->run({&input, 1}, settings, {});
        const Value* delta2 = outcome.report.find("delta2");
        batten::fuzz::require(delta2 && std::isfinite(delta2->number()));
        for (const Value& c : *outcome.report.find("coefficients")->list()) {
            batten::fuzz::require(std::isfinite(c.number()));
        }
        if (outcome.rows) {
            const Rows rows = outcome.rows();
            batten::fuzz::require(rows.cells.size() == table.cells.size());
        }
    } catch (const Error& error) {
        batten::fuzz::check_error(error);
    }
    return 0;
}
