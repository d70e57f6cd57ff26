#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/area.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/measure/deviation.hpp"
#include "batten/measure/energy.hpp"
#include "batten/measure/length.hpp"
#include "batten/measure/measure.hpp"
#include "batten/measure/nearest.hpp"
#include "batten/shape/transform.hpp"
#include "curves.hpp"
#include "random.hpp"

namespace batten {
namespace measure_law_test {

using namespace batten::testing;

Curve random_curve(std::uint64_t seed, int dim = 2, std::size_t rows = 7) {
    Random random(seed);
    const Points points = random.points(rows, dim), slopes = random.points(rows, dim);
    return hermite(points, slopes);
}

Curve random_waves(std::uint64_t seed) {
    Random random(seed);
    const auto wave = [&] {
        return Wave{random.within(0.1, 1), static_cast<double>(random.whole(1, 3)),
                    random.within(0, 6)};
    };
    return waves({{wave(), wave()}, {wave(), wave()}}, {0, 2.5, 2 * std::numbers::pi});
}

std::vector<Curve> plane_curves() {
    std::vector<Curve> curves;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) curves.push_back(random_curve(seed));
    for (std::uint64_t seed = 1; seed <= 2; ++seed) curves.push_back(random_waves(seed));
    return curves;
}

TEST(Length, OfPartsAddsUp) {
    Random random(3);
    for (const Curve& curve : plane_curves()) {
        const Interval domain = curve.domain();
        for (int i = 0; i < 5; ++i) {
            const double middle = random.within(domain.lo, domain.hi);
            const Measured whole = length(curve);
            const Measured left = length(curve, Interval{domain.lo, middle});
            const Measured right = length(curve, Interval{middle, domain.hi});
            EXPECT_NEAR(left.value + right.value, whole.value,
                        whole.error + left.error + right.error);
        }
        Measured sum;
        for (const Measured& piece : piece_lengths(curve)) sum.value += piece.value;
        EXPECT_NEAR(sum.value, length(curve).value, 1e-14 * sum.value);
    }
}

void expect_scaled(const std::optional<double>& a, const std::optional<double>& b, double factor,
                   const char* what) {
    ASSERT_EQ(a.has_value(), b.has_value()) << what;
    EXPECT_EQ(a.value_or(0) * factor, b.value_or(0)) << what;
}

TEST(Measures, ScaleExactlyWithPowersOfTwo) {
    for (const Curve& curve : plane_curves()) {
        const MeasureReport one = measure(curve);
        for (const double k : {0x1p-60, 0.25, 0x1p100}) {
            const MeasureReport other = measure(mapped(curve, {k, 0, 0, k, 0, 0}));
            EXPECT_EQ(one.length * k, other.length);
            EXPECT_EQ(one.length_error * k, other.length_error);
            expect_scaled(one.area, other.area, k * k, "area");
            expect_scaled(one.area_positive, other.area_positive, k * k, "area_positive");
            expect_scaled(one.area_negative, other.area_negative, k * k, "area_negative");
            expect_scaled(one.bending_energy, other.bending_energy, 1 / k, "bending_energy");
            expect_scaled(one.energy_length, other.energy_length, 1, "energy_length");
            expect_scaled(one.pseudo_energy, other.pseudo_energy, k, "pseudo_energy");
            EXPECT_EQ(one.max_curvature->value / k, other.max_curvature->value);
            EXPECT_EQ(one.max_curvature->t, other.max_curvature->t);
            EXPECT_EQ(one.turning, other.turning);
            EXPECT_EQ(one.inflections, other.inflections);
            EXPECT_EQ(one.centroid[0] * k, other.centroid[0]);
        }
    }
}

TEST(Measures, DoNotChangeWhenTheCurveIsMoved) {
    for (const Curve& curve : plane_curves()) {
        const MeasureReport one = measure(curve);
        Affine move = rotation(0.8);
        move.x = 0.7;
        move.y = -0.4;
        const MeasureReport other = measure(mapped(curve, move));
        EXPECT_NEAR(one.length, other.length, 1e-14 * one.length);
        EXPECT_NEAR(*one.area, *other.area, 1e-13);
        EXPECT_NEAR(*one.area_positive, *other.area_positive, 1e-11);
        EXPECT_NEAR(*one.bending_energy, *other.bending_energy, 1e-11 * *one.bending_energy);
        EXPECT_NEAR(*one.turning, *other.turning, 1e-13);
        ASSERT_EQ(one.inflections->size(), other.inflections->size());
        for (std::size_t i = 0; i < one.inflections->size(); ++i) {
            EXPECT_NEAR((*one.inflections)[i], (*other.inflections)[i], 1e-9);
        }
        EXPECT_NEAR(one.max_curvature->value, other.max_curvature->value,
                    1e-11 * one.max_curvature->value);
    }
}

TEST(Measures, OfAReversedCurveAreTheSameWithTheirSign) {
    for (const Curve& curve : plane_curves()) {
        const MeasureReport one = measure(curve), other = measure(reversed(curve));
        EXPECT_NEAR(one.length, other.length, one.length_error + other.length_error);
        EXPECT_NEAR(*one.area, -*other.area, 1e-14);
        EXPECT_NEAR(*one.area_positive, *other.area_negative, 1e-11);
        EXPECT_NEAR(*one.bending_energy, *other.bending_energy, 1e-11 * *one.bending_energy);
        EXPECT_NEAR(*one.turning, -*other.turning, 1e-13);
        EXPECT_EQ(one.inflections->size(), other.inflections->size());
        EXPECT_EQ(one.joints.size(), other.joints.size());
    }
}

TEST(Area, IsPositiveLessNegative) {
    for (const Curve& curve : plane_curves()) {
        const auto parts = areas_by_winding(curve);
        ASSERT_TRUE(parts);
        EXPECT_NEAR(parts->positive - parts->negative, area(curve).value, 1e-14);
    }
}

/// The area by winding numbers of cells of a fine grid.
AreasByWinding counted(const Curve& curve, int cells) {
    std::vector<double> polygon_x, polygon_y;
    const Interval domain = curve.domain();
    for (int i = 0; i <= 3000; ++i) {
        const std::vector<double> p = curve(domain.lo + domain.length() * i / 3000);
        polygon_x.push_back(p[0]);
        polygon_y.push_back(p[1]);
    }
    polygon_x.push_back(polygon_x[0]);
    polygon_y.push_back(polygon_y[0]);
    AreasByWinding result;
    const double reach = 2.5, cell = 2 * reach / cells;
    for (int row = 0; row < cells; ++row) {
        const double y = -reach + (row + 0.5) * cell;
        std::vector<std::pair<double, int>> crossings;
        for (std::size_t i = 0; i + 1 < polygon_x.size(); ++i) {
            const double y0 = polygon_y[i], y1 = polygon_y[i + 1];
            if ((y0 <= y) == (y1 <= y)) continue;
            crossings.push_back({polygon_x[i] + (y - y0) / (y1 - y0) *
                                                    (polygon_x[i + 1] - polygon_x[i]),
                                 y1 > y0 ? 1 : -1});
        }
        std::sort(crossings.begin(), crossings.end());
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding -= crossings[i].second;
            const double strip = cell * (crossings[i + 1].first - crossings[i].first);
            (winding > 0 ? result.positive : result.negative) += std::abs(winding) * strip;
        }
    }
    return result;
}

