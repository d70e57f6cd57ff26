#include "make/fair/alpha.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "make/fair/smooth.hpp"
#include "shape/log_aesthetic/profile.hpp"

namespace batten::fairing {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t unknowns = 6;  ///< x, y, direction, turn, ln(rho1 / rho0), alpha
using Vector = std::array<double, unknowns>;
using Row = std::array<double, unknowns + 1>;  ///< with the right-hand side

constexpr double cutoff = 60;       ///< points a wave, of the arc lengths
constexpr double prior = 1e-3;      ///< pull of alpha towards 0.5, over sigma
constexpr double most_alpha = 30;
constexpr int most_steps = 60;

/// Least squares by Householder reflections; the triangle is left in the first rows.
void triangulate(std::vector<Row>& rows) {
    for (std::size_t j = 0; j < unknowns; ++j) {
        double norm = 0;
        for (std::size_t i = j; i < rows.size(); ++i) norm += rows[i][j] * rows[i][j];
        norm = std::sqrt(norm);
        if (norm == 0) continue;
        const double pivot = rows[j][j] > 0 ? -norm : norm;
        const double head = rows[j][j] - pivot;
        for (std::size_t k = j + 1; k <= unknowns; ++k) {
            double dot = head * rows[j][k];
            for (std::size_t i = j + 1; i < rows.size(); ++i) dot += rows[i][j] * rows[i][k];
            const double scale = dot / (pivot * head);
            rows[j][k] += scale * head;
            for (std::size_t i = j + 1; i < rows.size(); ++i) rows[i][k] += scale * rows[i][j];
        }
        rows[j][j] = pivot;
        for (std::size_t i = j + 1; i < rows.size(); ++i) rows[i][j] = 0;
    }
}

Vector substituted(const std::vector<Row>& rows) {
    Vector x{};
    for (std::size_t j = unknowns; j-- > 0;) {
        double sum = rows[j][unknowns];
        for (std::size_t k = j + 1; k < unknowns; ++k) sum -= rows[j][k] * x[k];
        x[j] = rows[j][j] == 0 ? 0 : sum / rows[j][j];
    }
    return x;
}

class Likelihood {
public:
    explicit Likelihood(const Track& arc) {
        const std::size_t n = arc.size();
        for (std::size_t i = 0; i < n; ++i) data_.emplace_back(arc.x[i], arc.y[i]);
        const double mu = std::pow(std::fmin(cutoff, static_cast<double>(n)) /
                                       (2 * std::numbers::pi), 8);
        const Track smooth = smoothed(arc, mu, 0);
        share_.assign(n, 0);
        for (std::size_t i = 1; i < n; ++i) share_[i] = share_[i - 1] + smooth.edge(i - 1);
        length_ = share_.back();
        for (double& s : share_) s /= length_;
        start_from(smooth);
    }

    AlphaEstimate estimate();

private:
    void start_from(const Track& smooth);
    /// Positions and directions of the model at the data's arc lengths; false beyond its range.
    bool place(const Vector& p, std::vector<Complex>& at, std::vector<Complex>* along) const;
    double residuals(const Vector& p);
    std::vector<Row> jacobian(const Vector& p);

    std::vector<Complex> data_;
    std::vector<double> share_;
    double length_ = 0;
    Vector p_{};
    std::vector<Complex> at_, along_, moved_;
    std::vector<double> rest_;
};

/// Radii from a line through the smoothed curvatures, alpha in the middle of what is usual.
void Likelihood::start_from(const Track& smooth) {
    const std::vector<double> kappa = curvatures(smooth);
    double n = 0, s = 0, ss = 0, k = 0, sk = 0;
    for (std::size_t i = 2; i + 2 < kappa.size(); ++i) {
        n += 1, s += share_[i], ss += share_[i] * share_[i], k += kappa[i];
        sk += share_[i] * kappa[i];
    }
    const double sign = k < 0 ? -1 : 1;
    const double slope = sign * (n * sk - s * k) / (n * ss - s * s);
    const double mean = std::fabs(k) / n, middle = s / n;
    const double least = 0.05 * mean + 1e-6 / length_;
    const double k0 = std::fmax(mean - slope * middle, least);
    const double k1 = std::fmax(mean + slope * (1 - middle), least);
    const Complex first(smooth.x[1] - smooth.x[0], smooth.y[1] - smooth.y[0]);
    const double direction = std::arg(first) - 0.5 * sign * k0 * std::abs(first);
    const double turn = 0.5 * sign * (k0 + k1) * length_;
    p_ = {smooth.x[0], smooth.y[0], direction, turn, std::log(k0 / k1), 0.5};
}

bool Likelihood::place(const Vector& p, std::vector<Complex>& at,
                       std::vector<Complex>* along) const {
    if (!(std::fabs(p[4]) * (std::fabs(p[5]) + 1) < 300) || std::fabs(p[5]) > most_alpha ||
        !(std::fabs(p[3]) < 100)) {
        return false;
    }
    const auto profile = spiral::Profile::by_ratio(p[5], p[4], p[3]);
    const Complex start(p[0], p[1]), turn = std::polar(1.0, p[2]);
    at.resize(share_.size());
    if (along) along->resize(share_.size());
    Complex here = 0;
    double before = 0;
    for (std::size_t i = 0; i < share_.size(); ++i) {
        const double u = profile.u_of(share_[i]);
        if (i > 0) here += profile.rough_step({before, u});
        before = u;
        at[i] = start + length_ * (turn * here);
        if (along) (*along)[i] = turn * std::polar(1.0, profile.angle(u));
    }
    return true;
}

/// Fills rest_, at_ and along_; the sum of squares.
double Likelihood::residuals(const Vector& p) {
    if (!place(p, at_, &along_)) return std::numeric_limits<double>::infinity();
    const std::size_t n = data_.size();
    rest_.assign(n + 1, 0);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Complex d = (data_[i] - at_[i]) * std::conj(along_[i]);
        rest_[i] = d.imag();
        rest_[n] += d.real();
        sum += rest_[i] * rest_[i];
    }
    rest_[n] /= std::sqrt(static_cast<double>(n));
    return sum + rest_[n] * rest_[n];
}

