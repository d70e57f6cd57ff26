#include "batten/io/gcode.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "shape/plane.hpp"

namespace batten {
namespace {

using plane::Vector;

void require_sound(const ArcChain& chain, const GcodeOptions& options,
                   std::span<const double> feeds) {
    const auto require_feed = [](double feed, const std::string& place) {
        if (feed > 0 && std::isfinite(feed)) return;
        throw Error("option.range", place, format_number(feed), "must be above 0 and finite");
    };
    require_feed(options.feed, "feed");
    for (std::size_t i = 0; i < feeds.size(); ++i) {
        require_feed(feeds[i], "feed " + std::to_string(i));
    }
    if (!feeds.empty() && feeds.size() != chain.arcs()) {
        throw Error("gcode.feeds", "feeds", std::to_string(feeds.size()),
                    "one for each of the " + std::to_string(chain.arcs()) + " arcs is needed");
    }
    if (options.decimals < 0 || options.decimals > 9) {
        throw Error("option.range", "decimals", std::to_string(options.decimals),
                    "must be from 0 to 9");
    }
    if (options.z && !std::isfinite(*options.z)) {
        throw Error("option.range", "z", format_number(*options.z), "must be finite");
    }
}

/// Writes the program line by line; knows where the machine stands and how fast it goes.
class Program {
public:
    explicit Program(const GcodeOptions& options)
        : options_(options), unit_(std::pow(10.0, -options.decimals)) {}

    void line(const std::string& text) {
        text_ += text;
        if (text_.empty() || text_.back() != '\n') text_ += '\n';
    }
    void rapid_to(Vector p) {
        here_ = rounded(p);
        line("G0 X" + number(here_.x) + " Y" + number(here_.y));
    }
    void height(double z) { line("G1 Z" + number(z) + feed_word(options_.feed)); }
    void move(const Arc& arc, double feed);
    std::string text() && { return std::move(text_); }

private:
    std::string number(double x) const { return format_fixed(x, options_.decimals); }
    Vector rounded(Vector p) const;
    Vector center_from_here(Vector end, double bulge) const;
    std::string feed_word(double feed);
    void arc_to(Vector end, double bulge, double feed);

    const GcodeOptions& options_;
    double unit_;
    std::string text_;
    Vector here_;
    double feed_ = 0;
};

Vector Program::rounded(Vector p) const {
    constexpr double most = 1e15;
    if (!(std::fabs(p.x) < most * unit_ && std::fabs(p.y) < most * unit_)) {
        throw Error("gcode.too-large", "coordinates",
                    format_number(std::fabs(p.x) > std::fabs(p.y) ? p.x : p.y),
                    "no more than 15 digits are written: use fewer decimals");
    }
    return {*parse_number(number(p.x)), *parse_number(number(p.y))};
}

std::string Program::feed_word(double feed) {
    if (feed == feed_) return "";
    feed_ = feed;
    return " F" + format_number(feed);
}

/// I and J: the rounded centre, seen from the start, whose radii to both ends differ least.
Vector Program::center_from_here(Vector end, double bulge) const {
    const Vector half = 0.5 * (end - here_);
    const Vector center = half + (1 - bulge * bulge) / (2 * bulge) * plane::left_of(half);
    const Vector low{std::floor(center.x / unit_), std::floor(center.y / unit_)};
    Vector best;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector corner : {Vector{0, 0}, Vector{1, 0}, Vector{0, 1}, Vector{1, 1}}) {
        const Vector c = rounded(unit_ * (low + corner));
        const double apart = std::fabs(plane::norm(c) - plane::norm(end - here_ - c));
        if (apart < least) {
            least = apart;
            best = c;
        }
    }
    return best;
}

void Program::arc_to(Vector end, double bulge, double feed) {
    if (end == here_) return;
    const double sagitta = 0.5 * plane::norm(end - here_) * std::fabs(bulge);
    const std::string target = " X" + number(end.x) + " Y" + number(end.y);
    if (sagitta < 0.5 * unit_) {
        line("G1" + target + feed_word(feed));
    } else {
        const Vector center = center_from_here(end, bulge);
        line((bulge > 0 ? "G3" : "G2") + target + " I" + number(center.x) + " J" +
             number(center.y) + feed_word(feed));
    }
    here_ = end;
}

void Program::move(const Arc& arc, double feed) {
    const Vector start{arc.start[0], arc.start[1]}, end{arc.end[0], arc.end[1]};
    if (std::fabs(arc.bulge) <= 1) return arc_to(rounded(end), arc.bulge, feed);
    const Vector half = 0.5 * (end - start);
    const Vector middle = start + half - arc.bulge * plane::left_of(half);
    const double half_bulge = std::tan(0.5 * std::atan(arc.bulge));
    arc_to(rounded(middle), half_bulge, feed);
    arc_to(rounded(end), half_bulge, feed);
}

}  // namespace

std::string gcode(const ArcChain& chain, const GcodeOptions& options,
                  std::span<const double> feeds) {
    require_sound(chain, options, feeds);
    Program program(options);
    if (!options.header.empty()) program.line(options.header);
    program.line(options.units == GcodeUnits::mm ? "G21" : "G20");
    program.line("G90");
    program.line("G17");
    program.rapid_to(plane::at(chain.joints(), 0));
    if (options.z) program.height(*options.z);
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        program.move(chain.arc(i), feeds.empty() ? options.feed : feeds[i]);
    }
    if (!options.footer.empty()) program.line(options.footer);
    return std::move(program).text();
}

}  // namespace batten
