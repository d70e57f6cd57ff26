#include "batten/io/dxf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/transform.hpp"
#include "io/exchange/dxf_writer.hpp"

namespace batten {
namespace {

using dxf_file::Handles;
using dxf_file::Pairs;

/// Writes entities of one file.
class Entities {
public:
    Entities(const DxfOptions& options, Handles& handles) : options_(options), handles_(handles) {}

    void add(const Curve& curve);
    const std::string& text() const { return out_.text(); }

private:
    bool is_r12() const { return options_.version == DxfVersion::r12; }
    /// Starts an entity of the model space, or one that another entity owns; returns its handle.
    std::string begin(std::string_view kind, std::string_view subclass);
    std::string begin(std::string_view kind, std::string_view subclass, std::string_view owner);
    void point(int code, std::span<const double> p);
    void arcs(const ArcChain& chain);
    void light_polyline(PointsView points, std::span<const double> bulges, bool closed);
    void heavy_polyline(PointsView points, std::span<const double> bulges, bool closed);
    void polyline(PointsView points, std::span<const double> bulges, bool closed);
    void line(const Arc& arc);
    void arc(const Arc& arc);
    void spline(const BSplineCurve& curve, bool closed);

    const DxfOptions& options_;
    Handles& handles_;
    Pairs out_;
};

std::string Entities::begin(std::string_view kind, std::string_view subclass) {
    return begin(kind, subclass, dxf_file::model_space);
}

std::string Entities::begin(std::string_view kind, std::string_view subclass,
                            std::string_view owner) {
    out_.add(0, kind);
    if (is_r12()) {
        out_.add(8, options_.layer);
        return {};
    }
    std::string handle = handles_.next();
    out_.add(5, handle).add(330, owner).add(100, "AcDbEntity").add(8, options_.layer);
    if (!subclass.empty()) out_.add(100, subclass);
    return handle;
}

/// x, y and z under `code`, `code` + 10 and `code` + 20; z is 0 in the plane.
void Entities::point(int code, std::span<const double> p) {
    for (int k = 0; k < 3; ++k) {
        const std::size_t at = static_cast<std::size_t>(k);
        out_.add(code + 10 * k, at < p.size() ? p[at] : 0.0);
    }
}

void Entities::light_polyline(PointsView points, std::span<const double> bulges, bool closed) {
    begin("LWPOLYLINE", "AcDbPolyline");
    out_.add(90, points.size()).add(70, closed ? 1 : 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        out_.add(10, points(i, 0)).add(20, points(i, 1));
        if (i < bulges.size() && bulges[i] != 0) out_.add(42, bulges[i]);
    }
}

void Entities::heavy_polyline(PointsView points, std::span<const double> bulges, bool closed) {
    const bool in_space = points.dim() == 3;
    const std::string handle = begin("POLYLINE", in_space ? "AcDb3dPolyline" : "AcDb2dPolyline");
    out_.add(66, 1);
    point(10, {});
    out_.add(70, (closed ? 1 : 0) + (in_space ? 8 : 0));
    for (std::size_t i = 0; i < points.size(); ++i) {
        begin("VERTEX", "AcDbVertex", handle);
        if (!is_r12()) out_.add(100, in_space ? "AcDb3dPolylineVertex" : "AcDb2dVertex");
        point(10, points[i]);
        if (in_space) out_.add(70, 32);
        if (i < bulges.size() && bulges[i] != 0) out_.add(42, bulges[i]);
    }
    begin("SEQEND", "", handle);
}

/// A closed one lists its first point once.
void Entities::polyline(PointsView points, std::span<const double> bulges, bool closed) {
    if (closed) points = points.part(0, points.size() - 1);
    if (is_r12() || points.dim() == 3) {
        heavy_polyline(points, bulges, closed);
    } else {
        light_polyline(points, bulges, closed);
    }
}

void Entities::line(const Arc& arc) {
    begin("LINE", "AcDbLine");
    point(10, arc.start);
    point(11, arc.end);
}

/// Always counter-clockwise: from the end to the start where the arc turns right.
void Entities::arc(const Arc& arc) {
    const std::array<double, 2> center = *arc.center();
    const auto angle = [&](const std::array<double, 2>& p) {
        const double degrees =
            std::atan2(p[1] - center[1], p[0] - center[0]) * (180 / std::numbers::pi);
        // What is below 0 by a rounding is 0 and not 360.
        return degrees < 0 && degrees + 360 < 360 ? degrees + 360 : std::max(degrees, 0.0);
    };
    begin("ARC", "AcDbCircle");
    point(10, center);
    out_.add(40, *arc.radius());
    if (!is_r12()) out_.add(100, "AcDbArc");
    out_.add(50, angle(arc.bulge > 0 ? arc.start : arc.end));
    out_.add(51, angle(arc.bulge > 0 ? arc.end : arc.start));
}

void Entities::arcs(const ArcChain& chain) {
    if (options_.arcs == DxfArcs::polyline) {
        return polyline(chain.joints(), chain.bulges(), chain.is_closed());
    }
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        chain.arc(i).is_line() ? line(chain.arc(i)) : arc(chain.arc(i));
    }
}

void Entities::spline(const BSplineCurve& curve, bool closed) {
    if (is_r12()) {
        throw Error("dxf.needs-r2000", "curve", "a spline",
                    "r12 knows no splines: convert to arcs or a polyline, or write r2000");
    }
    constexpr int is_closed = 1, is_rational = 4, is_planar = 8;
    begin("SPLINE", "AcDbSpline");
    out_.add(70, (closed ? is_closed : 0) + (curve.is_rational() ? is_rational : 0) +
                     (curve.dim() == 2 ? is_planar : 0));
    out_.add(71, curve.basis().degree());
    out_.add(72, curve.basis().knots().size()).add(73, curve.control_points().size()).add(74, 0);
    for (const double knot : curve.basis().knots()) out_.add(40, knot);
    for (const double weight : curve.weights()) out_.add(41, weight);
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
        point(10, curve.control_points()[i]);
    }
}

