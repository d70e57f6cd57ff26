#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "batten/make/convert.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/curve.hpp"
#include "random.hpp"

namespace batten {
namespace bspline_law_test {

using testing::Random;

/// Rising knots, inner ones sometimes repeated (at most degree times), sometimes very near.
std::vector<double> random_period(Random& random, int degree, int most_spans) {
    std::vector<double> list{random.within(-1, 1)};
    const int spans = random.whole(1, most_spans);
    for (int i = 0; i < spans; ++i) {
        const double step = random.whole(0, 5) == 0 ? 1e-6 : random.within(0.1, 2);
        const int times = i + 1 < spans ? random.whole(1, std::max(1, std::min(degree, 2))) : 1;
        list.insert(list.end(), static_cast<std::size_t>(times), list.back() + step);
    }
    return list;
}

BSplineBasis random_basis(Random& random, int degree, int most_spans = 6) {
    const std::vector<double> list = random_period(random, degree, most_spans);
    if (degree > 0 && random.whole(0, 1) == 1) return BSplineBasis::periodic(list, degree);
    std::vector<double> knots(static_cast<std::size_t>(degree), list.front());
    knots.insert(knots.end(), list.begin(), list.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree), list.back());
    return {knots, degree};
}

BSplineCurve random_curve(Random& random, int degree, int dim = 2) {
    BSplineBasis basis = random_basis(random, degree);
    Points points = random.points(basis.size(), dim);
    std::vector<double> weights;
    if (random.whole(0, 1) == 1) {
        for (std::size_t i = 0; i < basis.size(); ++i) weights.push_back(random.within(0.3, 3));
    }
    return {std::move(basis), std::move(points), std::move(weights)};
}

/// Largest distance between two curves over the breaks of the second and points between.
double difference(const Curve& a, const Curve& b) {
    double largest = 0;
    for (std::size_t piece = 0; piece < b.pieces(); ++piece) {
        const Interval part = b.piece(piece);
        for (const double share : {0.0, 0.2, 0.5, 0.9}) {
            const double t = part.lo + share * part.length();
            const std::vector<double> p = a(t), q = b(t);
            for (std::size_t k = 0; k < p.size(); ++k) {
                largest = std::max(largest, std::fabs(p[k] - q[k]));
            }
        }
    }
    return largest;
}

TEST(BSplineBasis, IsAPartitionOfUnity) {
    Random random(1);
    std::vector<double> out(3 * 26);
    for (int trial = 0; trial < 400; ++trial) {
        const int degree = random.whole(0, 9);
        const BSplineBasis basis = random_basis(random, degree);
        const double t = random.within(basis.domain().lo, basis.domain().hi);
        basis.nonzero(t, 1, out);
        const Interval span{basis.knots()[basis.span_of(t)], basis.knots()[basis.span_of(t) + 1]};
        ASSERT_LE(span.lo, t);
        ASSERT_LT(t, span.hi);
        double sum = 0, slope = 0, size = 0;
        for (int j = 0; j <= degree; ++j) {
            ASSERT_GE(out[static_cast<std::size_t>(j)], 0);
            sum += out[static_cast<std::size_t>(j)];
            slope += out[static_cast<std::size_t>(j + degree + 1)];
            size += std::fabs(out[static_cast<std::size_t>(j + degree + 1)]);
        }
        ASSERT_NEAR(sum, 1, 2e-15);
        ASSERT_NEAR(slope, 0, 4e-15 * size);
    }
}

TEST(BSplineBasis, HasTheDerivativesOfItsPolynomials) {
    Random random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const int degree = random.whole(1, 6);
        const BSplineBasis basis = BSplineBasis::over(
            std::vector<double>{0, random.within(0.5, 1.5), 2, random.within(2.5, 3.5), 4}, degree);
        const std::size_t functions = static_cast<std::size_t>(degree + 1);
        std::vector<double> at(functions * functions), there(functions);
        const double t = random.within(0, 4), step = random.within(-1, 1);
        const std::size_t span = basis.span_of(t);
        basis.nonzero_on(span, t, degree, at);
        basis.nonzero_on(span, t + step, 0, there);
        for (std::size_t j = 0; j < functions; ++j) {
            double sum = 0, power = 1, size = 0;
            for (std::size_t k = 0; k < functions; ++k) {
                sum += at[k * functions + j] * power;
                size += std::fabs(at[k * functions + j] * power);
                power *= step / static_cast<double>(k + 1);
            }
            ASSERT_NEAR(sum, there[j], 1e-14 * (size + std::pow(4, degree))) << degree;
        }
    }
}

