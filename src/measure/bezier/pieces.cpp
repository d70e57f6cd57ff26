#include "measure/bezier/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "measure/bezier/end_form.hpp"

namespace batten::bezier {
namespace {

using bernstein::Coefficients;

/// Normal coordinates whose fourth powers are still in the range of a double.
constexpr double widest_coordinate = 0x1p250;
/// x 2^exponent for any exponent, as two exact products.
class PowerOfTwo {
public:
    explicit PowerOfTwo(int exponent)
        : first_(std::ldexp(1.0, exponent / 2)),
          second_(std::ldexp(1.0, exponent - exponent / 2)) {}
    double times(double x) const { return x * first_ * second_; }

private:
    double first_, second_;
};

}  // namespace

Pieces::Pieces(const Curve& curve)
    : curve_(curve),
      dim_(curve.dim()),
      degree_(curve.degree() ? std::max(*curve.degree(), 1) : followed_degree) {
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        if (curve.degree()) {
            parts_.push_back({i, curve.piece(i), 0});
        } else {
            for (const Part& part : followed(curve, i)) parts_.push_back(part);
        }
    }
    fill();
    normalise();
}

std::size_t Pieces::position_start(std::size_t i, int k) const {
    const std::size_t stride = static_cast<std::size_t>(dim_ * (2 * degree_ + 1));
    return i * stride + static_cast<std::size_t>(k * (degree_ + 1));
}

std::size_t Pieces::hodograph_start(std::size_t i, int k) const {
    return position_start(i, dim_) + static_cast<std::size_t>(k * degree_);
}

double Pieces::t_of(std::size_t i, double u) const {
    const Interval t = part(i);
    return u == 1 ? t.hi : t.lo + u * t.length();
}

std::span<const double> Pieces::position(std::size_t i, int k) const {
    return {block_.data() + position_start(i, k), static_cast<std::size_t>(degree_ + 1)};
}

std::span<const double> Pieces::hodograph(std::size_t i, int k) const {
    return {block_.data() + hodograph_start(i, k), static_cast<std::size_t>(degree_)};
}

bernstein::Coefficients Pieces::above(std::size_t i, int k, double value) const {
    const auto at = [&](double t) {
        const double x = curve_.jet_on(source(i), t, 0)[0][static_cast<std::size_t>(k)];
        return std::ldexp(std::ldexp(x, -shrink_) - std::ldexp(value, -shrink_),
                          shrink_ - exponent_);
    };
    bernstein::Coefficients result(static_cast<std::size_t>(degree_ + 1));
    const auto h = hodograph(i, k);
    result[0] = at(part(i).lo);
    for (std::size_t j = 0; j < h.size(); ++j) {
        result[j + 1] = result[j] + h[j] / static_cast<double>(h.size());
    }
    result[h.size()] = at(part(i).hi);
    return result;
}

std::vector<double> Pieces::point(std::size_t i, double u) const {
    std::vector<double> result;
    for (int k = 0; k < dim_; ++k) result.push_back(bernstein::value(position(i, k), u));
    return result;
}

std::vector<double> Pieces::direction(std::size_t i, double u) const {
    const std::size_t count = static_cast<std::size_t>(degree_);
    std::vector<bernstein::Coefficients> h;
    double largest = 0;
    for (int k = 0; k < dim_; ++k) {
        largest = std::fmax(largest, bernstein::bound(hodograph(i, k)));
        const Interval ahead = u < 1 ? Interval{u, 1} : Interval{0, 1};
        h.push_back(bernstein::restricted(hodograph(i, k), ahead));
    }
    for (std::size_t j = 0; j < count; ++j) {
        std::vector<double> result;
        double length = 0;
        for (int k = 0; k < dim_; ++k) {
            result.push_back(h[k][u < 1 ? j : count - 1 - j]);
            length = std::hypot(length, result.back());
        }
        if (length <= 0x1p-50 * largest) continue;
        for (double& x : result) x /= length;
        return result;
    }
    return {};
}

std::vector<double> Pieces::to_normal(std::span<const double> point) const {
    std::vector<double> result;
    for (std::size_t k = 0; k < point.size(); ++k) {
        result.push_back(std::ldexp(std::ldexp(point[k], -shrink_) - origin_[k],
                                    shrink_ - exponent_));
    }
    return result;
}

