#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"
#include "measure/arc/cells.hpp"
#include "measure/arc/later.hpp"

namespace batten::arc {

/// The cells of a curve in sections, each made when it is first asked for.
///
/// A plain cubic curve, of which `cubic_lengths` leaves no piece out, has a section a piece: only
/// the lengths are found at once. Every other curve is one section, made at once.
class Sections {
public:
    /// Throws what `ArcLengthMap` does.
    Sections(const Curve& curve, Tolerance tolerance);

    double length() const { return s_.back(); }
    double error() const { return error_; }
    Interval domain() const { return {t_.front(), t_.back()}; }
    /// Where cells meet, in t. Makes all sections.
    std::span<const double> joints() const;

    /// For 0 <= s <= length and t in the domain.
    double t_at(double s) const;
    double s_at(double t) const;
    void t_at(std::span<const double> s, std::span<double> t) const;

private:
    bool lay_plain(Tolerance tolerance);
    const Cells& cells(std::size_t section) const;
    Cells cells_of_piece(std::size_t piece) const;
    /// What lengths within the section, which were integrated otherwise, are in its cells.
    double to_cells(std::size_t section, const Cells& cells) const;

    Curve curve_;
    double allowed_ = 0;          // error of a cell, as a share of its section
    std::vector<double> s_, t_;   // where sections meet, both ends of the curve included
    std::vector<Later<Cells>> cells_;
    std::vector<chebyshev::Basis> bases_;
    Later<std::vector<double>> joints_;
    double error_ = 0;
};

}  // namespace batten::arc
