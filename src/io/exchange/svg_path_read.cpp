#include <cmath>
#include <optional>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/svg_path.hpp"
#include "io/exchange/svg_pieces.hpp"
#include "io/tables/utf8.hpp"

namespace batten {
namespace {

using path_data::Piece;
using path_data::Point;

constexpr std::string_view blanks = " \t\r\n\f";

bool is_digit(char c) { return '0' <= c && c <= '9'; }
char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// How many numbers a command takes; nothing where there is no such command.
std::optional<std::size_t> arguments_of(char command) {
    constexpr std::string_view commands = "MLTHVCSQAZ";
    constexpr std::size_t counts[] = {2, 2, 2, 1, 1, 6, 4, 4, 7, 0};
    const std::size_t place = commands.find(upper(command));
    if (command == '\0' || place == std::string_view::npos) return std::nullopt;
    return counts[place];
}

class PathReader {
public:
    PathReader(std::string_view data, const std::string& place) : data_(data), place_(place) {}

    Curve read() {
        skip_blanks();
        if (upper(next()) != 'M') fail("path data start with M or m");
        while (at_ < data_.size()) {
            segment();
            skip_blanks();
        }
        if (pieces_.empty()) fail("a segment is needed here");
        using path_data::Ends;
        return path_data::joined(pieces_, has_ended_ ? Ends::closed : Ends::open);
    }

private:
    /// One command letter and its numbers, or the numbers alone where the last letter goes on.
    void segment() {
        start_ = at_;
        if (arguments_of(next())) {
            command_ = data_[at_++];
            skip_blanks();
        } else if (upper(command_) == 'Z' || !starts_number()) {
            fail(upper(command_) == 'Z' ? "a command letter is needed here"
                                        : "a command letter or a number is needed here");
        }
        if ((has_ended_ && upper(command_) != 'Z') || (!pieces_.empty() && upper(command_) == 'M')) {
            throw Error("svg.subpaths", place(start_), utf8::shown(data_[start_]),
                        "one curve is one path without a second part");
        }
        if (upper(command_) == 'Z') return close();
        const std::size_t count = *arguments_of(command_);
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_flag = upper(command_) == 'A' && (i == 3 || i == 4);
            numbers_[i] = is_flag ? flag() : number();
            separator();
        }
        draw();
        // Further pairs after a move are lines.
        if (command_ == 'M') command_ = 'L';
        if (command_ == 'm') command_ = 'l';
    }

    void draw() {
        const std::size_t size = pieces_.size();
        const Point from = current_;
        std::optional<Point> smooth_cubic, smooth_quadratic;
        switch (upper(command_)) {
            case 'M': current_ = first_ = point(0); break;
            case 'L': add({1, {from, point(0)}}); break;
            case 'H': add({1, {from, {numbers_[0] + base().x, from.y}}}); break;
            case 'V': add({1, {from, {from.x, numbers_[0] + base().y}}}); break;
            case 'C':
                smooth_cubic = point(2);
                add({3, {from, point(0), point(2), point(4)}});
                break;
            case 'S':
                smooth_cubic = point(0);
                add({3, {from, mirrored(cubic_handle_), point(0), point(2)}});
                break;
            case 'Q':
                smooth_quadratic = point(0);
                add({2, {from, point(0), point(2)}});
                break;
            case 'T':
                smooth_quadratic = mirrored(quadratic_handle_);
                add({2, {from, *smooth_quadratic, point(0)}});
                break;
            default: add_arc();
        }
        cubic_handle_ = smooth_cubic;
        quadratic_handle_ = smooth_quadratic;
        for (std::size_t i = size; i < pieces_.size(); ++i) require_finite(pieces_[i]);
        require_finite({1, {current_, current_}});
    }

    void add(const Piece& piece) {
        current_ = piece.end();
        if (!piece.is_point()) pieces_.push_back(piece);
    }

    void add_arc() {
        const Point end = point(5);
        path_data::append_arc(pieces_, {current_, {numbers_[0], numbers_[1]}, numbers_[2],
                                  numbers_[3] != 0, numbers_[4] != 0, end});
        current_ = end;
    }

    void close() {
        if (!(current_ == first_)) add({1, {current_, first_}});
        has_ended_ = true;
    }

    /// Two numbers of the command as a point; relative for small letters.
    Point point(std::size_t i) const { return base() + Point{numbers_[i], numbers_[i + 1]}; }
    Point base() const { return command_ == upper(command_) ? Point{} : current_; }
    Point mirrored(std::optional<Point> handle) const {
        return handle ? current_ + (current_ - *handle) : current_;
    }

    void require_finite(const Piece& piece) const {
        for (const Point p : piece.points) {
            if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
            throw Error("number.overflow", place(start_), "beyond a double",
                        "numbers must lie within the range of a double");
        }
    }

    bool starts_number() const {
        return is_digit(next()) || next() == '+' || next() == '-' || next() == '.';
    }

    double number() {
        const std::size_t start = at_;
        std::size_t count = 0;
        if (next() == '+' || next() == '-') ++at_;
        count += digits();
        if (next() == '.') {
            ++at_;
            count += digits();
        }
        if (count == 0) fail("a number is needed here");
        const std::size_t end = at_;
        if (next() == 'e' || next() == 'E') {
            ++at_;
            if (next() == '+' || next() == '-') ++at_;
            if (digits() == 0) at_ = end;
        }
        const std::string_view spelling = data_.substr(start, at_ - start);
        const double x = parse_number(spelling).value_or(0);
        if (std::isfinite(x)) return x;
        throw Error("number.overflow", place(start), std::string(spelling.substr(0, 40)),
                    "numbers must lie within the range of a double");
    }

    double flag() {
        if (next() != '0' && next() != '1') fail("a flag, 0 or 1, is needed here");
        return data_[at_++] - '0';
    }

    std::size_t digits() {
        const std::size_t start = at_;
        while (is_digit(next())) ++at_;
        return at_ - start;
    }

    void skip_blanks() {
        while (at_ < data_.size() && blanks.find(data_[at_]) != std::string_view::npos) ++at_;
    }
    /// Blanks with at most one comma among them, which a number must follow.
    void separator() {
        skip_blanks();
        if (next() != ',') return;
        ++at_;
        skip_blanks();
        if (!starts_number()) fail("a number is needed after a comma");
    }

    /// The next character; a zero byte, which no rule accepts, at the end.
    char next() const { return at_ < data_.size() ? data_[at_] : '\0'; }

    std::string place(std::size_t at) const {
        return place_ + " path character " + std::to_string(at + 1);
    }
    [[noreturn]] void fail(std::string rule) const {
        throw Error("svg.path", place(at_),
                    at_ < data_.size() ? utf8::shown(data_[at_]) : "end of data",
                    std::move(rule));
    }

    std::string_view data_;
    const std::string& place_;
    std::size_t at_ = 0;
    std::size_t start_ = 0;  ///< of the segment being read
    char command_ = 'Z';
    double numbers_[7] = {};
    Point first_, current_;
    std::optional<Point> cubic_handle_, quadratic_handle_;
    std::vector<Piece> pieces_;
    bool has_ended_ = false;
};

}  // namespace

Curve parse_svg_path(std::string_view data, const std::string& place) {
    return PathReader(data, place).read();
}

}  // namespace batten
