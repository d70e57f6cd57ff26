#pragma once

#include <cmath>

#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "promises.hpp"

namespace batten::fuzz {

/// The curve has increasing breaks, finite points at them, and reads back from its own file.
inline void check_curve(const Curve& curve) {
    require(curve.dim() >= 1 && curve.pieces() >= 1);
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        require(curve.piece(i).lo < curve.piece(i).hi);
        for (const double t : {curve.piece(i).lo, curve.piece(i).hi}) {
            const Jet point = curve.jet_on(i, t, 0);
            for (const double x : point[0]) require(std::isfinite(x));
        }
    }
    const std::string text = dump_json(curve_value(curve));
    require(dump_json(curve_value(parse_curve({"copy.json", text}))) == text);
    try {
        svg_path(curve);
        svg_picture(curve);
    } catch (const Error& error) {
        require(error.code() == "curve.dimension" || error.code() == "curve.not-exact" ||
                error.code() == "number.overflow");
    }
}

}  // namespace batten::fuzz
