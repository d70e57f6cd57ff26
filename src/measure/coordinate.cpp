#include "batten/measure/coordinate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "measure/bezier/zeros.hpp"
#include "num/sum.hpp"

namespace batten {
namespace {

using bezier::Pieces;

void require_coordinate(const Curve& curve, int coordinate) {
    if (coordinate < 0 || coordinate >= curve.dim()) {
        throw Error("curve.coordinate", "coordinate", std::to_string(coordinate),
                    "must be 0 to " + std::to_string(curve.dim() - 1));
    }
}

double value_at(const Curve& curve, std::size_t piece, double t, int coordinate) {
    return curve.jet_on(piece, t, 0)[0][static_cast<std::size_t>(coordinate)];
}

/// Where the coordinate rises or falls.
struct Slope {
    Interval t;
    int sign;
};

std::vector<Slope> slopes(const Pieces& pieces, int k) {
    std::vector<Slope> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto h = pieces.hodograph(i, k);
        const double size = bernstein::bound(pieces.above(i, k, 0));
        const double noise = 0x1p-50 * (bernstein::bound(h) + 4 * size) + 16 * pieces.defect(i);
        for (const bernstein::SignRun& run : bernstein::sign_runs(h, noise)) {
            const Interval t{pieces.t_of(i, run.where.lo), pieces.t_of(i, run.where.hi)};
            if (!result.empty() && result.back().sign == run.sign) {
                result.back().t.hi = t.hi;
            } else {
                result.push_back({t, run.sign});
            }
        }
    }
    return result;
}

}  // namespace

double integral(const Curve& curve, int coordinate, Interval part) {
    require_coordinate(curve, coordinate);
    if (part.lo == part.hi && curve.domain().contains(part.lo)) return 0;
    if (part.lo > part.hi) return -integral(curve, coordinate, {part.hi, part.lo});
    const Pieces pieces(trimmed(curve, part));
    num::Sum sum;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bernstein::Coefficients c = pieces.above(i, coordinate, 0);
        double mean = 0;
        for (const double x : c) mean += x / static_cast<double>(c.size());
        sum.add(mean * pieces.part(i).length());
    }
    return pieces.in_data(sum.value(), 1);
}

std::vector<double> roots(const Curve& curve, int coordinate, double value) {
    require_coordinate(curve, coordinate);
    const Pieces pieces(curve);
    bezier::Zeros zeros(pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bernstein::Coefficients c = pieces.above(i, coordinate, value);
        zeros.add(i, c, 0x1p-50 * bernstein::bound(c) + pieces.defect(i));
    }
    return zeros.parameters();
}

std::vector<Extremum> extrema(const Curve& curve, int coordinate) {
    require_coordinate(curve, coordinate);
    const std::vector<Slope> parts = slopes(Pieces(curve), coordinate);
    std::vector<Extremum> result;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const double t = Interval{parts[i].t.hi, parts[i + 1].t.lo}.middle();
        result.push_back({t, value_at(curve, curve.piece_of(t), t, coordinate),
                          parts[i].sign > 0 ? ExtremumKind::maximum : ExtremumKind::minimum});
    }
    return result;
}

Interval range(const Curve& curve, int coordinate) {
    require_coordinate(curve, coordinate);
    const double first = value_at(curve, 0, curve.domain().lo, coordinate);
    Interval result{first, first};
    const auto include = [&](double x) {
        result = {std::fmin(result.lo, x), std::fmax(result.hi, x)};
    };
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        include(value_at(curve, i, curve.piece(i).lo, coordinate));
        include(value_at(curve, i, curve.piece(i).hi, coordinate));
    }
    for (const Extremum& extremum : extrema(curve, coordinate)) include(extremum.value);
    return result;
}

}  // namespace batten