Pieces Pieces::in_units_of(const Pieces& other) const {
    Pieces result = *this;
    const Jet first = curve_.jet_on(0, curve_.domain().lo, 0);
    const std::vector<double> offset = other.to_normal(first[0]);
    const int grow = exponent_ - other.exponent_;
    for (double& x : result.block_) x = std::ldexp(x, grow);
    for (std::size_t i = 0; i < size(); ++i) {
        for (int k = 0; k < dim_; ++k) {
            for (std::size_t j = 0; j < position(i, k).size(); ++j) {
                result.block_[position_start(i, k) + j] += offset[k];
            }
        }
    }
    for (const double x : result.block_) {
        if (!(std::fabs(x) < widest_coordinate)) {
            throw Error("number.overflow", "distance", "beyond a double",
                        "the curves are too far apart to be compared");
        }
    }
    for (Part& part : result.parts_) part.defect = std::ldexp(part.defect, grow);
    result.rounding_ = std::ldexp(rounding_, grow);
    result.extent_ = std::ldexp(extent_, grow);
    result.exponent_ = other.exponent_;
    result.shrink_ = other.shrink_;
    result.origin_ = other.origin_;
    return result;
}

double Pieces::in_data(double value, int power) const {
    const double result = std::ldexp(value, power * exponent_);
    if (!std::isfinite(result)) {
        throw Error("number.overflow", "measured value", "beyond a double",
                    "scale the points nearer to 1");
    }
    return result;
}

double Pieces::in_normal(Tolerance tolerance) const {
    return tolerance.is_relative ? tolerance.value * extent_
                                 : std::ldexp(tolerance.value, -exponent_);
}

std::vector<double> Pieces::to_normal_near(std::span<const double> point) const {
    std::vector<double> result = to_normal(point);
    for (const double x : result) {
        if (!(std::fabs(x) < widest_coordinate)) {
            throw Error("number.overflow", "distance", "beyond a double",
                        "the point is too far from the curve");
        }
    }
    return result;
}

std::vector<double> Pieces::to_data(std::span<const double> point) const {
    std::vector<double> result;
    for (std::size_t k = 0; k < point.size(); ++k) {
        result.push_back(in_data(point[k], 1) + std::ldexp(origin_[k], shrink_));
    }
    return result;
}

void Pieces::fill() {
    const int order = degree_ / 2;
    const std::size_t width = static_cast<std::size_t>(dim_ * (order + 1));
    std::vector<double> jets(2 * width * size());
    double largest = 0;
    for (std::size_t i = 0; i < size(); ++i) {
        const std::array<double, 2> t{part(i).lo, part(i).hi};
        const std::span<double> out(jets.data() + 2 * width * i, 2 * width);
        curve_.jets_on(source(i), t, order, out);
        require_finite_jet(out.first(width), source(i), t[0]);
        require_finite_jet(out.last(width), source(i), t[1]);
        for (int k = 0; k < dim_; ++k) {
            largest = std::fmax(largest, std::fmax(std::fabs(out[k]), std::fabs(out[width + k])));
        }
    }
    std::frexp(largest, &shrink_);
    const PowerOfTwo shrink(-shrink_);
    for (double& x : jets) x = shrink.times(x);
    origin_.assign(jets.begin(), jets.begin() + dim_);
    block_.resize(position_start(size(), 0));
    const EndForm form(degree_);
    Coefficients start(form.rows()), end(form.rows());
    for (std::size_t i = 0; i < size(); ++i) {
        const std::span<const double> all(jets.data() + 2 * width * i, 2 * width);
        for (int k = 0; k < dim_; ++k) {
            form.take(all.first(width), static_cast<std::size_t>(k), part(i).length(), start);
            form.take(all.last(width), static_cast<std::size_t>(k), -part(i).length(), end);
            const std::span<double> block(block_);
            form.write_hodograph(start, end,
                                 block.subspan(hodograph_start(i, k), hodograph(i, k).size()));
            start[0] -= origin_[k];
            end[0] -= origin_[k];
            form.write_position(start, end,
                                block.subspan(position_start(i, k), position(i, k).size()));
        }
    }
}

void Pieces::normalise() {
    double largest = 0;
    std::vector<double> lo(dim_), hi(dim_);
    for (std::size_t i = 0; i < size(); ++i) {
        for (int k = 0; k < dim_; ++k) {
            for (const double x : position(i, k)) {
                largest = std::fmax(largest, std::fabs(x));
                lo[k] = std::fmin(lo[k], x);
                hi[k] = std::fmax(hi[k], x);
            }
        }
    }
    require_finite_jet(block_, 0, part(0).lo);
    int grow = 0;
    std::frexp(largest, &grow);
    const PowerOfTwo shrink(-grow);
    for (double& x : block_) x = shrink.times(x);
    exponent_ = shrink_ + grow;
    for (int k = 0; k < dim_; ++k) extent_ = std::fmax(extent_, std::ldexp(hi[k] - lo[k], -grow));
    for (Part& part : parts_) part.defect = std::ldexp(part.defect, -exponent_);
    rounding_ = std::ldexp(0x1p-52, -grow);
}

void require_tolerance(Tolerance tolerance) {
    if (!(tolerance.value > 0) || !std::isfinite(tolerance.value)) {
        throw Error("option.range", "tolerance", format_number(tolerance.value),
                    "a tolerance must be a positive number");
    }
}

}  // namespace batten::bezier
