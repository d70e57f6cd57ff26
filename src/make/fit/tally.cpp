#include "make/fit/tally.hpp"

#include <algorithm>

#include "make/fit/spline_residuals.hpp"
#include "num/lanes.hpp"

namespace batten::fitting {
namespace {

using num::LaneMask;
using num::Lanes;
using num::lanes;

constexpr std::size_t chunk = 512;
/// So few samples are looked at again where one of them lies beyond 3 sigma.
constexpr std::size_t short_run = 64;

/// Sums of one pass.
struct Sums {
    Lanes delta2 = {};
    Lanes largest = {};
    LaneMask within[3] = {};
    LaneMask beyond[psi_count] = {};  ///< |e| > i sigma, i > 3
    LaneMask positive = {}, sign_changes = {};
};

/// Residuals and their errors: `sigma` one a residual, or null and all are `common`.
struct Residuals {
    const double* e;  ///< filled up to whole lanes by 0; e[-1] is the residual before
    const double* sigma;
    double common;
};

template <bool HasSigma>
BATTEN_INLINE void sigma_at(const Residuals& r, std::size_t i, Lanes& out) {
    if (HasSigma) num::load(r.sigma + i, out);
    else out = Lanes{} + r.common;
}

BATTEN_INLINE void size_of(const Lanes& e, Lanes& out) { out = e < 0 ? -e : e; }

template <bool HasSigma>
BATTEN_INLINE void add_run(const Residuals& r, std::size_t first, std::size_t last, Sums& s) {
    const double weight = 1 / r.common;
    for (std::size_t i = first; i < last; i += lanes) {
        Lanes e, before, sigma, size;
        num::load(r.e + i, e);
        num::load(r.e + i - 1, before);
        sigma_at<HasSigma>(r, i, sigma);
        size_of(e, size);
        const Lanes q = HasSigma ? e / sigma : e * weight;
        s.delta2 += q * q;
        s.largest = size > s.largest ? size : s.largest;
        for (int w = 0; w < 3; ++w) s.within[w] -= size <= (w + 1.0) * sigma;
        const LaneMask is_positive = e >= 0, was_positive = before >= 0;
        s.positive -= is_positive;
        s.sign_changes -= is_positive ^ was_positive;
    }
}

template <bool HasSigma>
BATTEN_INLINE void add_run_beyond(const Residuals& r, std::size_t first, std::size_t last, Sums& s) {
    for (std::size_t i = first; i < last; i += lanes) {
        Lanes e, sigma, size;
        num::load(r.e + i, e);
        sigma_at<HasSigma>(r, i, sigma);
        size_of(e, size);
        for (int w = 3; w < psi_count; ++w) s.beyond[w] -= size > (w + 1.0) * sigma;
    }
}

template <bool HasSigma>
BATTEN_INLINE void add_runs(const Residuals& r, std::size_t count, Sums& sums) {
    Sums s = sums;
    for (std::size_t first = 0; first < count; first += short_run) {
        const std::size_t last = std::min(first + short_run, count);
        const long long before = num::sum_of(s.within[2]);
        add_run<HasSigma>(r, first, last, s);
        const long long within = num::sum_of(s.within[2]) - before;
        if (within == static_cast<long long>(last - first)) continue;
        add_run_beyond<HasSigma>(r, first, last, s);
    }
    sums = s;
}

BATTEN_CLONES void add_residuals(const Residuals& r, std::size_t count, Sums& sums) {
    if (r.sigma) add_runs<true>(r, count, sums);
    else add_runs<false>(r, count, sums);
}

/// Room for a chunk of residuals, the one before it, and zeros that fill up whole lanes.
class Chunk {
public:
    double* residuals() { return memory_ + lanes; }

private:
    alignas(64) double memory_[lanes + chunk] = {};
};

class Pass {
public:
    /// Residuals of samples first ... in rising order.
    void add(const Samples& samples, std::size_t first, Chunk& memory, std::size_t count) {
        double* const e = memory.residuals();
        const std::size_t whole = (count + lanes - 1) / lanes * lanes;
        std::fill(e + count, e + whole, 0.0);
        e[-1] = count_ == 0 ? e[0] : last_;
        last_ = e[count - 1];
        double filled[chunk];
        Residuals r{e, nullptr, samples.common_sigma};
        if (!samples.sigma.empty()) {
            r.sigma = samples.sigma.data() + first;
            if (whole > count) {
                std::copy_n(r.sigma, count, filled);
                std::fill(filled + count, filled + whole, 1.0);
                r.sigma = filled;
            }
        }
        add_residuals(r, whole, sums_);
        padded_ += whole - count;
        // The zeros count as positive.
        if (whole > count && last_ < 0) ++false_changes_;
        count_ += count;
    }

    ResidualTally result() const {
        ResidualTally t;
        const double n = static_cast<double>(count_);
        const auto counted = [&](const LaneMask& mask) {
            return static_cast<std::size_t>(num::sum_of(mask));
        };
        t.delta2 = num::sum_of(sums_.delta2);
        t.max_residual = num::largest_of(sums_.largest);
        for (std::size_t w = 0; w < psi_count; ++w) {
            const std::size_t within = w < 3 ? counted(sums_.within[w]) - padded_
                                             : count_ - counted(sums_.beyond[w]);
            t.psi[w] = static_cast<double>(within) / n;
        }
        t.positive = counted(sums_.positive) - padded_;
        t.runs = counted(sums_.sign_changes) - false_changes_ + 1;
        return t;
    }

private:
    Sums sums_;
    std::size_t count_ = 0, padded_ = 0, false_changes_ = 0;
    double last_ = 0;
};

}  // namespace

ResidualTally tally(const Samples& samples, std::span<const double> residuals) {
    Pass pass;
    Chunk memory;
    double* const e = memory.residuals();
    for (std::size_t first = 0; first < residuals.size(); first += chunk) {
        const std::size_t count = std::min(chunk, residuals.size() - first);
        std::copy_n(residuals.data() + first, count, e);
        pass.add(samples, first, memory, count);
    }
    return pass.result();
}

ResidualTally tally(const Samples& samples, const SplineFunction& spline, int side) {
    Pass pass;
    Chunk memory;
    SplineResiduals residuals(samples, spline, side);
    double* const e = memory.residuals();
    for (std::size_t first = 0; first < samples.size(); first += chunk) {
        const std::size_t count = std::min(chunk, samples.size() - first);
        residuals.next(count, e);
        pass.add(samples, first, memory, count);
    }
    return pass.result();
}

}  // namespace batten::fitting
