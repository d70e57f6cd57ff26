#include "outputs.hpp"

#include <unistd.h>

#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/dxf.hpp"
#include "batten/io/files.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/io/write_points.hpp"
#include "batten/shape/spline_graph.hpp"
#include "charts.hpp"

namespace batten::cli {
namespace {

/// Samples a piece when a curve is written as rows.
constexpr int samples_a_piece = 16;

[[noreturn]] void refuse_format(const std::string& format, const std::string& allowed) {
    throw Error("output.format", "output", format.empty() ? "no suffix" : format,
                "must be one of " + allowed);
}

std::vector<double> sample_parameters(const Curve& curve) {
    const int samples = curve.degree() == 1 ? 1 : samples_a_piece;
    std::vector<double> t;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        for (int k = 0; k < samples; ++k) t.push_back(piece.lo + piece.length() * k / samples);
    }
    t.push_back(curve.domain().hi);
    return t;
}

/// `allowed`, and the outcome's own forms.
std::string with_forms(std::string allowed, const Outcome& outcome) {
    for (const OutputForm& form : outcome.forms) {
        if (form.name != "dxf") allowed += ", " + form.name;
    }
    return allowed;
}

std::string text_of(const Curve& curve, const std::string& format, const Outcome& outcome) {
    if (format == "json") return dump_json(curve_value(curve));
    if (has_jumps(curve) && format != "csv") {
        throw Error("curve.jumps", "output", format,
                    "a curve with jumps is written as json or csv; batten draw makes a picture");
    }
    if (format == "svg") return svg_picture(curve);
    if (format == "dxf") return dxf(curve);
    if (format == "csv") return csv_samples(curve, sample_parameters(curve));
    refuse_format(format, with_forms(outcome.rows ? "json, svg, csv, npy, dxf"
                                                  : "json, svg, csv, dxf", outcome));
}

std::string text_of(const Rows& rows, const std::string& format) {
    if (format == "csv") return csv_points(rows.cells, rows.names);
    if (format == "json") return json_points(rows.cells);
    if (format == "npy") return npy_points(rows.cells);
    refuse_format(format, "csv, json, npy");
}

std::string text_of(const Drawing& drawing, const std::string& format) {
    if (format == "svg" || format == "png" || format == "pdf") return picture(drawing, format);
    refuse_format(format, "svg, png, pdf");
}

std::string text_of(const std::vector<Curve>& curves, const std::string& format) {
    if (format == "json") return dump_json(curves_value(curves));
    if (format == "dxf") return dxf(curves);
    if (format == "svg") {
        Drawing drawing;
        for (const Curve& curve : curves) drawing.add(CurveLayer{curve, {}, {}});
        return svg(drawing);
    }
    refuse_format(format, "json, dxf, svg");
}

std::string report_text(const Command& command, const Outcome& outcome) {
    return dump_json(envelope(*command.operation, outcome));
}

std::string output_text(const Command& command, const Outcome& outcome,
                        const std::string& format) {
    for (const OutputForm& form : outcome.forms) {
        if (form.name == format) return form.text();
    }
    const bool wants_rows = format == "csv" || format == "npy";
    if (wants_rows && outcome.rows) return text_of(outcome.rows(), format);
    if (const Curve* curve = std::get_if<Curve>(&outcome.output)) {
        return text_of(*curve, format, outcome);
    }
    if (const Rows* rows = std::get_if<Rows>(&outcome.output)) return text_of(*rows, format);
    if (const auto* drawing = std::get_if<Drawing>(&outcome.output)) {
        return text_of(*drawing, format);
    }
    if (const auto* surface = std::get_if<Surface>(&outcome.output)) {
        if (format == "json") return dump_json(surface_value(*surface));
        refuse_format(format, with_forms("json", outcome));
    }
    if (!outcome.curves.empty()) return text_of(outcome.curves, format);
    if (format != "json") refuse_format(format, "json");
    return report_text(command, outcome);
}

std::string default_format(const Outcome& outcome) {
    if (std::holds_alternative<Rows>(outcome.output)) return "csv";
    if (std::holds_alternative<Drawing>(outcome.output)) return "svg";
    return "json";
}

/// A report alone is not poured over the summary that a person at a terminal reads anyway.
bool writes_to_standard_output(const Command& command) {
    if (!command.output.empty()) return command.output == "-";
    if (command.keeps_result) return false;
    if (command.operation->output != OutputKind::report) return command.report != "-";
    return command.report.empty() && !isatty(STDOUT_FILENO);
}

}  // namespace

std::vector<FileToWrite> render(const Command& command, const Outcome& outcome) {
    std::vector<FileToWrite> all;
    const bool to_standard = writes_to_standard_output(command);
    // What was asked for does not exist: the report says so, and no file does.
    const bool is_missing = command.operation->output != OutputKind::report &&
                            std::holds_alternative<std::monostate>(outcome.output) &&
                            outcome.curves.empty();
    if (!is_missing && (to_standard || !command.output.empty())) {
        std::string format = command.format;
        if (format.empty()) {
            format = to_standard ? default_format(outcome)
                                 : suffix_of(command.output);
        }
        all.push_back({to_standard ? "-" : command.output,
                       output_text(command, outcome, format)});
    }
    if (!command.drawing.empty() && outcome.draw) {
        all.push_back({command.drawing, picture(outcome.draw(), suffix_of(command.drawing))});
    }
    if (!command.report.empty()) all.push_back({command.report, report_text(command, outcome)});
    return all;
}

}  // namespace batten::cli
