#include "make/fit/tally.hpp"

#include <algorithm>

#include "make/fit/lanes.hpp"

namespace batten::fitting {
namespace {

constexpr std::size_t chunk = 512;

/// Sums of one pass; the last psi are counted only where residuals are that large.
struct Sums {
    Lanes delta2 = {};
    Lanes largest = {};
    LaneMask within[3] = {};
    LaneMask beyond[psi_count] = {};  ///< |e| > i sigma, i > 3
    std::size_t sign_changes = 0, positive = 0;
    bool was_positive = false, any = false;
};

/// `e`, `sigma` filled up to whole lanes with e = 0, sigma = 1.
BATTEN_CLONES void add_lanes(const double* e, const double* sigma, std::size_t count, Sums& sums) {
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes r, s;
        load(e + i, r);
        load(sigma + i, s);
        const Lanes size = r < 0 ? -r : r;
        const Lanes q = r / s;
        sums.delta2 += q * q;
        sums.largest = size > sums.largest ? size : sums.largest;
        for (int w = 0; w < 3; ++w) sums.within[w] -= size <= (w + 1.0) * s;
    }
}

BATTEN_CLONES void add_beyond(const double* e, const double* sigma, std::size_t count,
                              LaneMask* beyond) {
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes r, s;
        load(e + i, r);
        load(sigma + i, s);
        const Lanes size = r < 0 ? -r : r;
        for (int w = 3; w < psi_count; ++w) beyond[w] -= size > (w + 1.0) * s;
    }
}

BATTEN_CLONES std::size_t count_positive(const double* e, std::size_t count) {
    std::size_t positive = 0;
    for (std::size_t i = 0; i < count; ++i) positive += e[i] >= 0;
    return positive;
}

BATTEN_CLONES std::size_t count_changes(const double* e, std::size_t count) {
    std::size_t changes = 0;
    for (std::size_t i = 1; i < count; ++i) changes += (e[i] >= 0) != (e[i - 1] >= 0);
    return changes;
}

class Pass {
public:
    /// Residuals of samples first ... in rising order; `e` has room for whole lanes.
    void add(const Samples& samples, std::size_t first, double* e, std::size_t count) {
        double filled[chunk];
        const double* sigma = filled;
        const std::size_t whole = (count + lanes - 1) / lanes * lanes;
        std::fill(e + count, e + whole, 0.0);
        if (samples.sigma.empty()) {
            std::fill(filled, filled + whole, samples.common_sigma);
        } else if (whole == count) {
            sigma = samples.sigma.data() + first;
        } else {
            std::copy_n(samples.sigma.data() + first, count, filled);
            std::fill(filled + count, filled + whole, 1.0);
        }
        const long long before = sum_of(sums_.within[2]);
        add_lanes(e, sigma, whole, sums_);
        if (sum_of(sums_.within[2]) - before < static_cast<long long>(whole)) {
            add_beyond(e, sigma, whole, sums_.beyond);
        }
        padded_ += whole - count;
        sums_.positive += count_positive(e, count);
        sums_.sign_changes += count_changes(e, count);
        if (sums_.any) sums_.sign_changes += (e[0] >= 0) != sums_.was_positive;
        sums_.any = true;
        sums_.was_positive = e[count - 1] >= 0;
        count_ += count;
    }

    ResidualTally result() const {
        ResidualTally t;
        const double n = static_cast<double>(count_);
        t.delta2 = sum_of(sums_.delta2);
        t.max_residual = largest_of(sums_.largest);
        for (std::size_t w = 0; w < psi_count; ++w) {
            const double within =
                w < 3 ? static_cast<double>(sum_of(sums_.within[w]) -
                                            static_cast<long long>(padded_))
                      : n - static_cast<double>(sum_of(sums_.beyond[w]));
            t.psi[w] = within / n;
        }
        t.positive = sums_.positive;
        t.runs = sums_.sign_changes + 1;
        return t;
    }

private:
    Sums sums_;
    std::size_t count_ = 0, padded_ = 0;
};

}  // namespace

ResidualTally tally(const Samples& samples, std::span<const double> residuals) {
    Pass pass;
    double e[chunk];
    for (std::size_t first = 0; first < residuals.size(); first += chunk) {
        const std::size_t count = std::min(chunk, residuals.size() - first);
        std::copy_n(residuals.data() + first, count, e);
        pass.add(samples, first, e, count);
    }
    return pass.result();
}

ResidualTally tally(const Samples& samples, const SplineFunction& spline, int side) {
    Pass pass;
    double e[chunk];
    for (std::size_t first = 0; first < samples.size(); first += chunk) {
        const std::size_t count = std::min(chunk, samples.size() - first);
        spline.evaluate(samples.x.subspan(first, count), 0, {e, count});
        const double* const y = samples.sides[static_cast<std::size_t>(side)].data() + first;
        for (std::size_t i = 0; i < count; ++i) e[i] = y[i] - e[i];
        pass.add(samples, first, e, count);
    }
    return pass.result();
}

}  // namespace batten::fitting
