#include "batten/measure/contours.hpp"

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>

#include "api/row.hpp"
#include "api/surface_picture.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/dxf.hpp"
#include "batten/io/json.hpp"
#include "batten/measure/length.hpp"

namespace batten::api {
namespace {

struct ContourOptions {
    std::vector<double> levels;
    std::optional<int> count;
    Tolerance tolerance = relative(1e-6);
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ContourOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("levels", o.levels, anything, "the heights of the lines");
    visit("count", o.count, between(1, 1000),
          "where no levels are given: so many round ones, or up to 2.5 times as many [10]");
    visit("tolerance", o.tolerance, more_than(0), "how far a line may be from its level");
}

struct ContourSummary {
    double level = 0;
    bool closed = false;
    double length = 0;
    std::size_t joints = 0;
    Status status = Status::met;
};

template <class Visit>
void visit_fields(const ContourSummary& r, Visit&& visit) {
    visit("level", r.level, "height of the line");
    visit("closed", r.closed, "whether it returns to its start");
    visit("length", r.length, "arc length");
    visit("joints", r.joints, "points exactly on the level");
    visit("status", r.status, "whether it is as close to its level as was asked");
}

struct ContourReport {
    std::vector<double> levels;
    std::vector<ContourSummary> lines;
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const ContourReport& r, Visit&& visit) {
    visit("levels", r.levels, "the heights");
    visit("lines", r.lines, "what the lines are");
    visit("notes", r.notes, "what else there is to say");
}

/// Joints row after row.
Rows rows_of(const std::vector<Contour>& lines) {
    Rows rows{{"line", "level", "x", "y"}, Points(0, 4)};
    for (std::size_t k = 0; k < lines.size(); ++k) {
        for (const double t : lines[k].curve.breaks()) {
            const std::vector<double> p = lines[k].curve(t);
            rows.cells.push_back(
                std::vector<double>{static_cast<double>(k), lines[k].level, p[0], p[1]});
        }
    }
    return rows;
}

std::vector<Curve> curves_of(const std::vector<Contour>& lines) {
    std::vector<Curve> curves;
    for (const Contour& line : lines) curves.push_back(line.curve);
    return curves;
}

/// One line is a curve file, which every verb reads; several are a list of such.
std::string json_of(const std::vector<Contour>& lines) {
    if (lines.size() == 1) return dump_json(curve_value(lines.front().curve));
    ValueList list;
    for (const Contour& line : lines) {
        list.push_back(ValueMap{{"level", line.level}, {"curve", curve_value(line.curve)}});
    }
    return dump_json(ValueMap{{"format", "batten.contours/1"}, {"lines", std::move(list)}});
}

/// Tells of lines that may be farther from their level than was asked.
Status worst_status(ContourReport& report) {
    const auto missed = std::count_if(report.lines.begin(), report.lines.end(),
                                      [](const ContourSummary& line) {
                                          return line.status != Status::met;
                                      });
    if (missed == 0) return Status::met;
    report.notes.push_back(std::to_string(missed) + (missed == 1 ? " line" : " lines") +
                           " may be beyond the tolerance, or connected otherwise: the surface is "
                           "nearly level there");
    return Status::not_met;
}

Outcome run(std::span<const Input> inputs, const ContourOptions& options) {
    const Surface& surface = surface_input(inputs);
    ContourReport report;
    if (!options.levels.empty() && options.count) {
        throw Error("option.unused", "count", std::to_string(*options.count),
                    "tells how many levels are chosen, where none are given");
    }
    report.levels = options.levels.empty()
                        ? round_levels(surface, options.count.value_or(usual_levels))
                        : options.levels;
    std::vector<Contour> lines;
    const Rectangle domain = domain_of(surface);
    for (const double level : report.levels) {
        const std::size_t before = lines.size();
        for (Contour& line : contours(surface, level, options.tolerance)) {
            report.lines.push_back({level, line.curve.is_closed(), length(line.curve).value,
                                    line.curve.breaks().size(), line.status});
            lines.push_back(std::move(line));
        }
        if (lines.size() == before) {
            report.notes.push_back("no line at the level " + format_number(level));
        }
    }
    const Status status = worst_status(report);
    return {rows_of(lines),
            status,
            {},
            report_value(report),
            [surface, lines] { return contour_picture(surface, lines); },
            {{"json", [lines] { return json_of(lines); }},
             {"dxf", [lines] { return dxf(curves_of(lines)); }},
             {"svg", [domain, lines] { return svg(contour_map(domain, lines)); }}},
            {},
            curves_of(lines)};
}

}  // namespace

Operation contour_row() {
    return row<ContourOptions>({"contour", "lines of equal height of a surface",
                                InputKind::surface, OutputKind::curves},
                               run);
}

}  // namespace batten::api
