#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

/// What all benchmarks work on: scipy_peers.py makes the same points, and random parameters of its
/// own from the same range.
namespace batten::bench {

/// A wave with n points, no two of its chords alike.
Points wave(std::size_t n);

/// A way with turns of up to 100 degrees to either side and steps of 0.5 to 1.5.
Points sharp_way(std::size_t n);

/// The wave's parameters, from 0 by the chords, into `t`, one for each point.
void fill_chord_parameters(const Points& points, std::span<double> t);

/// n heights over 0, 1, 2, ….
std::vector<double> heights(std::size_t n);

/// The natural cubic spline through them, as a curve of one coordinate.
Curve height_curve(std::size_t knots);

/// `count` numbers in [0, top], sorted, or in no order.
std::vector<double> sorted_parameters(std::size_t count, double top);
std::vector<double> random_parameters(std::size_t count, double top);

/// `operation/peer/size`: the name that run.py takes apart.
std::string name_of(const std::string& operation, const std::string& peer, std::size_t size);

}  // namespace batten::bench
