#include <algorithm>
#include <array>
#include <cmath>

#include "batten/shape/curved_knot_surface.hpp"
#include "num/gauss.hpp"
#include "shape/surface/inside.hpp"

/// Sections and integrals of surfaces with curved knot lines.
namespace batten {

bool are_straight(std::span<const SplineFunction> lines) {
    return std::all_of(lines.begin(), lines.end(), [](const SplineFunction& line) {
        const std::span<const double> c = line.coefficients();
        return std::all_of(c.begin(), c.end(), [&](double x) { return x == c[0]; });
    });
}

namespace {

constexpr int along_nodes = 8;
constexpr int most_strip_halvings = 12;
constexpr double integral_accuracy = 1e-12;  // of the largest coefficient
constexpr double section_accuracy = 1e-9;    // the same
constexpr double followed_accuracy = 4 * section_accuracy;  // integrals of such sections
constexpr int most_cut_halvings = 12;

double largest_coefficient(const CurvedKnotSurface& surface) {
    double largest = 0;
    for (const double c : surface.coefficients()) largest = std::fmax(largest, std::fabs(c));
    return largest;
}

/// The spline over rising places, its ends among them, with a coefficient for each function that
/// they would have; functions without a support are left out.
SplineFunction spline_over(std::span<const double> places, std::span<const double> coefficients,
                           int degree) {
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    std::vector<double> all(order - 1, places.front());
    all.insert(all.end(), places.begin(), places.end());
    all.insert(all.end(), order - 1, places.back());
    std::vector<double> knots, c;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        if (all[i] == all[i + order]) continue;
        knots.push_back(all[i]);
        c.push_back(coefficients[i]);
    }
    knots.insert(knots.end(), order, places.back());
    return {std::move(knots), std::move(c), degree};
}

/// Sections of constant y of a surface whose y-lines are straight: exact.
class StraightSections {
public:
    explicit StraightSections(const CurvedKnotSurface& surface) : surface_(surface) {
        const std::vector<double> places = surface.y_knots(surface.domain().x.lo);
        const std::size_t order = static_cast<std::size_t>(surface.degree()) + 1;
        const std::size_t width = surface.y_lines().size() + order;
        for (std::size_t i = 0; i < surface.x_lines().size() + order; ++i) {
            rows_.push_back(spline_over(places, surface.coefficients().subspan(i * width, width),
                                        surface.degree()));
        }
    }
    SplineFunction at(double y) const {
        std::vector<double> c;
        for (const SplineFunction& row : rows_) c.push_back(row(y));
        return spline_over(surface_.x_knots(y), c, surface_.degree());
    }

private:
    const CurvedKnotSurface& surface_;
    std::vector<SplineFunction> rows_;
};

std::size_t interval_of(const std::vector<double>& places, double at) {
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, at);
    return static_cast<std::size_t>(above - places.begin()) - 1;
}

/// A section of constant y along curved lines: quintic pieces that follow it.
class FollowedSection {
public:
    FollowedSection(const CurvedKnotSurface& surface, double y)
        : surface_(surface), y_(y), allowed_(section_accuracy * largest_coefficient(surface)) {}

    SplineFunction made() {
        const std::vector<double> joints = joints_of_section();
        for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
            const double middle = Interval{joints[i], joints[i + 1]}.middle();
            cell_ = {interval_of(surface_.x_knots(y_), middle),
                     interval_of(surface_.y_knots(middle), y_)};
            add({joints[i], joints[i + 1]}, most_cut_halvings);
        }
        knots_.insert(knots_.end(), 6, joints.back());
        return {std::move(knots_), std::move(coefficients_), 5};
    }

