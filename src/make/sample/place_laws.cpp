#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/motion.hpp"
#include "batten/measure/curvature.hpp"
#include "measure/arc/cells.hpp"

namespace batten {
namespace {

constexpr double tolerance = 1e-13;

double speed_at(const Jet& jet) {
    double speed = 0;
    for (const double x : jet[1]) speed = std::hypot(speed, x);
    return speed;
}

[[noreturn]] void refuse_no_weight(const char* what) {
    throw Error("motion.no-weight", "weights", "0", what);
}

/// The weights of a table at any arc length.
class WeightTable {
public:
    WeightTable(PointsView rows, double length) : rows_(rows) {
        constexpr double near = 1e-9;
        if (rows.dim() != 2 || rows.size() < 2) {
            throw Error("motion.weights", "weights", std::to_string(rows.size()),
                        "two or more rows of an arc length and a weight are needed");
        }
        double largest = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool is_ahead = i == 0 || rows(i, 0) > rows(i - 1, 0);
            if (!is_ahead) refuse(i, rows(i, 0), "arc lengths must increase");
            if (!(rows(i, 1) >= 0) || !std::isfinite(rows(i, 1))) {
                refuse(i, rows(i, 1), "weights must be finite and not negative");
            }
            largest = std::fmax(largest, rows(i, 1));
        }
        if (std::fabs(rows(0, 0)) > near * length) {
            refuse(0, rows(0, 0), "the first arc length must be 0");
        }
        if (std::fabs(rows(rows.size() - 1, 0) - length) > near * length) {
            refuse(rows.size() - 1, rows(rows.size() - 1, 0),
                   "the last arc length must be the curve's");
        }
        if (largest == 0) refuse_no_weight("at least one weight must be above 0");
        for (std::size_t i = 0; i < rows.size(); ++i) rows_(i, 1) /= largest;
    }

    double at(double s) const {
        std::size_t lo = 0, hi = rows_.size() - 1;
        while (hi - lo > 1) {
            const std::size_t middle = (lo + hi) / 2;
            (rows_(middle, 0) <= s ? lo : hi) = middle;
        }
        const double share = (s - rows_(lo, 0)) / (rows_(hi, 0) - rows_(lo, 0));
        return rows_(lo, 1) + std::clamp(share, 0.0, 1.0) * (rows_(hi, 1) - rows_(lo, 1));
    }
    const Points& rows() const { return rows_; }

private:
    [[noreturn]] static void refuse(std::size_t row, double value, const char* rule) {
        throw Error("motion.weights", "weights row " + std::to_string(row + 1),
                    format_number(value), rule, {row});
    }
    Points rows_;
};

/// Time per parameter at the parameters of a piece.
struct Density {
    Curve curve;
    ArcLengthMap map;
    std::optional<WeightTable> table;
    double curvature = 0;
    bool power = false;

