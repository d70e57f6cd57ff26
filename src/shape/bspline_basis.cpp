#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/basis.hpp"

namespace batten {
namespace {

void require_degree(int degree, int least) {
    if (degree < least || degree > BSplineBasis::most_degree) {
        throw Error("bspline.degree", "degree", std::to_string(degree),
                    "must be " + std::to_string(least) + " to " +
                        std::to_string(BSplineBasis::most_degree));
    }
}

[[noreturn]] void refuse_knot(std::span<const double> knots, std::size_t i,
                              const std::string& rule) {
    throw Error("bspline.knots", "knot " + std::to_string(i), format_number(knots[i]), rule);
}

/// What holds for every list of knots: finite, rising, inner ones not too often.
void require_knots(std::span<const double> knots, int degree) {
    if (knots.size() < 2) {
        throw Error("bspline.knots", "knots", std::to_string(knots.size()),
                    "at least two are needed");
    }
    const std::size_t most = static_cast<std::size_t>(std::max(degree, 1));
    std::size_t times = 0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (!std::isfinite(knots[i])) refuse_knot(knots, i, "knots must be finite");
        if (i > 0 && knots[i] < knots[i - 1]) refuse_knot(knots, i, "knots must not decrease");
        times = i > 0 && knots[i] == knots[i - 1] ? times + 1 : 1;
        const bool is_inner = knots[i] != knots.front() && knots[i] != knots.back();
        if (is_inner && times > most) {
            refuse_knot(knots, i,
                        "an inner knot may stand at most " + std::to_string(most) +
                            (most == 1 ? " time" : " times"));
        }
    }
    if (!(knots.front() < knots.back()) || !std::isfinite(knots.back() - knots.front())) {
        refuse_knot(knots, 0, "first and last must differ, by a double");
    }
}

std::size_t times_first(std::span<const double> knots) {
    return static_cast<std::size_t>(
        std::find_if(knots.begin(), knots.end(), [&](double x) { return x != knots.front(); }) -
        knots.begin());
}

std::size_t times_last(std::span<const double> knots) {
    return static_cast<std::size_t>(
        std::find_if(knots.rbegin(), knots.rend(), [&](double x) { return x != knots.back(); }) -
        knots.rbegin());
}

std::vector<double> with_repeated_ends(std::vector<double> knots, int degree) {
    require_degree(degree, 0);
    require_knots(knots, degree);
    const std::size_t times = static_cast<std::size_t>(degree) + 1;
    for (const std::size_t found : {times_first(knots), times_last(knots)}) {
        if (found == times) continue;
        throw Error("bspline.knots", "ends", std::to_string(found) + " times",
                    "first and last must stand " + std::to_string(times) + " times");
    }
    return knots;
}

/// `count` + 1 + 2 degree knots: the period's, from the last one of its start on, and `degree`
/// more at both ends.
std::vector<double> continued(std::span<const double> period, int degree) {
    const long long count = static_cast<long long>(period.size()) - 1;
    const long long start = static_cast<long long>(times_first(period)) - 1;
    std::vector<double> knots;
    for (long long i = start - degree; i <= start + count + degree; ++i) {
        const long long turn = i >= 0 ? i / count : -((count - 1 - i) / count);
        const double knot = period[static_cast<std::size_t>(i - turn * count)];
        knots.push_back(knot == period.front() && turn == 1
                            ? period.back()
                            : knot + static_cast<double>(turn) * (period.back() - period.front()));
    }
    return knots;
}

}  // namespace

BSplineBasis::BSplineBasis(std::vector<double> knots, int degree, bool is_periodic_basis)
    : knots_(std::move(knots)), degree_(degree), periodic_(is_periodic_basis) {
    const std::size_t margin = static_cast<std::size_t>(degree);
    for (std::size_t i = margin; i + 1 + margin < knots_.size(); ++i) {
        if (knots_[i] == knots_[i + 1]) continue;
        breaks_.push_back(knots_[i]);
        spans_.push_back(i);
    }
    breaks_.push_back(knots_[knots_.size() - 1 - margin]);
}

BSplineBasis::BSplineBasis(std::vector<double> knots, int degree)
    : BSplineBasis(with_repeated_ends(std::move(knots), degree), degree, false) {}

BSplineBasis BSplineBasis::over(std::span<const double> breaks, int degree) {
    require_degree(degree, 0);
    require_knots(breaks, 1);
    std::vector<double> knots(static_cast<std::size_t>(degree), breaks.front());
    knots.insert(knots.end(), breaks.begin(), breaks.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree), breaks.back());
    return {std::move(knots), degree};
}

BSplineBasis BSplineBasis::periodic(std::span<const double> knots, int degree) {
    require_degree(degree, 1);
    require_knots(knots, degree);
    if (times_last(knots) != 1 || times_first(knots) > static_cast<std::size_t>(degree)) {
        refuse_knot(knots, knots.size() - 1,
                    "the end of a period stands once, its start at most degree times");
    }
    return {continued(knots, degree), degree, true};
}

std::size_t BSplineBasis::size() const {
    const std::size_t margin = static_cast<std::size_t>(degree_);
    return knots_.size() - 1 - (periodic_ ? 2 : 1) * margin;
}

std::size_t BSplineBasis::span_of(double t) const {
    const auto inner = std::span(breaks_).subspan(1, spans_.size() - 1);
    return spans_[static_cast<std::size_t>(std::upper_bound(inner.begin(), inner.end(), t) -
                                           inner.begin())];
}

std::size_t BSplineBasis::control(std::size_t span, int function) const {
    const std::size_t j = span - static_cast<std::size_t>(degree_ - function);
    return periodic_ ? j % size() : j;
}

void BSplineBasis::nonzero_on(std::size_t span, double t, int order, std::span<double> out) const {
    const double* const u = knots_.data() + span;
    for (int k = 0; k <= order; ++k) {
        double* const row = out.data() + k * (degree_ + 1);
        std::fill(row, row + degree_ + 1, 0.0);
        if (k > degree_) continue;
        row[0] = 1;
        for (int q = 1; q <= degree_ - k; ++q) {  // degree q - 1 becomes q
            double carried = 0;
            for (int j = 0; j < q; ++j) {
                const double left = t - u[1 + j - q], right = u[1 + j] - t;
                const double width = u[1 + j] - u[1 + j - q];
                const double value = row[j];
                row[j] = carried + value * (right / width);
                carried = value * (left / width);
            }
            row[q] = carried;
        }
        for (int q = degree_ - k + 1; q <= degree_; ++q) {  // and its derivative taken
            double carried = 0;
            for (int j = 0; j < q; ++j) {
                const double share = q * (row[j] / (u[1 + j] - u[1 + j - q]));
                row[j] = carried - share;
                carried = share;
            }
            row[q] = carried;
        }
    }
}

std::vector<double> BSplineBasis::greville() const {
    std::vector<double> result(size());
    for (std::size_t j = 0; j < result.size(); ++j) {
        if (degree_ == 0) {
            result[j] = Interval{knots_[j], knots_[j + 1]}.middle();
            continue;
        }
        double sum = 0;
        for (int i = 1; i <= degree_; ++i) sum += knots_[j + static_cast<std::size_t>(i)];
        result[j] = sum / degree_;
        if (periodic_ && result[j] < domain().lo) result[j] += domain().length();
        result[j] = domain().clamp(result[j]);
    }
    return result;
}

}  // namespace batten
