#include "api/picture_text.hpp"

#include "batten/base/text.hpp"

namespace batten::api {

std::string probability_text(double p) {
    constexpr double nearly = 0.0005;
    if (p > 1 - nearly && p < 1) return "> 0.999";
    if (p < nearly) return "< 0.001";
    return "= " + format_fixed(p, 3);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace batten::api