/// The same pieces, not closed.
PiecewiseCubic opened(const PiecewiseCubic& curve) {
    std::vector<double> block;
    for (int power = 0; power <= 3; ++power) {
        for (int k = 0; k < curve.dim(); ++k) {
            const std::span<const double> column = curve.coefficients(power, k);
            block.insert(block.end(), column.begin(), column.end());
            if (power > 0) block.push_back(0);
        }
    }
    return PiecewiseCubic::power(std::move(block), curve.dim(),
                                 {curve.breaks().begin(), curve.breaks().end()}, false);
}

void Entities::add(const Curve& curve) {
    if (curve.dim() != 2 && curve.dim() != 3) {
        throw Error("curve.dimension", "curve", std::to_string(curve.dim()) + " coordinates",
                    "a drawing takes 2 or 3");
    }
    if (const ArcChain* chain = curve.shape<ArcChain>()) return arcs(*chain);
    if (const std::optional<Points> joints = exact_polyline(curve)) {
        return polyline(*joints, {}, curve.is_closed());
    }
    const BSplineCurve* whole = curve.shape<BSplineCurve>();
    if (whole && whole->basis().degree() <= 3 && !whole->is_closed()) return spline(*whole, false);
    if (const std::optional<PiecewiseCubic> cubic = exact_cubic(curve)) {
        const std::vector<int> joined(cubic->pieces() - 1, 0);
        return spline(to_bspline(opened(*cubic), joined), curve.is_closed());
    }
    throw Error("curve.not-exact", "curve",
                curve.degree() ? "degree " + std::to_string(*curve.degree()) : "no polynomial",
                "a drawing takes arcs and splines up to degree 3: convert the curve first");
}

void require_layer(const std::string& layer) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789$-_";
    constexpr std::size_t longest = 31;
    if (layer.empty() || layer.size() > longest ||
        layer.find_first_not_of(letters) != std::string::npos) {
        throw Error("dxf.layer", "layer", layer,
                    "must be 1 to 31 letters, digits, $, - or _");
    }
}

}  // namespace

std::string dxf(std::span<const Curve> curves, const DxfOptions& options) {
    require_layer(options.layer);
    Handles handles;
    Entities entities(options, handles);
    for (const Curve& curve : curves) entities.add(curve);
    return dxf_file::document(entities.text(), options, handles);
}

std::string dxf(const Curve& curve, const DxfOptions& options) {
    return dxf(std::span(&curve, 1), options);
}

}  // namespace batten