TEST(AreaByWinding, EqualsCountedStrips) {
    for (const Curve& curve : plane_curves()) {
        const auto parts = areas_by_winding(curve);
        const AreasByWinding slow = counted(curve, 2000);
        EXPECT_NEAR(parts->positive, slow.positive, 2e-3);
        EXPECT_NEAR(parts->negative, slow.negative, 2e-3);
    }
}

TEST(NearestPoint, IsNotFartherThanAnySample) {
    Random random(9);
    std::vector<Curve> curves = plane_curves();
    curves.push_back(random_curve(20, 3));
    curves.push_back(random_curve(21, 1));
    for (const Curve& curve : curves) {
        for (int i = 0; i < 20; ++i) {
            std::vector<double> point;
            for (int k = 0; k < curve.dim(); ++k) point.push_back(random.within(-1.5, 1.5));
            const Nearest near = nearest(curve, point);
            const Interval domain = curve.domain();
            double least = 1e9;
            for (int j = 0; j <= 2000; ++j) {
                const std::vector<double> p = curve(domain.lo + domain.length() * j / 2000);
                double d = 0;
                for (int k = 0; k < curve.dim(); ++k) d = std::hypot(d, p[k] - point[k]);
                least = std::fmin(least, d);
            }
            EXPECT_LE(near.distance, least + 1e-14);
            EXPECT_GE(near.distance, least - 1e-3);
            const Jet at = curve.jet(near.t, 1);
            double across = 0, speed = 0;
            for (int k = 0; k < curve.dim(); ++k) {
                across += (point[k] - at[0][k]) * at[1][k];
                speed = std::hypot(speed, at[1][k]);
            }
            bool is_joint = false;
            for (const double b : curve.breaks()) is_joint = is_joint || near.t == b;
            const bool is_foot = is_joint || std::fabs(across) <= 1e-12 * speed;
            // On a line the curve may stop and turn before it reaches the point.
            EXPECT_TRUE(is_foot || curve.dim() == 1) << across / speed;
        }
    }
}