private:
    /// Where the cut crosses a line, or a line has a knot.
    std::vector<double> joints_of_section() const {
        std::vector<double> joints = surface_.x_knots(y_);
        const Interval domain = surface_.domain().x;
        const auto add_inside = [&](std::span<const double> places) {
            for (const double x : places) {
                if (domain.lo < x && x < domain.hi) joints.push_back(x);
            }
        };
        for (const SplineFunction& line : surface_.y_lines()) {
            add_inside(line.breaks());
            add_inside(roots(line, y_));
        }
        std::sort(joints.begin(), joints.end());
        std::vector<double> apart{domain.lo};
        const double near = 1e-12 * domain.length();
        for (const double x : joints) {
            if (x - apart.back() > near && domain.hi - x > near) apart.push_back(x);
        }
        apart.push_back(domain.hi);
        return apart;
    }

    /// Bezier ordinates with the values and two derivatives at both ends.
    static std::array<double, 6> ordinates(const HeightJet& a, const HeightJet& b, double h) {
        return {a.value,
                a.value + h * a.x / 5,
                a.value + 2 * h * a.x / 5 + h * h * a.xx / 20,
                b.value - 2 * h * b.x / 5 + h * h * b.xx / 20,
                b.value - h * b.x / 5,
                b.value};
    }

    static double on_piece(std::array<double, 6> c, double u) {
        for (std::size_t level = 5; level > 0; --level) {
            for (std::size_t j = 0; j < level; ++j) c[j] = (1 - u) * c[j] + u * c[j + 1];
        }
        return c[0];
    }

    void add(Interval part, int halvings) {
        const std::array<double, 6> c = ordinates(surface_.jet_in(cell_, part.lo, y_),
                                                  surface_.jet_in(cell_, part.hi, y_),
                                                  part.length());
        double most = 0;
        for (const double u : {0.25, 0.5, 0.75}) {
            const double x = part.lo + u * part.length();
            most = std::fmax(most, std::fabs(on_piece(c, u) - surface_.value_in(cell_, x, y_)));
        }
        if (most > allowed_ && halvings > 0) {
            add({part.lo, part.middle()}, halvings - 1);
            add({part.middle(), part.hi}, halvings - 1);
            return;
        }
        // Where no jump is, the piece begins with the ordinate that ended the one before.
        const bool joins =
            !coefficients_.empty() && std::fabs(coefficients_.back() - c[0]) <= allowed_;
        knots_.insert(knots_.end(), joins ? 5 : 6, part.lo);
        coefficients_.insert(coefficients_.end(), c.begin() + (joins ? 1 : 0), c.end());
    }

    const CurvedKnotSurface& surface_;
    double y_, allowed_;
    KnotCell cell_;
    std::vector<double> knots_, coefficients_;
};

SplineFunction section(const CurvedKnotSurface& surface, double y) {
    if (are_straight(surface.y_lines())) return StraightSections(surface).at(y);
    return FollowedSection(surface, y).made();
}

/// Gauss rules over `part`, halved until two agree.
template <class F>
double by_halves(const F& f, Interval part, double whole, double allowed, int halvings) {
    const num::GaussRule rule = num::gauss_legendre(along_nodes);
    const Interval halves[] = {{part.lo, part.middle()}, {part.middle(), part.hi}};
    const double left = num::integrate(f, halves[0], rule);
    const double right = num::integrate(f, halves[1], rule);
    if (std::fabs(left + right - whole) <= allowed || halvings == 0) return left + right;
    return by_halves(f, halves[0], left, allowed / 2, halvings - 1) +
           by_halves(f, halves[1], right, allowed / 2, halvings - 1);
}

/// Where sections change their form: knots of the x-lines, straight y-lines.
std::vector<double> strips_of(const CurvedKnotSurface& surface, Interval part) {
    std::vector<double> places = surface.y_knots(surface.domain().x.lo);
    for (const SplineFunction& line : surface.x_lines()) {
        places.insert(places.end(), line.breaks().begin(), line.breaks().end());
    }
    std::vector<double> strips{part.lo};
    std::sort(places.begin(), places.end());
    for (const double y : places) {
        if (y > strips.back() && y < part.hi) strips.push_back(y);
    }
    strips.push_back(part.hi);
    return strips;
}

template <class Section>
double integral_of(const CurvedKnotSurface& surface, const Rectangle& part, double accuracy,
                   Section section_of) {
    const auto across = [&](double y) { return integral(section_of(y), part.x); };
    const double allowed = accuracy * largest_coefficient(surface) * part.x.length();
    const std::vector<double> strips = strips_of(surface, part.y);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < strips.size(); ++k) {
        const Interval strip{strips[k], strips[k + 1]};
        const double whole = num::integrate(across, strip, num::gauss_legendre(along_nodes));
        sum += by_halves(across, strip, whole, allowed * strip.length(), most_strip_halvings);
    }
    return sum;
}

}  // namespace

double integral(const CurvedKnotSurface& surface, const Rectangle& part) {
    surfaces::require_inside(surface.domain().x, part.x, "x");
    surfaces::require_inside(surface.domain().y, part.y, "y");
    if (!(part.x.lo < part.x.hi) || !(part.y.lo < part.y.hi)) return 0;
    if (are_straight(surface.y_lines())) {
        const StraightSections sections(surface);
        return integral_of(surface, part, integral_accuracy,
                           [&](double y) { return sections.at(y); });
    }
    if (are_straight(surface.x_lines())) {
        return integral(surface.transposed(), {part.y, part.x});
    }
    return integral_of(surface, part, followed_accuracy,
                       [&](double y) { return FollowedSection(surface, y).made(); });
}

double integral(const CurvedKnotSurface& surface) { return integral(surface, surface.domain()); }

SplineFunction section_at_y(const CurvedKnotSurface& surface, double y) {
    surfaces::require_inside(surface.domain().y, {y, y}, "y");
    return section(surface, y);
}

SplineFunction section_at_x(const CurvedKnotSurface& surface, double x) {
    surfaces::require_inside(surface.domain().x, {x, x}, "x");
    return section(surface.transposed(), x);
}

}  // namespace batten
