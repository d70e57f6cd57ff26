#include <algorithm>
#include <optional>

#include "batten/base/text.hpp"
#include "io/grids/readers.hpp"

namespace batten::grids {
namespace {

/// The header of a PGM: words, with remarks from `#` to the end of the line [NetpbmPGM].
class PgmHeader {
public:
    PgmHeader(std::string_view bytes, const std::string& source) : bytes_(bytes), source_(source) {}

    std::size_t number(const char* what, std::size_t most) {
        const std::string_view word = next();
        const std::optional<long long> value = parse_integer(word);
        if (!value || *value < 1 || static_cast<unsigned long long>(*value) > most) {
            throw not_a_picture(source_, word.empty() ? "end of file" : "another " + std::string(what),
                                "the header must tell width, height and the largest grey");
        }
        return static_cast<std::size_t>(*value);
    }
    std::string_view next() {
        while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
            if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
            ++at_;
        }
        const std::size_t start = at_;
        while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
        return bytes_.substr(start, at_ - start);
    }
    /// What follows the one blank behind the header.
    std::string_view body() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

    std::string_view bytes_;
    const std::string& source_;
    std::size_t at_ = 0;
};

}  // namespace

GridFile picture_grid(std::vector<double> grey, std::size_t width, const std::string& source) {
    const std::size_t height = grey.size() / width;
    GridFile file;
    file.source = source;
    for (std::size_t i = 0; i < width; ++i) file.x.push_back(static_cast<double>(i));
    for (std::size_t j = 0; j < height; ++j) file.y.push_back(static_cast<double>(j));
    file.z = Grid(width, height);
    for (std::size_t i = 0; i < width; ++i) {
        for (std::size_t j = 0; j < height; ++j) {
            file.z(i, j) = grey[(height - 1 - j) * width + i];
        }
    }
    return file;
}

GridFile read_pgm(std::string_view bytes, const std::string& source) {
    PgmHeader header(bytes, source);
    const std::string_view magic = header.next();
    if (magic != "P2" && magic != "P5") {
        throw not_a_picture(source, "other first bytes", "a PGM starts with P2 or P5");
    }
    const std::size_t width = header.number("width", most_pixels);
    const std::size_t height = header.number("height", most_pixels / width);
    const std::size_t largest = header.number("largest grey", 65535);
    std::vector<double> grey;
    if (magic == "P2") {
        if (width * height > header.body().size()) {
            throw not_a_picture(source, "end of file", "the picture is cut short");
        }
        for (std::size_t k = 0; k < width * height; ++k) {
            const std::optional<long long> value = parse_integer(header.next());
            if (!value || *value < 0 || static_cast<std::size_t>(*value) > largest) {
                throw not_a_picture(source, "pixel " + std::to_string(k),
                                    "greys are whole numbers up to the largest one");
            }
            grey.push_back(static_cast<double>(*value));
        }
        return picture_grid(std::move(grey), width, source);
    }
    const std::string_view body = header.body();
    const std::size_t bytes_each = largest > 255 ? 2 : 1;
    if (body.size() / bytes_each / width < height) {
        throw not_a_picture(source, "end of file", "the picture is cut short");
    }
    for (std::size_t k = 0; k < width * height; ++k) {
        unsigned value = 0;
        for (std::size_t b = 0; b < bytes_each; ++b) {
            value = value << 8 | static_cast<unsigned char>(body[k * bytes_each + b]);
        }
        grey.push_back(value);
    }
    return picture_grid(std::move(grey), width, source);
}

}  // namespace batten::grids
