#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/arc_chain.hpp"

namespace batten {
namespace {

void require_part(const Interval& domain, const Interval& part) {
    for (const double t : {part.lo, part.hi}) {
        if (domain.contains(t)) continue;
        throw Error("curve.outside", "part", format_number(t),
                    "must lie in the curve's domain [" + format_number(domain.lo) + ", " +
                        format_number(domain.hi) + "]");
    }
    if (part.lo < part.hi) return;
    throw Error("curve.part-empty", "part",
                format_number(part.lo) + "," + format_number(part.hi),
                "the second parameter must be larger than the first");
}

}  // namespace

ArcChain trimmed(const ArcChain& chain, Interval part) {
    const std::span<const double> breaks = chain.breaks();
    require_part({breaks.front(), breaks.back()}, part);
    Points joints(0, 2);
    std::vector<double> bulges;
    const auto add_joint = [&](std::size_t arc, double t) {
        std::array<double, 2> p{};
        chain.jets_on(arc, {&t, 1}, 0, p);
        joints.push_back(p);
    };
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        const double lo = std::max(part.lo, breaks[i]), hi = std::min(part.hi, breaks[i + 1]);
        if (!(lo < hi)) continue;
        if (joints.empty()) add_joint(i, lo);
        add_joint(i, hi);
        const bool is_whole = lo == breaks[i] && hi == breaks[i + 1];
        const double share = (hi - lo) / (breaks[i + 1] - breaks[i]);
        bulges.push_back(is_whole ? chain.bulges()[i]
                                  : std::tan(share * std::atan(chain.bulges()[i])));
    }
    return {std::move(joints), std::move(bulges), false};
}

ArcChain reversed(const ArcChain& chain) {
    Points joints(0, 2);
    for (std::size_t i = chain.joints().size(); i-- > 0;) joints.push_back(chain.joints()[i]);
    std::vector<double> bulges(chain.bulges().rbegin(), chain.bulges().rend());
    for (double& bulge : bulges) bulge = bulge == 0 ? 0 : -bulge;
    return {std::move(joints), std::move(bulges), chain.is_closed()};
}

ArcChain scaled(const ArcChain& chain, double factor) {
    if (!std::isfinite(factor) || factor == 0) {
        throw Error("curve.scale", "scale", format_number(factor), "must be finite and not 0");
    }
    Points joints = chain.joints();
    for (double& x : joints.coordinates()) x *= factor;
    return {std::move(joints), {chain.bulges().begin(), chain.bulges().end()}, chain.is_closed()};
}

}  // namespace batten