TEST(MaxCurvature, IsNotBelowAnySample) {
    std::vector<Curve> curves = plane_curves();
    for (std::uint64_t seed = 30; seed < 34; ++seed) curves.push_back(random_curve(seed, 3));
    for (const Curve& curve : curves) {
        const MaxCurvature sharpest = *max_curvature(curve);
        const Interval domain = curve.domain();
        double most = 0;
        for (int i = 0; i <= 5000; ++i) {
            const double t = domain.lo + domain.length() * i / 5000;
            most = std::fmax(most, std::fabs(*curvature(curve.jet(t, 2))));
        }
        EXPECT_GE(sharpest.value, most * (1 - 1e-10));
        const std::size_t piece = curve.piece_of(sharpest.t);
        double at_t = std::fabs(*curvature(curve.jet(sharpest.t, 2)));
        if (piece > 0 && sharpest.t == curve.breaks()[piece]) {
            at_t = std::fmax(at_t,
                             std::fabs(*curvature(curve.jet_on(piece - 1, sharpest.t, 2))));
        }
        EXPECT_NEAR(at_t, sharpest.value, 1e-12 * sharpest.value);
    }
}

TEST(Turning, IsTheIntegralOfTheCurvature) {
    for (const Curve& curve : {random_waves(4), random_waves(5)}) {
        double sum = 0;
        const Interval domain = curve.domain();
        const int n = 40000;  // a smooth closed curve: the rectangle rule converges at once
        for (int i = 0; i < n; ++i) {
            const Jet jet = curve.jet(domain.lo + domain.length() * i / n, 2);
            sum += *curvature(jet) * std::hypot(jet[1][0], jet[1][1]) * domain.length() / n;
        }
        EXPECT_NEAR(turning(curve), sum, 1e-9);
        EXPECT_NEAR(std::remainder(turning(curve), 2 * std::numbers::pi), 0, 1e-12);
    }
}

TEST(HausdorffDistance, IsSymmetricAndBoundsEverySample) {
    for (std::uint64_t seed = 40; seed < 46; ++seed) {
        const int dim = seed % 2 == 0 ? 2 : 3;
        const Curve a = random_curve(seed, dim), b = random_curve(seed + 100, dim, 5);
        const Measured there = hausdorff(a, b, absolute(1e-7));
        EXPECT_NEAR(there.value, hausdorff(b, a, absolute(1e-7)).value, 1e-7);
        EXPECT_LE(hausdorff(a, a).value, 1e-15);
        double most = 0;
        for (int i = 0; i <= 500; ++i) {
            const auto at = [i](const Curve& c) {
                return c(c.domain().lo + c.domain().length() * i / 500);
            };
            most = std::fmax(most, nearest(b, at(a)).distance);
            most = std::fmax(most, nearest(a, at(b)).distance);
        }
        EXPECT_GE(there.value + there.error, most);
        EXPECT_LE(there.value, most + 1e-2);
    }
}

TEST(CoordinateOfACurve, RisesAndFallsBetweenItsExtrema) {
    for (const Curve& curve : plane_curves()) {
        const std::vector<Extremum> places = extrema(curve, 1);
        const Interval all = range(curve, 1);
        double last = curve(curve.domain().lo)[1];
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool rises = places[i].kind == ExtremumKind::maximum;
            EXPECT_TRUE(rises ? places[i].value > last : places[i].value < last);
            EXPECT_TRUE(all.contains(places[i].value));
            last = places[i].value;
            // Between two extrema every value between theirs is taken once.
            if (i + 1 < places.size()) {
                const double value = 0.5 * (places[i].value + places[i + 1].value);
                int count = 0;
                for (const double t : roots(curve, 1, value)) {
                    count += t > places[i].t && t < places[i + 1].t;
                }
                EXPECT_EQ(count, 1);
            }
        }
    }
}

}  // namespace measure_law_test
}  // namespace batten
