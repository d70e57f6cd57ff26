#include "make/fit/covariance.hpp"

#include <algorithm>
#include <cmath>

#include "num/cox_de_boor.hpp"
#include "num/gauss.hpp"

namespace batten::fitting {
namespace {

/// The inverse of R^T R inside the band of R, last row first.
/// Source: R Z = R^-T, whose upper part is known [HutchinsonDeHoog1985].
std::vector<double> inverse_band(const num::BandedQr& qr) {
    const int width = qr.shape().width, n = qr.shape().columns;
    std::vector<double> z(static_cast<std::size_t>(n * width), 0.0);
    const auto at = [&](int i, int j) -> double& {
        return z[static_cast<std::size_t>(std::min(i, j) * width + std::abs(i - j))];
    };
    for (int j = n; j-- > 0;) {
        const double* const r = qr.row(j);
        if (r[0] == 0) continue;
        const int last = std::min(n - 1, j + width - 1);
        for (int i = last; i >= j; --i) {
            double sum = i == j ? 1 / r[0] : 0;
            for (int l = j + 1; l <= last; ++l) sum -= r[l - j] * at(l, i);
            at(j, i) = sum / r[0];
        }
    }
    return z;
}

}  // namespace

CoefficientLaw::CoefficientLaw(SplineFunction spline, KnotSystem system, int functions,
                               const std::vector<std::vector<double>>& held)
    : spline_(std::move(spline)), system_(std::move(system)), functions_(functions) {
    for (const std::vector<double>& form : held) {
        // Twice is enough [GolubVanLoan2013, 5.2.8].
        std::vector<double> v = without_known(without_known(forward(form)));
        double sum = 0, before = 0;
        for (const double x : v) sum += x * x;
        for (const double x : forward(form)) before += x * x;
        if (!(sum > 1e-20 * before)) continue;
        for (double& x : v) x /= std::sqrt(sum);
        known_.push_back(std::move(v));
    }
    if (system_.ends() == Ends::open && known_.empty()) band_ = inverse_band(system_.qr());
}

std::vector<double> CoefficientLaw::without_known(std::vector<double> v) const {
    for (const std::vector<double>& q : known_) {
        double product = 0;
        for (std::size_t i = 0; i < v.size(); ++i) product += q[i] * v[i];
        for (std::size_t i = 0; i < v.size(); ++i) v[i] -= product * q[i];
    }
    return v;
}

std::size_t CoefficientLaw::unknown(int c) const {
    return static_cast<std::size_t>(system_.unknown(c % functions_));
}

CoefficientLaw::Functions CoefficientLaw::functions_at(double x, int derivative) const {
    const int degree = spline_.degree();
    const std::span<const double> knots = spline_.knots();
    const auto from = knots.begin() + degree + 1;
    const auto to = knots.begin() + static_cast<std::ptrdiff_t>(spline_.coefficients().size());
    const auto span = std::upper_bound(from, to, x) - knots.begin() - 1;
    Functions result{static_cast<int>(span) - degree,
                     std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.0)};
    num::basis_derivatives(knots, static_cast<std::size_t>(span), degree + 1, x, derivative,
                           result.values.data());
    return result;
}

std::vector<double> CoefficientLaw::spread(const Functions& f) const {
    std::vector<double> a(static_cast<std::size_t>(functions_), 0.0);
    for (std::size_t j = 0; j < f.values.size(); ++j) {
        const int coefficient = (f.first + static_cast<int>(j)) % functions_;
        a[unknown(coefficient)] += f.values[j];
    }
    return a;
}

std::vector<double> CoefficientLaw::forward(std::vector<double> a) const {
    const num::BandedQr& qr = system_.qr();
    const int width = qr.shape().width, columns = qr.shape().columns, border = qr.shape().border;
    for (int j = 0; j < columns; ++j) {
        const double* const r = qr.row(j);
        const double value = a[j] = r[0] == 0 ? 0 : a[j] / r[0];
        for (int l = 1; l < width && j + l < columns; ++l) a[j + l] -= r[l] * value;
        for (int b = 0; b < border; ++b) a[columns + b] -= r[width + b] * value;
    }
    for (int j = 0; j < border; ++j) {
        const double* const r = qr.border_row(j);
        const double value = a[columns + j] = r[j] == 0 ? 0 : a[columns + j] / r[j];
        for (int l = j + 1; l < border; ++l) a[columns + l] -= r[l] * value;
    }
    return known_.empty() ? a : without_known(std::move(a));
}

std::vector<double> CoefficientLaw::apply(std::vector<double> a) const {
    const std::vector<double> y = forward(std::move(a));
    const num::BandedQr& qr = system_.qr();
    std::vector<double> x(y.size());
    qr.solve_for(y, x);
    return x;
}

std::vector<double> CoefficientLaw::coefficients() const {
    const num::BandedQr& qr = system_.qr();
    std::vector<double> z(static_cast<std::size_t>(functions_));
    for (int j = 0; j < functions_; ++j) z[static_cast<std::size_t>(j)] = qr.row(j)[qr.shape().width];
    z = without_known(std::move(z));
    std::vector<double> c(z.size());
    qr.solve_for(z, c);
    return c;
}

double CoefficientLaw::variance(double x, int derivative) const {
    const Functions f = functions_at(x, derivative);
    double sum = 0;
    if (band_.empty()) {
        for (const double y : forward(spread(f))) sum += y * y;
        return sum;
    }
    const int order = spline_.degree() + 1;
    const int width = system_.qr().shape().width;
    for (int i = 0; i < order; ++i) {
        const double* const row = band_.data() + (f.first + i) * width;
        sum += f.values[i] * f.values[i] * row[0];
        for (int j = i + 1; j < order; ++j) sum += 2 * f.values[i] * f.values[j] * row[j - i];
    }
    return std::max(sum, 0.0);
}

double CoefficientLaw::integral_variance(Interval part) const {
    std::vector<double> a(static_cast<std::size_t>(functions_), 0.0);
    const num::GaussRule rule = num::gauss_legendre(spline_.degree() / 2 + 1);
    for (std::size_t i = 0; i < spline_.pieces(); ++i) {
        const Interval piece{std::max(part.lo, spline_.breaks()[i]),
                             std::min(part.hi, spline_.breaks()[i + 1])};
        if (!(piece.lo < piece.hi)) continue;
        const double half = 0.5 * piece.length();
        for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
            const Functions f = functions_at(piece.middle() + half * rule.nodes[q], 0);
            for (std::size_t j = 0; j < f.values.size(); ++j) {
                a[unknown(f.first + static_cast<int>(j))] += half * rule.weights[q] * f.values[j];
            }
        }
    }
    double sum = 0;
    for (const double y : forward(std::move(a))) sum += y * y;
    return sum;
}

}  // namespace batten::fitting
