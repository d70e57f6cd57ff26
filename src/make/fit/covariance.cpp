#include "make/fit/covariance.hpp"

#include <algorithm>
#include <cmath>

#include "num/cox_de_boor.hpp"
#include "num/gauss.hpp"

namespace batten::fitting {
CoefficientLaw::CoefficientLaw(SplineFunction spline, const KnotSystem& system,
                               const std::vector<std::vector<double>>& held)
    : spline_(std::move(spline)), qr_(system.qr()) {
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
    find_band();
}

CoefficientLaw::CoefficientLaw(SplineFunction spline, num::BandedQr qr,
                               std::vector<std::vector<double>> known)
    : spline_(std::move(spline)), qr_(std::move(qr)), known_(std::move(known)) {
    find_band();
}

void CoefficientLaw::find_band() {
    if (!spline_.is_closed() && known_.empty()) band_ = qr_.inverse_band(qr_.shape().width);
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
    const num::BandShape& band = qr_.shape();
    const int j = c % functions();
    return static_cast<std::size_t>(j < band.border ? band.columns + j : j - band.border);
}

int CoefficientLaw::functions_at(double x, int derivative, double* values) const {
    const int degree = spline_.degree();
    const std::span<const double> knots = spline_.knots();
    const auto from = knots.begin() + degree + 1;
    const auto to = knots.begin() + static_cast<std::ptrdiff_t>(spline_.coefficients().size());
    const auto span = std::upper_bound(from, to, x) - knots.begin() - 1;
    num::basis_derivatives(knots, static_cast<std::size_t>(span), degree + 1, x, derivative,
                           values);
    return static_cast<int>(span) - degree;
}

CoefficientLaw::Functions CoefficientLaw::functions_at(double x, int derivative) const {
    Functions result{0, std::vector<double>(static_cast<std::size_t>(spline_.degree()) + 1)};
    result.first = functions_at(x, derivative, result.values.data());
    return result;
}

std::vector<double> CoefficientLaw::spread(const Functions& f) const {
    std::vector<double> a(static_cast<std::size_t>(functions()), 0.0);
    for (std::size_t j = 0; j < f.values.size(); ++j) {
        const int coefficient = (f.first + static_cast<int>(j)) % functions();
        a[unknown(coefficient)] += f.values[j];
    }
    return a;
}

std::vector<double> CoefficientLaw::forward(std::vector<double> a) const {
    qr_.solve_transposed(a);
    return known_.empty() ? a : without_known(std::move(a));
}

std::vector<double> CoefficientLaw::apply(std::vector<double> a) const {
    const std::vector<double> y = forward(std::move(a));
    std::vector<double> x(y.size());
    qr_.solve_for(y, x);
    return x;
}

std::vector<double> CoefficientLaw::coefficients() const {
    std::vector<double> z(static_cast<std::size_t>(functions()));
    for (int j = 0; j < functions(); ++j) {
        z[static_cast<std::size_t>(j)] = qr_.row(j)[qr_.shape().width];
    }
    z = without_known(std::move(z));
    std::vector<double> c(z.size());
    qr_.solve_for(z, c);
    return c;
}

double CoefficientLaw::variance(double x, int derivative) const {
    double sum = 0;
    if (band_.empty()) {
        for (const double y : forward(spread(functions_at(x, derivative)))) sum += y * y;
        return sum;
    }
    double values[num::most_order];
    const int first = functions_at(x, derivative, values);
    const int order = spline_.degree() + 1;
    const int width = qr_.shape().width;
    for (int i = 0; i < order; ++i) {
        const double* const row = band_.data() + (first + i) * width;
        sum += values[i] * values[i] * row[0];
        for (int j = i + 1; j < order; ++j) sum += 2 * values[i] * values[j] * row[j - i];
    }
    return std::max(sum, 0.0);
}

double CoefficientLaw::integral_variance(Interval part) const {
    std::vector<double> a(static_cast<std::size_t>(functions()), 0.0);
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
