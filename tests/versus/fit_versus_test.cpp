#include "fit_samples.hpp"

/// Against dense Householder QR in extended precision.
namespace batten {
namespace fit_versus_test {

using Vector = std::vector<long double>;
using testing::FitTable;

/// B-spline j at x by the recurrence, long double.
long double b_spline(const std::vector<double>& t, std::size_t j, int degree, long double x,
                     std::size_t span) {
    if (degree == 0) return j == span ? 1 : 0;
    const std::size_t d = static_cast<std::size_t>(degree);
    const long double left = static_cast<long double>(t[j + d]) - t[j];
    const long double right = static_cast<long double>(t[j + d + 1]) - t[j + 1];
    long double sum = 0;
    if (left > 0) sum += (x - t[j]) / left * b_spline(t, j, degree - 1, x, span);
    if (right > 0) sum += (t[j + d + 1] - x) / right * b_spline(t, j + 1, degree - 1, x, span);
    return sum;
}

/// The least-squares solution for a rows x p matrix, row after row, p rows of which are needed.
Vector least_squares(Vector a, Vector z, std::size_t p) {
    const std::size_t n = z.size();
    for (std::size_t c = 0; c < p; ++c) {
        long double norm_sq = 0;
        for (std::size_t i = c; i < n; ++i) norm_sq += a[i * p + c] * a[i * p + c];
        const long double alpha = a[c * p + c];
        const long double beta = alpha > 0 ? -std::sqrt(norm_sq) : std::sqrt(norm_sq);
        Vector v(n, 0);
        for (std::size_t i = c; i < n; ++i) v[i] = a[i * p + c];
        v[c] -= beta;
        const long double factor = 1 / (norm_sq - alpha * beta);
        for (std::size_t j = c; j <= p; ++j) {
            long double sum = 0;
            for (std::size_t i = c; i < n; ++i) sum += v[i] * (j < p ? a[i * p + j] : z[i]);
            for (std::size_t i = c; i < n; ++i) {
                (j < p ? a[i * p + j] : z[i]) -= factor * sum * v[i];
            }
        }
    }
    for (std::size_t i = p; i-- > 0;) {
        for (std::size_t j = i + 1; j < p; ++j) z[i] -= a[i * p + j] * z[j];
        z[i] /= a[i * p + i];
    }
    z.resize(p);
    return z;
}

Vector dense_fit(const FitTable& table, const std::vector<double>& t, int degree) {
    const std::size_t p = t.size() - static_cast<std::size_t>(degree) - 1;
    Vector a(table.x.size() * p), z(table.x.size());
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        std::size_t span = static_cast<std::size_t>(degree);
        while (span + 1 < p && table.x[i] >= t[span + 1]) ++span;
        const long double w = 1 / static_cast<long double>(table.sigma[i]);
        for (std::size_t j = span - static_cast<std::size_t>(degree); j <= span; ++j) {
            a[i * p + j] = w * b_spline(t, j, degree, table.x[i], span);
        }
        z[i] = w * table.y[i];
    }
    return least_squares(std::move(a), std::move(z), p);
}

double largest_difference(const Fit& result, const Vector& reference) {
    long double largest = 0, scale = 0;
    for (std::size_t j = 0; j < reference.size(); ++j) {
        largest = std::max(largest, std::fabs(result.report.coefficients[j] - reference[j]));
        scale = std::max(scale, std::fabs(reference[j]));
    }
    return static_cast<double>(largest / scale);
}

TEST(FitAgainstDenseQr, AgreesWhateverTheWeights) {
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 20;
    struct Case {
        const char* name;
        double weight;
        std::size_t every;
        double allowed;
    };
    // The spec's limit for one weight of 1e6 is 1e-10.
    const Case cases[] = {{"equal", 1, 1, 1e-13},
                          {"one 1e6", 1e6, 401, 1e-10},
                          {"one 1e9", 1e9, 401, 1e-7},
                          {"every fifth 1e4", 1e4, 5, 1e-10}};
    for (const Case& c : cases) {
        FitTable table = testing::noisy_curve(401, 1, 11);
        for (std::size_t i = c.every / 2; i < table.x.size(); i += c.every) {
            table.sigma[i] = 1 / c.weight;
        }
        const Fit result = fit(table.view(), options);
        const double error =
            largest_difference(result, dense_fit(table, result.report.knots, 3));
        RecordProperty(std::string("error, ") + c.name, std::to_string(error * 1e15) + "e-15");
        EXPECT_LT(error, c.allowed) << c.name;
    }
}

TEST(FitAgainstDenseQr, AgreesForEveryDegreeAndMultiplicity) {
    for (int degree = 0; degree <= 9; ++degree) {
        const FitTable table = testing::noisy_curve(401, 1, 12);
        FitOptions options;
        options.degree = degree;
        options.knots = KnotPlacement::given;
        options.knots_values = {10, 12.5, 40, 40.001, 77};
        for (int i = 0; i <= degree; ++i) options.knots_values.push_back(80);  // a jump
        const Fit result = fit(table.view(), options);
        EXPECT_LT(largest_difference(result, dense_fit(table, result.report.knots, degree)), 1e-9)
            << degree;
        EXPECT_EQ(result.report.status, Status::met);
    }
}

TEST(FitAgainstDenseQr, AgreesWithDataHuggingTheEdgeOfASupport) {
    for (const double distance : {1e-1, 1e-3, 1e-5}) {
        FitTable table = testing::noisy_curve(401, 1, 13);
        // Nothing in the last interval but samples close to its start, and the last one.
        for (std::size_t i = 0; i < table.x.size(); ++i) {
            if (table.x[i] > 95) table.x[i] = 95 + distance * (table.x[i] - 95) / 5;
        }
        FitOptions options;
        options.knots = KnotPlacement::given;
        options.knots_values = {20, 40, 60, 80, 95};
        table.x.back() = 100;
        const Fit result = fit(table.view(), options);
        EXPECT_EQ(result.report.rank, 9);
        const Vector reference = dense_fit(table, result.report.knots, 3);
        for (std::size_t j = 0; j < 6; ++j) {
            const long double r = reference[j];
            EXPECT_NEAR(result.report.coefficients[j],
                        static_cast<double>(r), 1e-10 * std::fabs(static_cast<double>(r)));
        }
    }
}

}  // namespace fit_versus_test
}  // namespace batten
