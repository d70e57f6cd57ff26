#include "make/fit_surface/stored_grid.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "make/fit_surface/chunk_rows.hpp"
#include "make/fit_surface/grid_lines.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t numbers_at_once = std::size_t{1} << 20;
/// Of what is left to do a reading takes so much, as it is not known how many there will be.
constexpr double usual_share = 0.6;

const SurfaceStream& checked(const SurfaceStream& stream) {
    require_lines(stream.x, "x");
    require_lines(stream.y, "y");
    require_errors(stream.x_sigma, stream.x.size(), "x_sigma");
    require_errors(stream.y_sigma, stream.y.size(), "y_sigma");
    return stream;
}

}  // namespace

StoredGrid::StoredGrid(const SurfaceStream& stream, std::optional<double> sigma,
                       const Progress& progress)
    : stream_(checked(stream)),
      has_own_errors_(!stream.x_sigma.empty() || !stream.y_sigma.empty()), sigma_(sigma),
      progress_(progress), noise_(stream.y) {}

void StoredGrid::read(const TakeRows& take) {
    const std::size_t rows = stream_.x.size(), columns = stream_.y.size();
    const std::size_t usual = numbers_at_once / columns;
    const std::size_t at_once = std::clamp<std::size_t>(
        stream_.rows_at_once > 0 ? stream_.rows_at_once : usual, 1, rows);
    const double end = done_ + usual_share * (1 - done_);
    const Progress progress = progress_.stage(done_, end);
    std::vector<double> z(at_once * columns);
    for (std::size_t first = 0; first < rows; first += at_once) {
        const std::size_t count = std::min(at_once, rows - first);
        const std::span<double> block(z.data(), count * columns);
        stream_.read(first, block);
        if (has_holes(block, columns, first) && !expects_holes_) throw HolesFound{};
        for (std::size_t r = 0; r < count && is_first_ && is_estimated(); ++r) {
            noise_.add(stream_.x[first + r], block.subspan(r * columns, columns));
        }
        take(first, block);
        progress.at(first + count, rows);
    }
    is_first_ = false;
    done_ = end;
}

void StoredGrid::count_holes() {
    const std::size_t columns = stream_.y.size();
    expects_holes_ = is_first_ = true;
    noise_ = MixedNoiseOfRows(stream_.y);
    std::vector<bool> is_used(columns);
    read([&](std::size_t first, std::span<const double> z) {
        for (std::size_t at = 0; at < z.size(); at += columns) {
            std::size_t here = 0;
            for (std::size_t s = 0; s < columns; ++s) {
                if (std::isnan(z[at + s])) continue;
                ++here;
                widen(heights_, z[at + s]);
                is_used[s] = true;
            }
            missing_ += columns - here;
            if (here > 0) used_x_.push_back(stream_.x[first + at / columns]);
        }
    });
    for (std::size_t s = 0; s < columns; ++s) {
        if (is_used[s]) used_y_.push_back(stream_.y[s]);
    }
    if (used_x_.empty()) {
        throw Error("fit.too-few", "grid", "0 nodes", "at least one node must have a height");
    }
}

double StoredGrid::unit() const {
    if (has_own_errors_) return 1;
    if (sigma_) return *sigma_;
    return noise_.sigma() > 0 ? noise_.sigma() : 1;
}

Nodes StoredGrid::nodes() {
    Nodes nodes;
    nodes.x = stream_.x;
    nodes.y = stream_.y;
    nodes.stored = this;
    nodes.x_weight = weights_of(stream_.x_sigma, stream_.x.size());
    nodes.y_weight = weights_of(stream_.y_sigma, stream_.y.size());
    nodes.missing = missing_;
    nodes.count = stream_.x.size() * stream_.y.size() - missing_;
    nodes.sigma_known = !is_estimated();
    return nodes;
}

SurfaceRows StoredGrid::rows(std::size_t first, std::span<const double> z) const {
    const std::size_t count = z.size() / stream_.y.size();
    return {stream_.x.subspan(first, count), z,
            stream_.x_sigma.empty() ? stream_.x_sigma : stream_.x_sigma.subspan(first, count)};
}

}  // namespace batten::surface_fitting
