#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"
#include "measure/arc/cell.hpp"

namespace batten::arc {

/// The cells of a whole curve in order, in data units, their coefficients one after the other.
class Cells {
public:
    /// Throws what `ArcLengthMap` does.
    Cells(const Curve& curve, Tolerance tolerance);

    /// The same of any rate over t, smooth between the joints (rising): `tolerance` is a share of
    /// the whole. Towards places where it is not smooth the cells are halved.
    Cells(std::span<const double> joints, const Rate& rate, double tolerance);

    /// What a single smooth piece may be wrong by.
    struct Share {
        double tolerance = 0;  ///< of its length
        double length = 0;     ///< about
        double nothing = 0;    ///< an error that is none
    };
    /// The same over w in [0, 1] of one piece, w running evenly over `t`.
    Cells(const Rate& rate, Interval t, const Share& share);

    double length() const { return s_.back(); }
    double error() const { return error_; }
    std::size_t size() const { return t_.size() - 1; }
    Interval t(std::size_t cell) const { return {t_[cell], t_[cell + 1]}; }
    Interval s(std::size_t cell) const { return {s_[cell], s_[cell + 1]}; }
    std::span<const double> joints() const { return t_; }

    /// The cell that holds t; of two that meet there the second.
    std::size_t cell_at_t(double t) const;
    /// The arc length at a parameter of this cell; exact at both of its ends.
    double s_in(std::size_t cell, double t) const;
    double t_at(double s) const;
    /// The parameters at many arc lengths, each in [0, length()]; the same bits as one by one.
    void t_at(std::span<const double> s, std::span<double> t) const;

private:
    struct Sum {
        std::uint32_t start = 0, terms = 0;
    };
    struct Built;
    void t_in(std::size_t cell, std::span<const double> s, std::span<double> t) const;
    template <class InData>
    void take(Built built, double start, InData in_data);
    std::span<const double> terms_of(Sum sum) const {
        return {coefficients_.data() + sum.start, sum.terms};
    }

    std::vector<double> s_, t_;  // where cells meet, both ends of the curve included
    std::vector<Sum> forward_, inverse_;
    std::vector<double> coefficients_;
    double error_ = 0;
};

}  // namespace batten::arc
