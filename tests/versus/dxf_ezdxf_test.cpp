#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "batten/io/dxf.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "curves.hpp"
#include "shared_json.hpp"

// tests/versus/read_dxf.py compares, with python3-ezdxf.
namespace batten {
namespace dxf_ezdxf_test {

using nlohmann::json;

const ArcChain open_chain(Points({0, 0, 2, 0.5, 3, 2, 3, 3, 1, 3.25}, 2), {0, 0.3, -0.1, 1.5});
const ArcChain ring(Points({1, 0, -1, 0, 1, 0}, 2), {1, 1}, true);

json polyline_entity(const char* type, const Points& points, const std::vector<double>& bulges,
                     bool closed) {
    json rows = json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double z = points.dim() > 2 ? points(i, 2) : 0.0;
        rows.push_back({points(i, 0), points(i, 1), z, i < bulges.size() ? bulges[i] : 0.0});
    }
    return {{"type", type}, {"layer", "0"}, {"closed", closed}, {"points", rows}};
}

json arc_entity(const Arc& arc, const std::string& layer) {
    json entity{{"type", arc.is_line() ? "LINE" : "ARC"}, {"layer", layer}};
    if (arc.is_line()) {
        entity["points"] = {{arc.start[0], arc.start[1], 0.0}, {arc.end[0], arc.end[1], 0.0}};
        return entity;
    }
    const std::array<double, 2> center = *arc.center();
    const auto angle = [&](std::array<double, 2> p) {
        const double degrees = std::atan2(p[1] - center[1], p[0] - center[0]) * 180 / std::numbers::pi;
        return degrees < 0 ? degrees + 360 : degrees;
    };
    const bool left = arc.bulge > 0;
    entity["arc"] = {center[0], center[1], *arc.radius(), angle(left ? arc.start : arc.end),
                     angle(left ? arc.end : arc.start)};
    return entity;
}

json spline_entity(const Curve& curve, int degree, std::vector<double> weights, bool closed) {
    json samples = json::array();
    for (int i = 0; i <= 20; ++i) {
        const Interval domain = curve.domain();
        const double t = i == 20 ? domain.hi : domain.lo + i * domain.length() / 20;
        std::vector<double> p = curve(t);
        p.resize(3, 0.0);
        samples.push_back({t, p[0], p[1], p[2]});
    }
    return {{"type", "SPLINE"},     {"layer", "0"},     {"closed", closed},
            {"degree", degree},     {"weights", weights}, {"samples", samples}};
}

class Files {
public:
    void add(std::vector<Curve> curves, const DxfOptions& options, json entities) {
        const std::string name = "dxf/" + std::to_string(cases_.size()) + ".dxf";
        const std::string path = testing::scratch_file(name);
        testing::write_text(path, dxf(curves, options));
        const bool old = options.version == DxfVersion::r12;
        cases_.push_back({{"file", path},
                          {"version", old ? "AC1009" : "AC1015"},
                          {"entities", std::move(entities)}});
    }
    /// The exit status of the reader; what it prints is shown.
    int read() const {
        const std::string list = testing::scratch_file("dxf/cases.json");
        testing::write_text(list, cases_.dump());
        const std::string python =
            std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
        const std::string reader = testing::source_file("tests/versus/read_dxf.py");
        const int status = std::system((python + " '" + reader + "' '" + list + "'").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    json cases_ = json::array();
};

TEST(Dxf, IsReadBackAsMeantAndPassesTheAudit) {
    Files files;
    DxfOptions old;
    old.version = DxfVersion::r12;
    const std::vector<double> ring_bulges{1, 1};
    const Points open_joints = open_chain.joints();
    const std::vector<double> bulges(open_chain.bulges().begin(), open_chain.bulges().end());
    const Points ring_joints({1, 0, -1, 0}, 2);
    files.add({open_chain, ring}, {},
              {polyline_entity("LWPOLYLINE", open_joints, bulges, false),
               polyline_entity("LWPOLYLINE", ring_joints, ring_bulges, true)});
    files.add({open_chain, ring}, old,
              {polyline_entity("POLYLINE", open_joints, bulges, false),
               polyline_entity("POLYLINE", ring_joints, ring_bulges, true)});
    for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
        DxfOptions separate;
        separate.version = version;
        separate.arcs = DxfArcs::separate;
        separate.layer = "CUT-1";
        json entities = json::array();
        for (std::size_t i = 0; i < open_chain.arcs(); ++i) {
            entities.push_back(arc_entity(open_chain.arc(i), separate.layer));
        }
        files.add({open_chain}, separate, entities);
        const Points space({0, 0, 1, 1, 2, 3, 2, 2, 5}, 3);
        files.add({testing::polyline(space)}, {.version = version},
                  {polyline_entity("POLYLINE", space, {}, false)});
    }
    const Curve piece = testing::bezier({0, 0, 1, 2, 3, 2.5, 4, 0});
    const Curve in_space = testing::bezier({0, 0, 1, 1, 2, 3, 3, 2.5, 0.5, 4, 0, 2}, 3);
    const Curve loop = testing::hermite(Points({0, 0, 2, 1, 1, 3, 0, 0}, 2),
                                        Points({3, 0, 0, 2, -3, 1, 3, 0}, 2), true);
    files.add({piece, in_space, loop}, {},
              {spline_entity(piece, 3, {}, false), spline_entity(in_space, 3, {}, false),
               spline_entity(loop, 3, {}, true)});
    const BSplineCurve quarter(BSplineBasis({0, 0, 0, 1, 1, 1}, 2), Points({1, 0, 1, 1, 0, 1}, 2),
                               {1, std::sqrt(0.5), 1});
    const BSplineCurve smooth(BSplineBasis({0, 0, 0, 0, 1, 2.5, 3, 3, 3, 3}, 3),
                              Points({0, 0, 1, 2, 2, -1, 3, 3, 4, 0, 5, 1}, 2));
    files.add({quarter, smooth}, {.units = DxfUnits::mm},
              {spline_entity(quarter, 2, {1, std::sqrt(0.5), 1}, false),
               spline_entity(smooth, 3, {}, false)});
    const int status = files.read();
    if (status == 77) GTEST_SKIP() << "needs python3-ezdxf";
    EXPECT_EQ(status, 0);
}

}  // namespace dxf_ezdxf_test
}  // namespace batten
