#include "measure/arc/sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "measure/arc/cubic_lengths.hpp"
#include "measure/arc/runs.hpp"
#include "num/sum.hpp"

namespace batten::arc {
namespace {

/// Of the curve's length: a cell that is shorter may be passed at any rate.
constexpr double nothing = 0x1p-70;
/// Arc lengths that are handed on at a time.
constexpr std::size_t handful = 256;

/// The sum of the chords, which the curve is no shorter than.
double chord_sum(const PiecewiseCubic& curve) {
    double sum = 0;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        double chord_sq = 0;
        for (int k = 0; k < curve.dim(); ++k) {
            const std::span<const double> joint = curve.coefficients(0, k);
            chord_sq += (joint[i + 1] - joint[i]) * (joint[i + 1] - joint[i]);
        }
        sum += std::sqrt(chord_sq);
    }
    return sum;
}

/// The hodograph of a piece over w = u / h.
bezier::Stretch whole_stretch(const PiecewiseCubic& curve, std::size_t piece) {
    bezier::Stretch stretch;
    stretch.piece = piece;
    stretch.dim = curve.dim();
    stretch.p = bernstein::Coefficients(3 * static_cast<std::size_t>(curve.dim()));
    double* next = stretch.p.data();
    const double h = curve.breaks()[piece + 1] - curve.breaks()[piece];
    for (int k = 0; k < curve.dim(); ++k) {
        const double a = h * curve.coefficients(1, k)[piece];
        const double b = h * h * curve.coefficients(2, k)[piece];
        const double c = h * h * h * curve.coefficients(3, k)[piece];
        *next++ = a;
        *next++ = a + b;
        *next++ = a + 2 * b + 3 * c;
    }
    return stretch;
}

}  // namespace

Sections::Sections(const Curve& curve, Tolerance tolerance) : curve_(curve) {
    bezier::require_tolerance(tolerance);
    if (lay_plain(tolerance)) return;
    cells_ = std::vector<Later<Cells>>(1);
    const Cells& all = cells_[0].get([&] { return Cells(curve, tolerance); });
    s_ = {0, all.length()};
    t_ = {all.joints().front(), all.joints().back()};
    error_ = all.error();
}

bool Sections::lay_plain(Tolerance tolerance) {
    const auto* cubic = curve_.shape<PiecewiseCubic>();
    if (!cubic) return false;
    const double wanted = 0.25 * tolerance.in_units(chord_sum(*cubic));
    if (!(wanted > 0 && std::isfinite(wanted))) return false;
    const CubicLengths lengths = cubic_lengths(*cubic, absolute(wanted));
    if (!lengths.left_out.empty()) return false;
    num::Sum s, error;
    s_.assign(1, 0);
    for (const Measured& piece : lengths.pieces) {
        s.add(piece.value);
        error.add(piece.error);
        s_.push_back(s.value());
    }
    error_ = error.value();
    t_.assign(curve_.breaks().begin(), curve_.breaks().end());
    allowed_ = tolerance.is_relative ? tolerance.value : tolerance.value / length();
    for (std::size_t degree = 0; degree < 3; ++degree) bases_.emplace_back(degree);
    cells_ = std::vector<Later<Cells>>(lengths.pieces.size());
    return true;
}

Cells Sections::cells_of_piece(std::size_t piece) const {
    const auto& cubic = *curve_.shape<PiecewiseCubic>();
    return {speed_of(whole_stretch(cubic, piece), bases_), curve_.piece(piece),
            {allowed_, s_[piece + 1] - s_[piece], nothing * length()}};
}

const Cells& Sections::cells(std::size_t section) const {
    return cells_[section].get([&] { return cells_of_piece(section); });
}

double Sections::to_cells(std::size_t section, const Cells& cells) const {
    const double length = s_[section + 1] - s_[section];
    return length > 0 ? cells.length() / length : 0;
}

std::span<const double> Sections::joints() const {
    if (cells_.size() == 1) return cells(0).joints();
    return joints_.get([&] {
        std::vector<double> all{t_.front()};
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const std::span<const double> some = cells(i).joints();
            all.insert(all.end(), some.begin() + 1, some.end());
        }
        return all;
    });
}

double Sections::t_at(double s) const {
    double t;
    t_at({&s, 1}, {&t, 1});
    return t;
}

double Sections::s_at(double t) const {
    const std::size_t section = interval_of(t_, t);
    const Cells& inside = cells(section);
    const double scale = to_cells(section, inside);
    const double s = inside.s_in(inside.cell_at_t(t), t);
    return scale > 0 ? std::fmin(s_[section] + s / scale, s_[section + 1]) : s_[section];
}

void Sections::t_at(std::span<const double> s, std::span<double> t) const {
    std::array<double, handful> local;
    for_runs(s_, s, [&](std::size_t section, std::size_t first, std::size_t count) {
        const Cells& inside = cells(section);
        const double start = s_[section], scale = to_cells(section, inside);
        for (std::size_t done = 0; done < count; done += handful) {
            const std::size_t some = std::min(handful, count - done);
            for (std::size_t i = 0; i < some; ++i) {
                local[i] = std::fmin((s[first + done + i] - start) * scale, inside.length());
            }
            inside.t_at({local.data(), some}, t.subspan(first + done, some));
        }
    });
}

}  // namespace batten::arc
