#include "io/exchange/curve_covariance.hpp"

#include "batten/base/text.hpp"
#include "make/fit/covariance.hpp"

namespace batten::exchange {
namespace {

using fitting::CoefficientLaw;

Value numbers(std::span<const double> row) { return ValueList(row.begin(), row.end()); }

Value rows_of(const std::vector<std::vector<double>>& rows) {
    ValueList list;
    for (const std::vector<double>& row : rows) list.emplace_back(numbers(row));
    return list;
}

ValueMap law_value(const CoefficientLaw& law) {
    const num::BandedQr& qr = law.qr();
    const num::BandShape& shape = qr.shape();
    const auto width = static_cast<std::size_t>(shape.width + shape.border);
    ValueList rows, border;
    for (int j = 0; j < shape.columns; ++j) rows.emplace_back(numbers({qr.row(j), width}));
    for (int j = 0; j < shape.border; ++j) {
        border.emplace_back(
            numbers({qr.border_row(j), static_cast<std::size_t>(shape.border)}));
    }
    const SplineFunction& spline = law.spline();
    return {{"closed", spline.is_closed()},
            {"degree", spline.degree()},
            {"knots", numbers(spline.knots())},
            {"coefficients", numbers(spline.coefficients())},
            {"triangle", std::move(rows)},
            {"border", std::move(border)},
            {"known", rows_of(law.known())}};
}

SplineFunction spline_in(const Entries& law) {
    const int degree = law.whole("degree");
    std::vector<double> knots = law.numbers("knots"), coefficients = law.numbers("coefficients");
    return law.truth("closed")
               ? SplineFunction::periodic(std::move(knots), std::move(coefficients), degree)
               : SplineFunction(std::move(knots), std::move(coefficients), degree);
}

/// Rows of `width` numbers each, one after the other.
std::vector<double> block_in(const Entries& law, const char* key, std::size_t width) {
    std::vector<double> block;
    const ValueList& rows = law.list(key);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        law.append_row(block, rows[i], width, Entries::at(key, i));
    }
    return block;
}

CoefficientLaw law_in(const Entries& law) {
    SplineFunction spline = spline_in(law);
    const std::size_t degree = static_cast<std::size_t>(spline.degree());
    const std::size_t functions =
        spline.coefficients().size() - (spline.is_closed() ? degree : 0);
    const std::size_t columns = law.list("triangle").size();
    const std::size_t border = law.list("border").size();
    require_size(law, "triangle", columns + border, functions);
    require_size(law, "border", border, spline.is_closed() ? border : 0);
    const std::size_t width = columns > 0 ? degree + 1 : 0;
    if (width > columns) {
        throw Error("curve.entry", law.place("triangle"), "a list of " + std::to_string(columns),
                    "as many rows as the degree and 1 are needed here, or none");
    }
    std::vector<std::vector<double>> known;
    const ValueList& forms = law.list("known");
    for (std::size_t i = 0; i < forms.size(); ++i) {
        law.append_row(known.emplace_back(), forms[i], functions, Entries::at("known", i));
    }
    const num::BandShape shape{static_cast<int>(width), static_cast<int>(columns),
                               static_cast<int>(border), 0};
    return CoefficientLaw(std::move(spline),
                          num::BandedQr(shape, block_in(law, "triangle", width + border),
                                        block_in(law, "border", border)),
                          std::move(known));
}

double positive(const Entries& entries, const char* key, double least) {
    const double x = entries.number(key);
    if (x >= least) return x;
    throw Error("curve.entry", entries.place(key), format_number(x),
                "must be at least " + format_number(least));
}

}  // namespace

Value covariance_value(const FitCovariance& covariance) {
    const FitCovariance::Model& model = covariance.model();
    ValueList alternatives;
    for (const fitting::Alternative& a : model.alternatives) {
        ValueMap map = law_value(a.law);
        map.insert(map.begin(), {"weight", a.weight});
        alternatives.emplace_back(std::move(map));
    }
    return ValueMap{{"scale", model.width.scale},
                    {"degrees", model.width.degrees},
                    {"spline", law_value(model.own)},
                    {"alternatives", std::move(alternatives)}};
}

FitCovariance covariance_in(const Entries& curve) {
    const Entries fit = curve.inside("fit");
    FitCovariance::Model model{law_in(fit.inside("spline")), {}, {}};
    model.width = {positive(fit, "scale", 0), positive(fit, "degrees", 0)};
    const ValueList& alternatives = fit.list("alternatives");
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
        const Entries one(alternatives[i], fit.place(Entries::at("alternatives", i)));
        model.alternatives.push_back({positive(one, "weight", 0), law_in(one)});
    }
    return FitCovariance(std::make_shared<FitCovariance::Model>(std::move(model)));
}

}  // namespace batten::exchange
