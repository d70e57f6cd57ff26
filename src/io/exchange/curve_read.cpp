#include <algorithm>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "batten/shape/spline_graph.hpp"
#include "batten/make/fit_bands.hpp"
#include "io/exchange/curve_covariance.hpp"
#include "io/exchange/entries.hpp"
#include "io/tables/utf8.hpp"

namespace batten {
namespace {

using exchange::Entries;
using exchange::require_size;
using exchange::shown;

constexpr const char* format_name = "batten.curve/1";

/// Rounding leaves far less between a piece's end and the next point, or a closed curve's ends.
constexpr double largest_gap = 1e-6;

/// Throws where a piece does not end at the next point.
void require_joined(const PiecewiseCubic& curve, const Entries& entries) {
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const double h = curve.breaks()[i + 1] - curve.breaks()[i];
        for (int k = 0; k < curve.dim(); ++k) {
            const auto c = [&](int power) { return curve.coefficients(power, k)[i]; };
            const double next = curve.coefficients(0, k)[i + 1];
            const double terms[] = {c(0), c(1) * h, c(2) * h * h, c(3) * h * h * h, -next};
            double gap = 0, size = 0;
            for (const double term : terms) {
                gap += term;
                size = std::max(size, std::fabs(term));
            }
            const std::string place = entries.place(Entries::at("coefficients", i));
            if (!std::isfinite(gap) || !std::isfinite(size)) {
                throw Error("number.overflow", place, "beyond a double",
                            "the curve must lie within the range of a double");
            }
            if (std::fabs(gap) > largest_gap * size) {
                throw Error("curve.gap", place, "a gap of " + format_number(std::fabs(gap)),
                            "a piece must end at the next point");
            }
        }
    }
}

void require_closed(PointsView points, const std::string& place) {
    const std::size_t last = points.size() - 1;
    for (int k = 0; k < points.dim(); ++k) {
        if (!(std::fabs(points(last, k) - points(0, k)) <= largest_gap * extent(points))) {
            throw Error("curve.gap", place, "other ends",
                        "a closed curve must end where it starts");
        }
    }
}

Curve read_cubic(const Entries& entries) {
    const Points points = entries.points("points");
    const std::size_t joints = points.size(), dim = static_cast<std::size_t>(points.dim());
    std::vector<double> breaks = entries.numbers("breaks");
    require_size(entries, "breaks", breaks.size(), joints);
    const ValueList& pieces = entries.list("coefficients");
    require_size(entries, "coefficients", pieces.size(), joints - 1);
    std::vector<double> block(4 * dim * joints, 0.0);
    for (std::size_t i = 0; i < joints; ++i) {
        for (std::size_t k = 0; k < dim; ++k) block[k * joints + i] = points[i][k];
    }
    std::vector<double> row;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string entry = Entries::at("coefficients", i);
        const ValueList* powers = pieces[i].list();
        if (!powers || powers->size() != 3) {
            throw entries.wrong(entry, &pieces[i], "a list of 3 lists is needed here");
        }
        row.clear();
        for (const Value& power : *powers) entries.append_row(row, power, dim, entry);
        for (std::size_t j = 0; j < row.size(); ++j) block[(dim + j) * joints + i] = row[j];
    }
    const bool closed = entries.truth("closed");
    PiecewiseCubic curve = PiecewiseCubic::power(std::move(block), points.dim(),
                                                 std::move(breaks), closed);
    require_joined(curve, entries);
    if (closed) require_closed(points, entries.place("points"));
    return curve;
}

Curve read_bspline(const Entries& entries) {
    const Points points = entries.points("control_points");
    const int degree = entries.whole("degree");
    std::vector<double> knots = entries.numbers("knots");
    BSplineBasis basis = entries.truth("closed") ? BSplineBasis::periodic(knots, degree)
                                                 : BSplineBasis(std::move(knots), degree);
    std::vector<double> weights;
    if (entries.has("weights")) {
        weights = entries.numbers("weights");
        require_size(entries, "weights", weights.size(), points.size());
    }
    return BSplineCurve(std::move(basis), points, std::move(weights));
}

Curve read_graph(const Entries& entries) {
    return graph_in_parts({entries.numbers("knots"), entries.numbers("coefficients"),
                           entries.whole("degree")});
}

Curve with_fit(const Curve& curve, const Entries& entries) {
    return entries.has("fit") ? with_covariance(curve, exchange::covariance_in(entries)) : curve;
}

