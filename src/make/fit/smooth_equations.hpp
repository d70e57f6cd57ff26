#pragma once

#include <span>
#include <vector>

#include "make/fit/knot_system.hpp"
#include "num/banded_qr.hpp"

namespace batten::fitting {

/// Equations in a spline's coefficients, in a line or a ring: what data say, each scaled to length
/// 1, and that differences vanish, lightly. So however different the errors of the data are, the
/// differences weigh nothing beside what is determined.
class SmoothEquations {
public:
    SmoothEquations(int functions, Ends ends, TriangleShape shape);

    /// All equations of a triangle whose unknowns are numbered as in `system`.
    void add_triangle(const KnotSystem& system);
    /// The differences of `order` of all coefficients.
    void add_differences(int order, Ends ends);

    /// The coefficients of all sides, one side after the other, that solve the data's equations
    /// (which must not contradict each other), the differences as small as they then can be.
    std::vector<double> solution();
    /// The triangle of the equations at their true scale, the differences lightly beside the least.
    num::BandedQr triangle() const;

private:
    void begin(int lowest);
    double& entry(int function);
    std::span<double> row(std::size_t i) {
        return std::span(entries_).subspan(i * row_width(), row_width());
    }
    std::size_t row_width() const { return static_cast<std::size_t>(shape_.row_width()); }
    std::size_t reach() const { return static_cast<std::size_t>(shape_.width + shape_.border); }
    std::size_t at(int start, int function) const;
    void scale_to_one(const double* sides);
    num::BandedQr reduced(std::span<const double> scales) const;
    std::vector<double> solved() const;
    void subtract(std::span<const double> coefficients);

    int functions_;
    num::BandShape shape_;
    std::size_t data_ = 0;            ///< so many of the equations are the data's
    std::vector<int> starts_;         ///< the column of the band where each starts
    std::vector<double> lengths_;     ///< of the data's, before they were scaled
    std::vector<double> entries_;
};

}  // namespace batten::fitting