TEST(BSplineBasis, ReproducesTFromTheGrevilleAbscissae) {
    Random random(3);
    std::vector<double> out(26);
    for (int trial = 0; trial < 200; ++trial) {
        const int degree = random.whole(1, 8);
        const BSplineBasis basis = BSplineBasis::over(
            std::vector<double>{-1, random.within(-0.9, 0), random.within(0.1, 0.9), 1}, degree);
        const std::vector<double> greville = basis.greville();
        const double t = random.within(-1, 1);
        basis.nonzero(t, 0, out);
        double sum = 0;
        for (int j = 0; j <= degree; ++j) {
            sum += greville[basis.control(basis.span_of(t), j)] * out[static_cast<std::size_t>(j)];
        }
        ASSERT_NEAR(sum, t, 2e-15);
    }
}

TEST(BSplineCurve, ScalesExactlyWithPowersOfTwo) {
    Random random(4);
    for (int trial = 0; trial < 50; ++trial) {
        const BSplineCurve curve = random_curve(random, random.whole(1, 5));
        Points points(curve.control_points());
        for (double& x : points.coordinates()) x *= 0x1p-40;
        const BSplineCurve small(curve.basis(), points,
                                 {curve.weights().begin(), curve.weights().end()});
        const double t = random.within(curve.basis().domain().lo, curve.basis().domain().hi);
        const Jet a = Curve(curve).jet(t, 3), b = Curve(small).jet(t, 3);
        for (std::size_t i = 0; i < a.values().size(); ++i) {
            ASSERT_EQ(a.values()[i] * 0x1p-40, b.values()[i]);
        }
    }
}

TEST(BSplineCurve, IsAsSmoothAtAKnotAsItsMultiplicityAllows) {
    Random random(5);
    for (int trial = 0; trial < 100; ++trial) {
        const int degree = random.whole(2, 5);
        const std::vector<double> list{0, 0, 1, 1.5, 1.5, 2.25, 3};
        const BSplineBasis basis = BSplineBasis::periodic(list, degree);
        const Curve curve = BSplineCurve(basis, random.points(basis.size(), 2));
        ASSERT_TRUE(curve.is_closed());
        const std::vector<int> times{2, 1, 2, 1};
        for (std::size_t joint = 0; joint < curve.pieces(); ++joint) {
            const std::size_t before = joint == 0 ? curve.pieces() - 1 : joint - 1;
            const int order = degree - times[joint];
            const Jet left = curve.jet_on(before, curve.piece(before).hi, order + 1);
            const Jet right = curve.jet_on(joint, curve.piece(joint).lo, order + 1);
            for (int k = 0; k <= order; ++k) {
                ASSERT_NEAR(left[k][0], right[k][0], 1e-12 * std::pow(10, k)) << joint << ' ' << k;
            }
            ASSERT_GT(std::fabs(left[order + 1][0] - right[order + 1][0]), 1e-6);
        }
    }
}

TEST(InsertKnots, KeepsTheCurveAndTheControlPointsNoKnotReaches) {
    Random random(6);
    for (int trial = 0; trial < 200; ++trial) {
        const int degree = random.whole(1, 5);
        const BSplineCurve curve = random_curve(random, degree);
        const Interval domain = curve.basis().domain();
        std::vector<double> fresh;
        for (int i = random.whole(1, 4); i > 0; --i) {
            fresh.push_back(random.within(domain.lo, domain.hi));
        }
        if (degree > 1) fresh.push_back(fresh.front());
        const BSplineCurve finer = insert_knots(curve, fresh);
        ASSERT_EQ(finer.basis().size(), curve.basis().size() + fresh.size());
        ASSERT_LE(difference(curve, finer), 3e-14);
        ASSERT_EQ(insert_knots(curve, {}), curve);
    }
    const BSplineCurve curve(BSplineBasis::over(std::vector<double>{0, 1, 2, 3, 4, 5, 6}, 3),
                             random.points(9, 2));
    const BSplineCurve finer = insert_knots(curve, std::vector<double>{0.5});
    for (std::size_t i = 4; i < 9; ++i) {
        EXPECT_EQ(finer.control_points()(i + 1, 0), curve.control_points()(i, 0));
    }
}

TEST(InsertKnots, MayOpenASeamOfAClosedCurve) {
    Random random(7);
    const BSplineBasis basis = BSplineBasis::periodic(std::vector<double>{0, 1, 2.5, 3, 4}, 3);
    const BSplineCurve curve(basis, random.points(4, 3));
    const BSplineCurve finer = insert_knots(curve, std::vector<double>{0, 4});
    EXPECT_LE(difference(curve, finer), 1e-14);
    EXPECT_EQ(finer.basis().size(), 6u);
}