/// Rows of the derivatives of what the model does across (and, in the last one, along) itself.
std::vector<Row> Likelihood::jacobian(const Vector& p) {
    const std::size_t n = data_.size();
    const double root = std::sqrt(static_cast<double>(n));
    std::vector<Row> rows(n + 1, Row{});
    const auto fill = [&](std::size_t column, std::size_t i, Complex moved) {
        const Complex d = moved * std::conj(along_[i]);
        rows[i][column] = d.imag();
        rows[n][column] += d.real() / root;
    };
    const Complex start(p[0], p[1]);
    for (std::size_t i = 0; i < n; ++i) {
        fill(0, i, 1.0);
        fill(1, i, Complex(0, 1));
        fill(2, i, Complex(0, 1) * (at_[i] - start));
        rows[i][unknowns] = rest_[i];
    }
    rows[n][unknowns] = rest_[n];
    constexpr double step = 1e-6;
    for (std::size_t column = 3; column < unknowns; ++column) {
        Vector q = p;
        q[column] += step;
        if (!place(q, moved_, nullptr)) continue;
        for (std::size_t i = 0; i < n; ++i) fill(column, i, (moved_[i] - at_[i]) / step);
    }
    return rows;
}

AlphaEstimate Likelihood::estimate() {
    AlphaEstimate result;
    result.error = std::numeric_limits<double>::infinity();
    double value = residuals(p_), damping = 1e-3;
    if (!std::isfinite(value)) return result;
    const double freedom = static_cast<double>(data_.size()) - 5;
    Vector p = p_;
    for (; result.steps < most_steps && !result.converged; ++result.steps) {
        const std::vector<Row> rows = jacobian(p);
        Vector size{};
        for (const Row& row : rows) {
            for (std::size_t j = 0; j < unknowns; ++j) size[j] += row[j] * row[j];
        }
        const double pull = prior * std::sqrt(value / freedom);
        bool better = false;
        while (!better && damping < 1e12) {
            std::vector<Row> damped = rows;
            for (std::size_t j = 0; j < unknowns; ++j) {
                damped.push_back(Row{});
                damped.back()[j] = std::sqrt(damping * size[j]);
            }
            damped.push_back({0, 0, 0, 0, 0, pull, pull * (0.5 - p[5])});
            triangulate(damped);
            const Vector change = substituted(damped);
            Vector trial = p;
            for (std::size_t j = 0; j < unknowns; ++j) trial[j] += change[j];
            const double fresh = residuals(trial);
            double most = 0;
            for (std::size_t j = 0; j < unknowns; ++j) {
                most = std::fmax(most, std::fabs(change[j]) * std::sqrt(size[j]));
            }
            // The model moves by less than a thousandth of the noise, or of rounding.
            const bool rests = most < 1e-3 * std::sqrt(fresh / freedom) + 1e-13 * length_;
            if (fresh < value || rests) {
                better = true;
                result.converged = rests && damping < 1;
                p = trial;
                value = fresh;
                damping = std::fmax(0.1 * damping, 1e-12);
            } else {
                damping *= 8;
            }
        }
        if (!better) break;
    }
    residuals(p);
    std::vector<Row> rows = jacobian(p);
    result.sigma = std::sqrt(value / freedom);
    result.alpha = p[5];
    triangulate(rows);
    // alpha is the last unknown: its variance is that of the triangle's last row alone.
    const double pivot = std::fabs(rows[unknowns - 1][unknowns - 1]);
    if (pivot > 0) result.error = result.sigma / std::sqrt(pivot * pivot + std::pow(prior * result.sigma, 2));
    return result;
}

}  // namespace

AlphaEstimate most_likely_alpha(const Track& arc) { return Likelihood(arc).estimate(); }

}  // namespace batten::fairing
