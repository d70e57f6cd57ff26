#pragma once

#include <array>
#include <cstddef>

#include "batten/make/pseudo_segment.hpp"

/// The paper's own tables [InoueShibata, 4.1]: least segments at every 10 degrees, told apart by
/// the type of their ends, with bilinear interpolation between nodes of one type.
class PaperTable {
public:
    PaperTable();

    struct Segment {
        double r0 = 1, r1 = 1;
        double length = 1;         // L
        double area = 0;           // S, left of the chord
        double pseudo_energy = 0;  // J
    };

    /// Bilinear in the cell around the angles, from its nodes of the same type as the nearest one;
    /// the weights of the others are shared out among them.
    Segment segment(double theta0, double theta1) const;

    /// J(theta) and theta1(theta): from the least node of each row, linear between rows.
    struct End {
        double theta1 = 0, pseudo_energy = 0;
    };
    End end(double theta) const;

    /// The tangent at the middle of three points, from the first chord: the vertex of the parabola
    /// through w at 1/4, 1/2 and 3/4 of the turn.
    double tangent(double turn, double length0, double length1) const;

private:
    static constexpr int nodes = 36;
    enum class Type { c, s, x };
    struct Node {
        Segment segment;
        Type type = Type::x;
    };
    /// Node i is at (i - 17) x 10 degrees, modulo 36.
    const Node& node(int i, int j) const;

    std::array<std::array<Node, nodes>, nodes> grid_;
    std::array<End, nodes> ends_;
};
