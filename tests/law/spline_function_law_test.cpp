#include <cmath>

#include "batten/shape/spline_function.hpp"
#include "random.hpp"
#include "shared.hpp"

namespace batten {
namespace spline_function_law_test {

SplineFunction random_spline(testing::Random& random, int degree) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    double t = 0;
    for (int i = 0; i < 12; ++i) {
        t += random.within(0.1, 1);
        knots.push_back(t);
        if (degree > 1 && random.whole(0, 3) == 0) knots.push_back(t);
    }
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, t + 0.7);
    std::vector<double> c(knots.size() - static_cast<std::size_t>(degree) - 1);
    for (double& v : c) v = random.within(-1, 1);
    return {knots, c, degree};
}

void expect_same(const SplineFunction& a, const SplineFunction& b, double allowed) {
    const Interval domain = a.domain();
    EXPECT_EQ(b.domain(), domain);
    for (int i = 0; i <= 200; ++i) {
        const double x = domain.clamp(domain.lo + domain.length() * (i / 200.0));
        EXPECT_NEAR(a(x), b(x), allowed) << a.degree() << " " << x;
    }
}

TEST(SplineFunction, StaysTheSameUnderInsertionAndElevation) {
    testing::Random random(41);
    for (int degree = 0; degree <= 9; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        const double hi = s.domain().hi;
        const std::vector<double> more{0.3 * hi, 0.5 * hi, 0.7 * hi};
        const SplineFunction finer = insert_knots(s, more);
        EXPECT_EQ(finer.coefficients().size(), s.coefficients().size() + 3);
        expect_same(s, finer, 1e-12);
        const SplineFunction higher = elevate_degree(s, 2);
        EXPECT_EQ(higher.degree(), degree + 2);
        expect_same(s, higher, 1e-11);
    }
}

TEST(SplineFunction, LosesAnInsertedKnotWithoutChange) {
    testing::Random random(42);
    for (int degree = 1; degree <= 7; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        const double at = 0.42 * s.domain().hi;
        const SplineFunction finer = insert_knots(s, {&at, 1});
        std::size_t index = 0;
        while (finer.knots()[index] != at) ++index;
        const KnotRemoval back = remove_knot(finer, index);
        EXPECT_LT(back.max_error, 1e-12);
        expect_same(s, back.spline, 1e-12);
    }
}

TEST(SplineFunction, BoundsTheChangeOfRemoval) {
    testing::Random random(43);
    for (int degree = 1; degree <= 5; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        for (std::size_t i = static_cast<std::size_t>(degree) + 1;
             i + static_cast<std::size_t>(degree) + 1 < s.knots().size(); ++i) {
            const KnotRemoval less = remove_knot(s, i);
            EXPECT_EQ(less.spline.knots().size() + 1, s.knots().size());
            double change = 0;
            for (double x = 0; x <= s.domain().hi; x += 0.01) {
                change = std::max(change, std::fabs(s(x) - less.spline(x)));
            }
            EXPECT_LE(change, less.max_error * (1 + 1e-12) + 1e-13);
            EXPECT_GE(change, 0.01 * less.max_error);
        }
    }
}

TEST(SplineFunction, IsTheDerivativeOfItsIntegral) {
    testing::Random random(44);
    for (int degree = 0; degree <= 9; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        const SplineFunction sum = antiderivative(s);
        EXPECT_NEAR(sum(0), 0, 1e-15);
        expect_same(s, derivative(sum), 1e-11);
    }
}

TEST(SplineFunction, EvaluatesManyAsOne) {
    testing::Random random(45);
    for (int degree = 0; degree <= 7; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        std::vector<double> x;
        for (int i = 0; i < 300; ++i) x.push_back(s.domain().hi * i / 299.0);
        for (int i = 0; i < 300; ++i) x.push_back(random.within(-0.5, s.domain().hi + 0.5));
        std::vector<double> y(x.size()), first(x.size()), second(x.size());
        for (int d = 0; d <= 3; ++d) {
            s.evaluate(x, d, y);
            for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(y[i], s(x[i], d));
        }
        s.evaluate_jets(x, y, first, second);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double scale = 1 + std::fabs(s(x[i], 2)) + std::fabs(s(x[i], 1));
            EXPECT_EQ(y[i], s(x[i]));
            EXPECT_NEAR(first[i], s(x[i], 1), 1e-12 * scale);
            EXPECT_NEAR(second[i], s(x[i], 2), 1e-11 * scale);
        }
    }
}

TEST(SplineFunction, FindsEveryCrossing) {
    testing::Random random(46);
    for (int degree = 1; degree <= 7; ++degree) {
        const SplineFunction s = random_spline(random, degree);
        for (const double level : {0.0, 0.1, -0.3}) {
            const std::vector<double> found = roots(s, level);
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_NEAR(s(found[i]), level, 1e-13);
                EXPECT_TRUE(i == 0 || found[i] > found[i - 1]);
            }
            // Between two neighbours the sign does not change.
            std::size_t next = 0;
            const double hi = s.domain().hi;
            double before = s(0) - level;
            for (double x = 0.001 * hi; x < hi; x += 0.001 * hi) {
                std::size_t crossings = 0;
                while (next < found.size() && found[next] <= x) {
                    crossings += found[next] > 0;
                    ++next;
                }
                const double here = s(x) - level;
                EXPECT_EQ(crossings % 2 == 1, (here > 0) != (before > 0)) << degree << " " << x;
                before = here;
            }
        }
    }
}

}  // namespace spline_function_law_test
}  // namespace batten
