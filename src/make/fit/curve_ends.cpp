#include "make/fit/curve_ends.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/normals.hpp"

namespace batten::fitting {
namespace {

/// sum over sides of factor[side] c_side[at] - factor[side] c_side[less] = value; `less` may be none.
struct Condition {
    std::vector<double> factor;
    int at = 0;
    int less = -1;
    double value = 0;
};

void add_point(const std::vector<double>& point, int at, std::vector<Condition>& to) {
    for (std::size_t s = 0; s < point.size(); ++s) {
        Condition c{std::vector<double>(point.size(), 0.0), at, -1, point[s]};
        c.factor[s] = 1;
        to.push_back(std::move(c));
    }
}

void add_tangent(const std::vector<double>& tangent, int at, int less,
                 std::vector<Condition>& to) {
    if (tangent.empty()) return;
    Vector along{};
    std::copy(tangent.begin(), tangent.end(), along.begin());
    const std::size_t dim = tangent.size();
    const std::array<Vector, 2> normals = normals_of(along, static_cast<int>(dim));
    for (std::size_t n = 0; n + 1 < dim; ++n) {
        to.push_back({{normals[n].begin(), normals[n].begin() + static_cast<std::ptrdiff_t>(dim)},
                      at, less, 0});
    }
}

std::vector<Condition> conditions_of(const CurveEnds& ends, int functions) {
    std::vector<Condition> all;
    add_point(ends.start_point, 0, all);
    add_point(ends.end_point, functions - 1, all);
    add_tangent(ends.start_tangent, 1, 0, all);
    add_tangent(ends.end_tangent, functions - 1, functions - 2, all);
    return all;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// All coordinates' unknowns one after the other, in which delta2 is a sum of squares: z = R c.
class Stacked {
public:
    explicit Stacked(const num::BandedQr& qr)
        : qr_(qr), count_(static_cast<std::size_t>(qr.shape().columns)) {
        for (int s = 0; s < qr.shape().sides; ++s) {
            for (std::size_t j = 0; j < count_; ++j) {
                z_.push_back(qr.row(static_cast<int>(j))[qr.shape().width + s]);
            }
        }
    }

    /// Takes the nearest z that keeps the condition beside those before; false where these leave
    /// no room.
    bool keep(const Condition& condition) {
        std::vector<double> q = form(condition);
        const double before = product(q, q);
        double value = condition.value;
        // Twice is enough [GolubVanLoan2013, 5.2.8].
        for (int pass = 0; pass < 2; ++pass) {
            for (const Known& k : known_) {
                const double part = product(k.q, q);
                for (std::size_t i = 0; i < q.size(); ++i) q[i] -= part * k.q[i];
                value -= part * k.value;
            }
        }
        const double norm = std::sqrt(product(q, q));
        if (!(norm > 1e-10 * std::sqrt(before))) return false;
        for (double& x : q) x /= norm;
        value /= norm;
        const double step = value - product(q, z_);
        for (std::size_t i = 0; i < q.size(); ++i) z_[i] += step * q[i];
        known_.push_back({std::move(q), value});
        return true;
    }

    std::vector<double> coefficients(std::size_t side) const {
        std::vector<double> c(count_);
        qr_.solve_for(std::span(z_).subspan(side * count_, count_), c);
        return c;
    }

private:
    struct Known {
        std::vector<double> q;
        double value;
    };

    std::vector<double> form(const Condition& c) const {
        std::vector<double> all;
        std::vector<double> one(count_);
        for (const double factor : c.factor) {
            std::fill(one.begin(), one.end(), 0.0);
            one[static_cast<std::size_t>(c.at)] = factor;
            if (c.less >= 0) one[static_cast<std::size_t>(c.less)] = -factor;
            qr_.solve_transposed(one);
            all.insert(all.end(), one.begin(), one.end());
        }
        return all;
    }

    const num::BandedQr& qr_;
    std::size_t count_;
    std::vector<double> z_;
    std::vector<Known> known_;
};

std::vector<double> unit_tangent(const char* option, std::span<const double> given, int dim) {
    if (given.empty()) return {};
    double length = 0;
    for (const double d : given) length = std::hypot(length, d);
    if (static_cast<int>(given.size()) != dim || !(length > 0) || !std::isfinite(length)) {
        std::string value;
        for (const double d : given) value += (value.empty() ? "" : ",") + format_number(d);
        throw Error("fit.tangent", option, value,
                    "a direction has as many coordinates as the points, " + std::to_string(dim) +
                        ", finite and not all 0");
    }
    std::vector<double> unit(given.begin(), given.end());
    for (double& d : unit) d /= length;
    return unit;
}

bool is_along(std::span<const SplineFunction> curve, double t, const std::vector<double>& tangent) {
    double speed = 0;
    for (std::size_t s = 0; s < tangent.size(); ++s) speed += curve[s](t, 1) * tangent[s];
    return tangent.empty() || speed > 0;
}

}  // namespace

bool has_curve_ends(const FitOptions& o) {
    return o.fix_ends || !o.start_tangent.empty() || !o.end_tangent.empty();
}

CurveEnds curve_ends(PointsView points, const FitOptions& options) {
    CurveEnds ends;
    if (!has_curve_ends(options)) return ends;
    if (options.closed) {
        throw Error("fit.options", "closed", "true", "a closed curve has no ends to hold");
    }
    if (options.fix_ends) {
        const auto first = points[0], last = points[points.size() - 1];
        ends.start_point.assign(first.begin(), first.end());
        ends.end_point.assign(last.begin(), last.end());
    }
    ends.start_tangent = unit_tangent("start_tangent", options.start_tangent, points.dim());
    ends.end_tangent = unit_tangent("end_tangent", options.end_tangent, points.dim());
    return ends;
}

bool hold_ends(FixedFit& fixed, const CurveEnds& ends, int directions) {
    const std::vector<Condition> conditions = conditions_of(ends, fixed.functions);
    if (conditions.empty() || !fixed.undetermined.empty()) return true;
    Stacked stacked(fixed.system.qr());
    int kept = 0;
    for (const Condition& c : conditions) kept += stacked.keep(c) ? 1 : 0;
    const std::size_t sides = static_cast<std::size_t>(fixed.system.qr().shape().sides);
    const int points = (ends.start_point.empty() ? 0 : 1) + (ends.end_point.empty() ? 0 : 1);
    fixed.fixed_count = kept - points * (static_cast<int>(sides) - directions);
    fixed.limited.clear();
    for (std::size_t s = 0; s < sides; ++s) {
        fixed.limited.push_back(stacked.coefficients(s));
        // Rounding aside they are there already.
        if (!ends.start_point.empty()) fixed.limited[s].front() = ends.start_point[s];
        if (!ends.end_point.empty()) fixed.limited[s].back() = ends.end_point[s];
    }
    return kept == static_cast<int>(conditions.size());
}

bool goes_along(std::span<const SplineFunction> curve, const CurveEnds& ends) {
    const Interval domain = curve[0].domain();
    return is_along(curve, domain.lo, ends.start_tangent) &&
           is_along(curve, domain.hi, ends.end_tangent);
}

}  // namespace batten::fitting