    double at(std::size_t piece, double t) const {
        const Jet jet = curve.jet_on(piece, t, 2);
        const double speed = speed_at(jet);
        const double bend = std::fabs(batten::curvature(jet).value_or(0));
        double density = speed * (1 + curvature * bend);
        if (power) density *= std::cbrt(std::fmax(bend * map.length(), 1));
        if (table) density *= table->at(map.s_of(t));
        return density;
    }
};

/// Where the density may be not smooth: between the map's cells, at weights, where the bend changes
/// its side.
std::vector<double> joints_of(const Density& density) {
    const std::span<const double> joints = density.map.joints();
    std::vector<double> result(joints.begin(), joints.end());
    if (density.table) {
        for (std::size_t i = 1; i + 1 < density.table->rows().size(); ++i) {
            result.push_back(density.map.t_of(density.table->rows()(i, 0)));
        }
    }
    if (density.curve.dim() == 2 && (density.curvature > 0 || density.power)) {
        const std::vector<double> bends = inflections(density.curve);
        result.insert(result.end(), bends.begin(), bends.end());
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

/// A law from what is added up along the parameter; `rate` says how fast at t.
MotionLaw law_of(std::shared_ptr<const arc::Cells> cells, const Curve& curve,
                 const ArcLengthMap& map, std::function<double(double t)> rate) {
    const double total = cells->length();
    if (!(total > 0)) refuse_no_weight("some part of the curve must have a weight");
    const auto share_at = [cells, map](double sum) {
        return map.s_of(cells->t_at(sum)) / map.length();
    };
    const double even = total / curve.domain().length();
    return MotionLaw([=](double tau) -> MotionState {
        // Where no time is spent the speed is infinite: there, the mean over a short time.
        constexpr double least = 0x1p-20, step = 0x1p-10;
        const double sum = tau * total, share = tau >= 1 ? 1 : share_at(sum);
        const double t = cells->t_at(sum), here = rate(t);
        if (here > least * even) {
            return {share, speed_at(curve.jet(t, 1)) * total / (here * map.length())};
        }
        const double lo = std::fmax(tau - step, 0), hi = std::fmin(tau + step, 1);
        return {share, (share_at(hi * total) - share_at(lo * total)) / (hi - lo)};
    });
}

}  // namespace

MotionLaw weighted_law(const Curve& curve, const ArcLengthMap& map, const PlaceWeights& weights) {
    if (!(weights.curvature >= 0) || !std::isfinite(weights.curvature)) {
        throw Error("option.range", "curvature_weight", format_number(weights.curvature),
                    "must be finite and not negative");
    }
    Density density{curve, map, std::nullopt, weights.curvature, weights.power};
    if (!weights.rows.empty()) density.table.emplace(weights.rows, map.length());
    const std::vector<double> joints = joints_of(density);
    const auto rate = [&](std::span<const double> t, std::span<double> out) {
        // All of them lie in one piece: breaks are joints.
        const std::size_t piece = curve.piece_of(t[t.size() / 2]);
        for (std::size_t i = 0; i < t.size(); ++i) out[i] = density.at(piece, t[i]);
    };
    return law_of(std::make_shared<arc::Cells>(joints, rate, tolerance), curve, map,
                  [density](double t) { return density.at(density.curve.piece_of(t), t); });
}

MotionLaw parameter_law(const Curve& curve, const ArcLengthMap& map) {
    return MotionLaw([curve, map](double tau) -> MotionState {
        const Interval domain = curve.domain();
        const double t = tau >= 1 ? domain.hi : domain.lo + tau * domain.length();
        return {map.s_of(t) / map.length(),
                speed_at(curve.jet(t, 1)) * domain.length() / map.length()};
    });
}

namespace {

/// dr/dt as a curve.
struct HodographCurve {
    Curve whole;

    int dim() const { return whole.dim(); }
    std::span<const double> breaks() const { return whole.breaks(); }
    bool is_closed() const { return false; }
    std::optional<int> degree() const {
        const std::optional<int> degree = whole.degree();
        return degree ? std::optional<int>(std::max(*degree - 1, 0)) : std::nullopt;
    }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        const std::size_t dim = static_cast<std::size_t>(whole.dim());
        const std::size_t width = static_cast<std::size_t>(order + 1) * dim;
        std::vector<double> jet(width + dim);
        for (std::size_t i = 0; i < t.size(); ++i) {
            whole.jets_on(piece, t.subspan(i, 1), order + 1, jet);
            std::copy(jet.begin() + static_cast<std::ptrdiff_t>(dim), jet.end(),
                      out.begin() + static_cast<std::ptrdiff_t>(i * width));
        }
    }
};

}  // namespace

MotionLaw curvature_proxy_law(const Curve& curve, const ArcLengthMap& map) {
    try {
        const Curve hodograph = HodographCurve{curve};
        return law_of(std::make_shared<arc::Cells>(hodograph, relative(tolerance)), curve, map,
                      [hodograph](double t) { return speed_at(hodograph.jet(t, 1)); });
    } catch (const Error& error) {
        if (error.code() != "curve.no-length") throw;
        refuse_no_weight("the curve must bend, or its parameter accelerate");
    }
}

}  // namespace batten