TEST(RemoveKnots, StaysWithinTheToleranceAndTellsHowFar) {
    testing::Random random(11);
    int removed = 0;
    for (int round = 0; round < 60; ++round) {
        const int degree = random.whole(2, 5);
        std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
        for (int i = 1; i < 12; ++i) knots.push_back(i);
        knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 12.0);
        Points points(knots.size() - static_cast<std::size_t>(degree) - 1, 2);
        for (std::size_t j = 0; j < points.size(); ++j) {
            points(j, 0) = static_cast<double>(j);
            points(j, 1) = std::sin(0.7 * static_cast<double>(j)) + random.within(-0.01, 0.01);
        }
        const Curve curve{BSplineCurve(BSplineBasis(knots, degree), points)};
        ConvertOptions options;
        options.remove_knots = true;
        options.tolerance = absolute(std::pow(10.0, random.within(-3, -0.5)));
        const Conversion made = convert(curve, options);
        EXPECT_EQ(made.report.status, Status::met) << round;
        double largest = 0;
        for (int i = 0; i <= 12 * 16; ++i) {
            const Jet a = curve.jet(i / 16.0, 0), b = made.curve.jet(i / 16.0, 0);
            largest = std::max(largest, std::hypot(a[0][0] - b[0][0], a[0][1] - b[0][1]));
        }
        EXPECT_LE(largest, options.tolerance.value) << round;
        EXPECT_NEAR(made.report.max_error, largest, 1e-12) << round;
        removed += static_cast<int>(*made.report.removed);
    }
    EXPECT_GT(removed, 60);
}

TEST(ElevateDegree, KeepsTheCurve) {
    Random random(8);
    for (int trial = 0; trial < 100; ++trial) {
        const BSplineCurve curve = random_curve(random, random.whole(1, 5));
        const int by = random.whole(1, 3);
        const BSplineCurve higher = elevate_degree(curve, by);
        ASSERT_EQ(higher.basis().degree(), curve.basis().degree() + by);
        ASSERT_EQ(higher.basis().breaks().size(), curve.basis().breaks().size());
        ASSERT_LE(difference(curve, higher), 3e-14);
    }
}

TEST(BSplineCurve, BecomesCubicPiecesAndComesBack) {
    Random random(9);
    for (int trial = 0; trial < 100; ++trial) {
        const bool is_closed = trial % 2 == 1;
        const std::vector<double> breaks{0, random.within(0.5, 1.5), 2, random.within(2.5, 3.5), 4};
        const BSplineBasis basis =
            is_closed ? BSplineBasis::periodic(breaks, 3) : BSplineBasis::over(breaks, 3);
        const BSplineCurve curve(basis, random.points(basis.size(), 2));
        const PiecewiseCubic pieces = to_piecewise_cubic(curve);
        ASSERT_LE(difference(curve, pieces), 1e-14);
        ASSERT_EQ(pieces.is_closed(), is_closed);
        const std::vector<int> smooth(is_closed ? 4 : 3, 2), corners(is_closed ? 4 : 3, 0);
        const BSplineCurve back = to_bspline(pieces, smooth);
        ASSERT_EQ(back.basis(), basis);
        for (std::size_t i = 0; i < basis.size(); ++i) {
            ASSERT_NEAR(back.control_points()(i, 1), curve.control_points()(i, 1), 1e-13);
        }
        const BSplineCurve bezier = to_bspline(pieces, corners);
        ASSERT_LE(difference(bezier, pieces), 1e-14);
        ASSERT_EQ(bezier.basis().size(), is_closed ? 12u : 13u);
    }
}

TEST(BSplineCurve, OfLowDegreeBecomesCubicPieces) {
    Random random(10);
    for (const int degree : {1, 2}) {
        const BSplineBasis basis = BSplineBasis::over(std::vector<double>{0, 1, 2.5, 3}, degree);
        const BSplineCurve curve(basis, random.points(basis.size(), 3));
        EXPECT_LE(difference(curve, to_piecewise_cubic(curve)), 1e-15);
    }
}

TEST(BSplineCurve, MovesOnlyWhereTheMovedControlPointReaches) {
    Random random(11);
    const BSplineBasis basis =
        BSplineBasis::over(std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8}, 3);
    Points points = random.points(basis.size(), 2);
    const Curve before = BSplineCurve(basis, points);
    points(5, 0) += 1;
    const Curve after = BSplineCurve(basis, points);
    for (std::size_t piece = 0; piece < 8; ++piece) {
        const double t = before.piece(piece).middle();
        EXPECT_EQ(before(t) == after(t), piece < 2 || piece > 5) << piece;
    }
}

}  // namespace bspline_law_test
}  // namespace batten
