#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "batten/io/draw/drawing.hpp"
#include "io/draw/check.hpp"
#include "io/draw/shapes/bend.hpp"
#include "num/gauss.hpp"

namespace batten {
namespace {

using namespace drawing;

constexpr double line_tolerance = 1e-3;  ///< of the picture
constexpr int length_nodes = 8;

double distance_along(const Curve& curve, std::size_t piece, Interval part) {
    const auto speed = [&](double t) {
        const Jet jet = curve.jet_on(piece, t, 1);
        double size = 0;
        for (const double x : jet[1]) size = std::hypot(size, x);
        return size;
    };
    return num::integrate(speed, part, num::gauss_legendre(length_nodes));
}

/// Grows from sample to sample; breaks where there is no curvature and where it jumps.
struct CurvatureLine {
    double unit;  ///< the curvature that is 1 in the samples
    double s = 0;
    std::vector<Points> runs = {};
    std::optional<double> height = {};  ///< of the last sample, if it exists

    void start_piece(const Sample& sample) {
        const bool jumps = height && std::fabs(sample.at[1] - *height) > line_tolerance;
        if (jumps) height.reset();
        add(sample);
    }

    void add(const Sample& sample) {
        if (sample.exists && !height) runs.emplace_back(0, 2);
        height.reset();
        if (!sample.exists) return;
        height = sample.at[1];
        runs.back().push_back(std::array{s, *height * unit});
    }
};

}  // namespace

ArrowsLayer tangent_arrows(const Curve& curve, std::span<const double> t) {
    ArrowsLayer arrows{Points(0, curve.dim()), Points(0, curve.dim()), {}};
    for (const double at : t) {
        const Jet jet = curve.jet(at, 1);
        arrows.at.push_back(jet[0]);
        arrows.directions.push_back(jet[1]);
    }
    return arrows;
}

Panel curvature_plot(const Curve& curve, const std::string& name) {
    require_plane_or_space(curve.dim(), "curvature plot");
    const double size = 2 * box_of(trace_of(curve)).reach();
    const double peak = peak_curvature(curve, size);
    const double tallest = peak > 0 ? peak : 1;
    CurvatureLine line{tallest / size};
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        const auto spot = [&](double t) {
            const Bend bend = bend_of(curve, i, t, size);
            const double share = (t - piece.lo) / piece.length();
            return Sample{t, {share, bend.curvature / tallest, 0}, bend.exists};
        };
        const std::vector<Sample> samples =
            refined(spot, piece, least_chords(curve), line_tolerance);
        line.start_piece(samples.front());
        for (std::size_t j = 1; j < samples.size(); ++j) {
            line.s += distance_along(curve, i, {samples[j - 1].t, samples[j].t});
            line.add(samples[j]);
        }
    }
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.x_label = "arc length";
    panel.y_label = "curvature";
    panel.add(PolylineLayer{std::move(line.runs), name, {}});
    return panel;
}

}  // namespace batten
