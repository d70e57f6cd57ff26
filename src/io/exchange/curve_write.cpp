#include <optional>

#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "batten/shape/spline_graph.hpp"
#include "batten/shape/transform.hpp"
#include "io/exchange/curve_covariance.hpp"

namespace batten {
namespace {

Value numbers(std::span<const double> row) { return ValueList(row.begin(), row.end()); }

Value rows(PointsView points) {
    ValueList list;
    for (std::size_t i = 0; i < points.size(); ++i) list.emplace_back(numbers(points[i]));
    return list;
}

ValueMap heading(const char* kind, const std::string& name) {
    ValueMap map{{"format", "batten.curve/1"}, {"kind", kind}};
    if (!name.empty()) map.emplace_back("name", name);
    return map;
}

Value cubic_value(const PiecewiseCubic& curve, const std::string& name) {
    ValueMap map = heading("piecewise-cubic", name);
    map.emplace_back("dimension", curve.dim());
    map.emplace_back("closed", curve.is_closed());
    map.emplace_back("breaks", numbers(curve.breaks()));
    map.emplace_back("points", rows(curve.joints()));
    ValueList pieces;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        ValueList powers;
        for (int power = 1; power <= 3; ++power) {
            ValueList vector;
            for (int k = 0; k < curve.dim(); ++k) {
                vector.emplace_back(curve.coefficients(power, k)[i]);
            }
            powers.emplace_back(std::move(vector));
        }
        pieces.emplace_back(std::move(powers));
    }
    map.emplace_back("coefficients", std::move(pieces));
    return map;
}

/// A closed curve lists the knots of one period as BSplineBasis::periodic takes them: the start as
/// often as it stands, the end once. In knots() the last of the starts begins the period, and the
/// others stand at its end.
std::vector<double> listed_knots(const BSplineBasis& basis) {
    std::vector<double> knots(basis.knots().begin(), basis.knots().end());
    if (!basis.is_periodic()) return knots;
    const std::ptrdiff_t margin = basis.degree();
    knots = {knots.begin() + margin, knots.end() - margin};
    const double start = knots.front(), end = knots.back();
    while (knots[knots.size() - 2] == end) {
        knots.pop_back();
        knots.insert(knots.begin(), start);
    }
    return knots;
}

Value bspline_value(const BSplineCurve& curve, const std::string& name) {
    ValueMap map = heading("b-spline", name);
    map.emplace_back("dimension", curve.dim());
    map.emplace_back("closed", curve.is_closed());
    map.emplace_back("degree", curve.basis().degree());
    map.emplace_back("knots", numbers(listed_knots(curve.basis())));
    map.emplace_back("control_points", rows(curve.control_points()));
    if (curve.is_rational()) map.emplace_back("weights", numbers(curve.weights()));
    return map;
}

Value graph_value(const SplineFunction& spline, const std::string& name) {
    ValueMap map = heading("b-spline-graph", name);
    map.emplace_back("degree", spline.degree());
    map.emplace_back("knots", numbers(spline.knots()));
    map.emplace_back("coefficients", numbers(spline.coefficients()));
    return map;
}

Value with_fit(Value value, const Curve& curve) {
    if (const FitCovariance* covariance = covariance_of(curve)) {
        value.map()->emplace_back("fit", exchange::covariance_value(*covariance));
    }
    return value;
}

Value arcs_value(const ArcChain& chain, const std::string& name) {
    ValueMap map = heading("arcs", name);
    map.emplace_back("dimension", 2);
    map.emplace_back("closed", chain.is_closed());
    map.emplace_back("points", rows(chain.joints()));
    map.emplace_back("bulges", numbers(chain.bulges()));
    return map;
}

Value log_aesthetic_value(const LogAestheticCurve& curve, const std::string& name) {
    ValueMap map = heading("log-aesthetic", name);
    map.emplace_back("closed", curve.is_closed());
    map.emplace_back("points", rows(curve.joints()));
    map.emplace_back("angles", numbers(curve.angles()));
    ValueList arcs;
    for (const LogAestheticSegment& s : curve.segments()) {
        arcs.emplace_back(ValueList{s.alpha, s.length, s.start_curvature, s.end_curvature});
    }
    map.emplace_back("arcs", std::move(arcs));
    return map;
}

}  // namespace

Value curve_value(const Curve& curve, const std::string& name) {
    if (const BSplineCurve* bspline = curve.shape<BSplineCurve>()) {
        return with_fit(bspline_value(*bspline, name), curve);
    }
    if (const SplineGraph* graph = curve.shape<SplineGraph>()) {
        return with_fit(graph_value(graph->spline(), name), curve);
    }
    if (const ArcChain* chain = curve.shape<ArcChain>()) return arcs_value(*chain, name);
    if (const LogAestheticCurve* arcs = curve.shape<LogAestheticCurve>()) {
        return log_aesthetic_value(*arcs, name);
    }
    if (const std::optional<PiecewiseCubic> cubic = exact_cubic(curve)) {
        return cubic_value(*cubic, name);
    }
    throw Error("curve.not-exact", "curve",
                curve.degree() ? "degree " + std::to_string(*curve.degree()) : "no polynomial",
                "this curve has no exact file form: convert it to cubic pieces first");
}

}  // namespace batten
