#include "make/fit_surface/finest_strips.hpp"

#include <algorithm>

#include "make/fit_surface/axis.hpp"

namespace batten::surface_fitting {

std::vector<double> halved(std::vector<double> breaks, int times) {
    for (int k = 0; k < times; ++k) {
        std::vector<double> finer{breaks.front()};
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            finer.push_back(Interval{breaks[i], breaks[i + 1]}.middle());
            finer.push_back(breaks[i + 1]);
        }
        breaks = std::move(finer);
    }
    return breaks;
}

std::vector<double> halved_where_determined(std::vector<double> breaks, int times, int degree,
                                            std::span<const double> used) {
    const auto is_good = [&](const std::vector<double>& finer) {
        return is_determined(BSplineBasis::over(finer, degree), used);
    };
    for (int k = 0; k < times; ++k) {
        std::vector<double> all = halved(breaks, 1);
        if (is_good(all)) {
            breaks = std::move(all);
            continue;
        }
        for (std::size_t i = 1; i + 1 < all.size(); i += 2) {
            std::vector<double> finer = breaks;
            const double middle = all[i];
            finer.insert(std::upper_bound(finer.begin(), finer.end(), middle), middle);
            if (all[i - 1] < middle && middle < all[i + 1] && is_good(finer)) {
                breaks = std::move(finer);
            }
        }
    }
    return breaks;
}

}  // namespace batten::surface_fitting
