#include "shape/knots.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace batten::knots {

std::vector<double> list_of(const BSplineBasis& basis) {
    const std::span<const double> all = basis.knots();
    if (!basis.is_periodic()) return {all.begin(), all.end()};
    const std::size_t margin = static_cast<std::size_t>(basis.degree());
    const std::span<const double> period = all.subspan(margin, basis.size() + 1);
    const auto end = std::lower_bound(period.begin(), period.end(), period.back());
    std::vector<double> list(static_cast<std::size_t>(period.end() - end), period.front());
    list.insert(list.end(), period.begin() + 1, end + 1);
    return list;
}

BSplineBasis basis_over(std::vector<double> list, int degree, bool is_periodic) {
    if (is_periodic) return BSplineBasis::periodic(list, degree);
    return {std::move(list), degree};
}

std::size_t widest_span(const BSplineBasis& basis, std::size_t j) {
    const std::span<const double> knots = basis.knots();
    const std::size_t degree = static_cast<std::size_t>(basis.degree());
    const std::size_t first = std::max(j, degree);
    const std::size_t last = std::min(j + degree, knots.size() - 2 - degree);
    const auto off_middle = [&](std::size_t s) {
        return std::abs(2 * static_cast<long long>(s - j) - static_cast<long long>(degree));
    };
    std::size_t best = first;
    for (std::size_t s = first + 1; s <= last; ++s) {
        const double length = knots[s + 1] - knots[s], longest = knots[best + 1] - knots[best];
        if (length > longest || (length == longest && off_middle(s) < off_middle(best))) best = s;
    }
    return best;
}

}  // namespace batten::knots
