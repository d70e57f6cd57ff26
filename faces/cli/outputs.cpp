#include "outputs.hpp"

#include <unistd.h>

#include <algorithm>

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

[[noreturn]] void refuse_format(const std::string& format,
                                const std::vector<std::string>& allowed) {
    std::string words;
    for (const std::string& form : allowed) words += (words.empty() ? "" : ", ") + form;
    throw Error("output.format", "output", format.empty() ? "no suffix" : format,
                (allowed.size() == 1 ? "must be " : "must be one of ") + words);
}

bool is_among(const std::vector<std::string>& forms, const std::string& format) {
    return std::find(forms.begin(), forms.end(), format) != forms.end();
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

/// Of what the operation writes, what this outcome can be written as.
std::vector<std::string> forms_of(const Outcome& outcome) {
    std::vector<std::string> forms;
    if (const Curve* curve = std::get_if<Curve>(&outcome.output)) {
        forms = {"json", "csv"};
        if (!has_jumps(*curve)) forms.insert(forms.end(), {"svg", "dxf"});
    } else if (std::holds_alternative<Rows>(outcome.output)) {
        forms = {"csv", "json", "npy"};
    } else if (std::holds_alternative<Drawing>(outcome.output)) {
        forms = {"svg", "png", "pdf"};
    } else {
        forms = {"json"};
        if (!outcome.curves.empty()) forms.insert(forms.end(), {"dxf", "svg"});
    }
    const auto add = [&](const std::string& form) {
        if (!is_among(forms, form)) forms.push_back(form);
    };
    for (const OutputForm& form : outcome.forms) add(form.name);
    if (outcome.rows) add("npy");
    return forms;
}

std::string text_of(const Curve& curve, const std::string& format) {
    if (format == "json") return dump_json(curve_value(curve));
    if (has_jumps(curve) && format != "csv") {
        throw Error("curve.jumps", "output", format,
                    "a curve with jumps is written as json or csv; batten draw makes a picture");
    }
    if (format == "svg") return svg_picture(curve);
    if (format == "dxf") return dxf(curve);
    return csv_samples(curve, sample_parameters(curve));
}

std::string text_of(const Rows& rows, const std::string& format) {
    if (format == "csv") return csv_points(rows.cells, rows.names);
    if (format == "json") return json_points(rows.cells);
    return npy_points(rows.cells);
}

std::string text_of(const std::vector<Curve>& curves, const std::string& format) {
    if (format == "json") return dump_json(curves_value(curves));
    if (format == "dxf") return dxf(curves);
    Drawing drawing;
    for (const Curve& curve : curves) drawing.add(CurveLayer{curve, {}, {}});
    return svg(drawing);
}

std::string report_text(const Command& command, const Outcome& outcome) {
    return dump_json(envelope(*command.operation, outcome));
}

std::string output_text(const Command& command, const Outcome& outcome,
                        const std::string& format) {
    const std::vector<std::string> forms = forms_of(outcome);
    const auto* curve = std::get_if<Curve>(&outcome.output);
    const bool is_cut = curve && has_jumps(*curve) && !is_among(forms, format);
    if (is_cut) {
        throw Error("curve.jumps", "output", format,
                    "a curve with jumps is written as json or csv; batten draw makes a picture");
    }
    if (!is_among(forms, format)) refuse_format(format, forms);
    for (const OutputForm& form : outcome.forms) {
        if (form.name == format) return form.text();
    }
    const bool wants_rows = format == "csv" || format == "npy";
    if (wants_rows && outcome.rows) return text_of(outcome.rows(), format);
    if (curve) return text_of(*curve, format);
    if (const Rows* rows = std::get_if<Rows>(&outcome.output)) return text_of(*rows, format);
    if (const auto* drawing = std::get_if<Drawing>(&outcome.output)) {
        return picture(*drawing, format);
    }
    if (const auto* surface = std::get_if<Surface>(&outcome.output)) {
        return dump_json(surface_value(*surface));
    }
    if (!outcome.curves.empty()) return text_of(outcome.curves, format);
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

void require_form(const Command& command) {
    const bool is_file = !command.output.empty() && command.output != "-";
    const std::string format =
        command.format.empty() && is_file ? suffix_of(command.output) : command.format;
    if (format.empty() && !is_file) return;
    const std::vector<std::string>& forms = command.operation->forms;
    if (!is_among(forms, format)) refuse_format(format, forms);
}

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