Curve read_arcs(const Entries& entries) {
    Points points = entries.points("points");
    std::vector<double> bulges = entries.numbers("bulges");
    require_size(entries, "bulges", bulges.size(), points.size() - 1);
    return ArcChain(std::move(points), std::move(bulges), entries.truth("closed"));
}

Curve read_log_aesthetic(const Entries& entries) {
    const Points points = entries.points("points");
    const ValueList& arcs = entries.list("arcs");
    std::vector<LogAestheticSegment> segments;
    std::vector<double> row;
    for (const Value& arc : arcs) {
        row.clear();
        entries.append_row(row, arc, 4, Entries::at("arcs", segments.size()));
        segments.push_back({row[0], row[1], row[2], row[3]});
    }
    std::vector<double> angles = entries.numbers("angles");
    require_size(entries, "angles", angles.size(), segments.size());
    require_size(entries, "points", points.size(), segments.size() + 1);
    const bool closed = entries.truth("closed");
    if (closed) require_closed(points, entries.place("points"));
    LogAestheticCurve curve(points, std::move(angles), std::move(segments), closed);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (curve.miss(i) <= largest_gap) continue;
        throw Error("curve.gap", entries.place(Entries::at("arcs", i)),
                    format_number(curve.miss(i)) + " of its length",
                    "an arc must end at the next point");
    }
    return curve;
}

Error wrong_format(const std::string& place, std::string value) {
    return {"curve.format", place, std::move(value),
            std::string("a curve is a map with \"format\": \"") + format_name +
                "\", an SVG picture or SVG path data"};
}

}  // namespace

Curve curve_of(const Value& tree, const std::string& place) {
    const Value* format = tree.find("format");
    if (!tree.map()) throw wrong_format(place, shown(&tree));
    if (!format || !format->text() || *format->text() != format_name) {
        throw wrong_format(place + ", entry format", shown(format));
    }
    const Entries entries(tree, place);
    const Value* kind = tree.find("kind");
    const std::string name = kind && kind->text() ? *kind->text() : std::string();
    try {
        if (name == "piecewise-cubic") return read_cubic(entries);
        if (name == "b-spline") return with_fit(read_bspline(entries), entries);
        if (name == "b-spline-graph") return with_fit(read_graph(entries), entries);
        if (name == "arcs") return read_arcs(entries);
        if (name == "log-aesthetic") return read_log_aesthetic(entries);
    } catch (const Error& error) {
        const bool is_placed = error.place().rfind(place, 0) == 0;
        throw is_placed ? error : error.at(place + ", " + error.place());
    }
    throw Error("curve.kind", entries.place("kind"), shown(kind),
                "piecewise-cubic, b-spline, b-spline-graph, arcs or log-aesthetic is needed here");
}

std::vector<Curve> parse_curves(const Source& source) {
    const std::string_view text = trimmed(utf8::without_byte_order_mark(source.bytes));
    if (text.empty()) {
        throw Error("file.empty", source.name, "no curve", "the file must hold a curve");
    }
    if (text[0] == '{') return curves_of(parse_json(source.bytes, source.name), source.name);
    if (text[0] == '<') return {parse_svg_path(first_svg_path(text, source.name), source.name)};
    if (text[0] == 'M' || text[0] == 'm') return {parse_svg_path(text, source.name)};
    throw wrong_format(source.name, utf8::shown(text[0]));
}

Curve parse_curve(const Source& source) { return one_curve(parse_curves(source), source.name); }

Curve read_curve(const std::string& path) { return parse_curve(read_source(path)); }

bool holds_curve(const Source& source) {
    const std::string suffix = suffix_of(source.name);
    if (suffix == "svg") return true;
    for (const char* table : {"csv", "tsv", "txt", "dat", "npy"}) {
        if (suffix == table) return false;
    }
    const std::string_view text = trimmed(utf8::without_byte_order_mark(source.bytes));
    if (text.empty()) return false;
    if (text[0] == '{' || text[0] == '<') return true;
    // Path data, and not a header: nothing but its own letters.
    return (text[0] == 'M' || text[0] == 'm') && text.size() > 1 &&
           text.find_first_not_of("MmLlHhVvCcSsQqTtAaZzEe0123456789+-., \t\r\n") ==
               std::string_view::npos;
}

}  // namespace batten
