#include <algorithm>
#include <cmath>

#include "fit_samples.hpp"
#include "make/fit/interval_rows.hpp"
#include "make/fit/knot_system.hpp"
#include "make/fit/whitney.hpp"

/// Which samples an interval has, and what they determine.
namespace batten::fitting {
namespace fit_rank_law_test {

TEST(RowsOfAnInterval, AreThoseBetweenItsEndsHoweverUnevenTheSamples) {
    testing::Random random(2);
    for (int round = 0; round < 2000; ++round) {
        std::vector<double> x{0.0, 1.0};
        const int power = random.whole(1, 12);
        for (int i = random.whole(0, 200); i > 0; --i) {
            x.push_back(std::pow(random.within(0, 1), power));
        }
        std::sort(x.begin(), x.end());
        Samples samples;
        samples.x = x;
        samples.range = {0, 1};
        const Rows within{0, static_cast<std::size_t>(random.whole(0, static_cast<int>(x.size())))};
        Interval span{random.within(0, 1), random.within(0, 1)};
        if (span.lo > span.hi) std::swap(span.lo, span.hi);
        const auto not_before = [&](double bound) {
            const auto end = x.begin() + static_cast<std::ptrdiff_t>(within.last);
            return static_cast<std::size_t>(std::lower_bound(x.begin(), end, bound) - x.begin());
        };
        const Rows rows = rows_in(samples, within, span, RightEnd::open);
        EXPECT_EQ(rows.first, not_before(span.lo)) << round;
        EXPECT_EQ(rows.last, not_before(span.hi)) << round;
    }
}

TEST(RankOverSimpleKnots, IsThatOfAllCells) {
    testing::Random random(1);
    int short_of = 0;
    for (int round = 0; round < 2000; ++round) {
        const int order = random.whole(1, 6), intervals = random.whole(1, 12);
        std::vector<double> x{0.0, 48.0}, breaks{0.0, 48.0};
        // Whole numbers: many samples lie on knots and on each other.
        for (int i = random.whole(0, 40); i > 0; --i) x.push_back(random.whole(0, 48));
        for (int i = 1; i < intervals; ++i) breaks.push_back(random.whole(1, 47));
        std::sort(x.begin(), x.end());
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
        Samples samples;
        samples.x = x;
        samples.range = {0, 48};
        const std::vector<double> knots =
            open_knots(samples.range, {breaks.data() + 1, breaks.size() - 2}, order);
        const int functions = static_cast<int>(breaks.size()) - 2 + order;
        SimpleRank rank(order);
        Rows rest{0, x.size()};
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            const RightEnd end = i + 2 == breaks.size() ? RightEnd::closed : RightEnd::open;
            const Interval span{breaks[i], breaks[i + 1]};
            const Rows rows = rows_in(samples, rest, span, end);
            rest.first = rows.last;
            rank.add(count_places(samples, rows, span, order));
        }
        const int whole = rank_of(cells_of(knots, order, samples), functions);
        EXPECT_EQ(rank.rank(), whole) << round;
        short_of += whole < functions;
    }
    EXPECT_GT(short_of, 200);
}

}  // namespace fit_rank_law_test
}  // namespace batten::fitting
