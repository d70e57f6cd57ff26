#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/shape/surface.hpp"

/// Surfaces of either kind cut into pieces on which they are smooth.
namespace batten::surfaces {

/// A line from the lower to the upper side of a sheet: between two knot lines that follow one
/// another, at a share of the way.
struct SheetLine {
    std::size_t interval = 0;
    double share = 0;
};

/// What is between two lines of a lattice: of one interval, or a wall, where the surface jumps and
/// both lines are at one place.
struct SheetColumn {
    std::size_t interval = 0;
    bool is_wall = false;
};

/// A surface over knot lines x = X_i(y): intervals between neighbours, in each of which it is
/// smooth in x, and strips between straight knot lines of constant y. Surfaces whose curved lines
/// are y = Y_j(x) are seen with x and y exchanged (`is_transposed`); where lines of both kinds are
/// curved, those of y only bend the sheet.
///
/// Keeps a reference to the surface.
class Sheet {
public:
    explicit Sheet(const SplineSurface& surface);
    explicit Sheet(const CurvedKnotSurface& surface);
    explicit Sheet(const Surface& surface);

    bool is_transposed() const { return transposed_ != nullptr; }
    Rectangle domain() const;
    /// The lowest degree of x and y.
    int degree() const;
    /// Whether slopes may jump across knot lines: as many coincide as the degree.
    bool has_kinks() const;

    /// The ends of the x-domain and the knot lines between, at `y`.
    std::vector<double> knots(double y) const;
    /// Where strips meet, the ends of the y-domain among them.
    std::vector<double> strips() const;
    /// Intervals that are not empty everywhere, rising.
    const std::vector<std::size_t>& intervals() const { return intervals_; }

    /// Lines that cut intervals()[k] into each[k] equal columns.
    std::vector<SheetLine> lines(std::span<const std::size_t> each) const;
    static SheetColumn column_after(const SheetLine& line) {
        return {line.interval, line.share == 1};
    }
    static double place(const SheetLine& line, std::span<const double> knots);
    /// The interval that line number `c` is a side of; one that is not empty, if it has a choice.
    static std::size_t home_of(std::span<const SheetLine> lines, std::size_t c,
                               std::span<const double> knots);

    /// The place at `to` that shares its interval as `x` does at `from`: along curved knot lines.
    double along(double x, double from, double to) const;

    /// The function of one interval (KnotCell::found: of the one that holds the place), continued.
    double value_in(std::size_t interval, double x, double y) const;
    HeightJet jet_in(std::size_t interval, double x, double y) const;
    /// On all lines at all ordinates `y`, rising.
    Grid heights(std::span<const SheetLine> lines, std::span<const double> y) const;

private:
    void find_intervals();

    const SplineSurface* product_ = nullptr;
    std::shared_ptr<const CurvedKnotSurface> transposed_;
    const CurvedKnotSurface* curved_ = nullptr;
    std::vector<std::size_t> intervals_;
};

}  // namespace batten::surfaces
