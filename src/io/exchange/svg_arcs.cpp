#include "batten/io/svg_arcs.hpp"

#include <cmath>

#include "batten/base/text.hpp"

namespace batten {

std::string svg_path(const ArcChain& chain) {
    const auto point = [](std::array<double, 2> p) {
        return ' ' + format_number(p[0]) + ' ' + format_number(p[1]);
    };
    std::string text = "M" + point(chain.arc(0).start);
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        const Arc arc = chain.arc(i);
        if (arc.is_line()) {
            text += " L" + point(arc.end);
            continue;
        }
        const std::string radius = format_number(*arc.radius());
        const bool is_major = std::fabs(arc.bulge) > 1;
        text += " A " + radius + ' ' + radius + " 0 " + (is_major ? '1' : '0') + ' ' +
                (arc.bulge > 0 ? '1' : '0') + point(arc.end);
    }
    return chain.is_closed() ? text + " Z" : text;
}

}  // namespace batten
