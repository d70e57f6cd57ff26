#include "batten/make/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten {

Motion::Motion(const Curve& curve, MotionLaw law, double duration)
    : curve_(curve), map_(curve), law_(std::move(law)), duration_(duration) {
    if (!(duration > 0) || !std::isfinite(duration)) {
        throw Error("option.range", "duration", format_number(duration),
                    "must be more than 0 and finite");
    }
}

double Motion::arc_length(double time) const {
    return map_.length() * law_.at(time / duration_).share;
}

double Motion::speed(double time) const {
    if (time < 0 || time > duration_) return 0;
    return map_.length() * law_.at(time / duration_).speed / duration_;
}

double Motion::parameter(double time) const { return map_.t_of(arc_length(time)); }

std::vector<double> Motion::position(double time) const { return curve_(parameter(time)); }

std::vector<double> Motion::velocity(double time) const {
    std::vector<double> result = unit_tangent(curve_, parameter(time));
    const double along = speed(time);
    for (double& x : result) x *= along;
    return result;
}

std::vector<double> unit_tangent(const Curve& curve, double t) {
    constexpr int most = 4;
    constexpr double at_rest = 0x1p-40;
    const std::size_t piece = curve.piece_of(t);
    const bool at_end = t >= curve.domain().hi;
    const double h = curve.piece(piece).length();
    const Jet jet = curve.jet_on(piece, t, most);
    // The derivatives as displacements over the piece; the first that is none is the direction.
    double largest = 0, scale = 1;
    std::vector<std::vector<double>> moves;
    std::vector<double> sizes;
    for (int k = 1; k <= most; ++k) {
        scale *= h / k;
        std::vector<double> move;
        double size = 0;
        for (const double x : jet[k]) {
            move.push_back(x * scale);
            size = std::hypot(size, move.back());
        }
        // Just before the end the k-th derivative moves by (-1)^(k - 1) of itself.
        if (at_end && k % 2 == 0) {
            for (double& x : move) x = -x;
        }
        moves.push_back(std::move(move));
        sizes.push_back(size);
        largest = std::fmax(largest, size);
    }
    for (std::size_t k = 0; k < moves.size(); ++k) {
        if (sizes[k] == 0 || sizes[k] <= at_rest * largest) continue;
        for (double& x : moves[k]) x /= sizes[k];
        return moves[k];
    }
    return std::vector<double>(static_cast<std::size_t>(curve.dim()));
}

}  // namespace batten
