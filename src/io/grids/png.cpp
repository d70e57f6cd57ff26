#include <algorithm>
#include <cstdlib>

#include "io/grids/readers.hpp"

namespace batten::grids {
namespace {

/// What a PNG declares [PNG, 11.2.2], its palette as greys, its packed pixels.
struct Png {
    std::size_t width = 0, height = 0;
    int depth = 8, colour = 0;
    std::vector<double> palette;
    std::string packed;

    int channels() const {
        return colour == 2 ? 3 : colour == 4 ? 2 : colour == 6 ? 4 : 1;
    }
};

std::size_t whole(std::string_view bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// Luma of a colour, by the weights of ITU-R BT.709.
double grey_of(double red, double green, double blue) {
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

void read_header(Png& png, std::string_view chunk, const std::string& source) {
    if (chunk.size() != 13) throw not_a_picture(source, "a short header", "this is no PNG");
    png.width = whole(chunk, 0);
    png.height = whole(chunk, 4);
    png.depth = static_cast<unsigned char>(chunk[8]);
    png.colour = static_cast<unsigned char>(chunk[9]);
    const bool is_known = png.colour == 0 || png.colour == 2 || png.colour == 3 ||
                          png.colour == 4 || png.colour == 6;
    const bool is_small = png.depth == 1 || png.depth == 2 || png.depth == 4;
    const bool has_depth = png.depth == 8 || (png.depth == 16 && png.colour != 3) ||
                           (is_small && (png.colour == 0 || png.colour == 3));
    if (!is_known || !has_depth || chunk[12] != 0) {
        throw not_a_picture(source, "another kind of PNG",
                            "grey, colour and palette pictures that are not interlaced are read");
    }
    if (png.width == 0 || png.height == 0 || png.width > most_pixels / png.height) {
        throw not_a_picture(source,
                            std::to_string(png.width) + " x " + std::to_string(png.height),
                            "a picture has pixels, and not too many");
    }
}

Png read_chunks(std::string_view bytes, const std::string& source) {
    Png png;
    std::size_t at = 8;
    while (true) {
        if (at + 12 > bytes.size() || whole(bytes, at) > bytes.size() - at - 12) {
            throw not_a_picture(source, "end of file", "the picture is cut short");
        }
        const std::size_t size = whole(bytes, at);
        const std::string_view kind = bytes.substr(at + 4, 4), chunk = bytes.substr(at + 8, size);
        if (kind == "IHDR") read_header(png, chunk, source);
        if (kind == "IDAT") png.packed += chunk;
        for (std::size_t i = 0; kind == "PLTE" && i + 3 <= size; i += 3) {
            const auto byte = [&](std::size_t k) {
                return static_cast<double>(static_cast<unsigned char>(chunk[i + k]));
            };
            png.palette.push_back(grey_of(byte(0), byte(1), byte(2)));
        }
        if (kind == "IEND") break;
        at += size + 12;
    }
    if (png.width == 0) throw not_a_picture(source, "no header", "this is no PNG");
    return png;
}

int paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int a = std::abs(guess - left), b = std::abs(guess - up), c = std::abs(guess - corner);
    return a <= b && a <= c ? left : b <= c ? up : corner;
}

/// Takes the filters off, in place [PNG, 9.2].
void unfilter(std::string& rows, std::size_t stride, std::size_t pixel, const std::string& source) {
    const auto at = [&](std::size_t row, std::size_t i) -> int {
        return static_cast<unsigned char>(rows[row * (stride + 1) + 1 + i]);
    };
    for (std::size_t row = 0; row * (stride + 1) < rows.size(); ++row) {
        const unsigned char filter = static_cast<unsigned char>(rows[row * (stride + 1)]);
        if (filter > 4) throw not_a_picture(source, "no such filter", "the pixels are damaged");
        for (std::size_t i = 0; i < stride; ++i) {
            const int left = i >= pixel ? at(row, i - pixel) : 0;
            const int up = row > 0 ? at(row - 1, i) : 0;
            const int corner = row > 0 && i >= pixel ? at(row - 1, i - pixel) : 0;
            const int guess = filter == 1   ? left
                              : filter == 2 ? up
                              : filter == 3 ? (left + up) / 2
                              : filter == 4 ? paeth(left, up, corner)
                                            : 0;
            rows[row * (stride + 1) + 1 + i] = static_cast<char>(at(row, i) + guess);
        }
    }
}

unsigned sample_at(std::string_view row, std::size_t index, int depth) {
    if (depth == 16) {
        return static_cast<unsigned>(static_cast<unsigned char>(row[2 * index]) << 8 |
                                     static_cast<unsigned char>(row[2 * index + 1]));
    }
    const std::size_t bit = index * static_cast<std::size_t>(depth);
    const unsigned byte = static_cast<unsigned char>(row[bit / 8]);
    const unsigned shift = static_cast<unsigned>(8 - depth) - static_cast<unsigned>(bit % 8);
    return byte >> shift & ((1u << depth) - 1);
}

double pixel_at(const Png& png, std::string_view row, std::size_t i, const std::string& source) {
    const std::size_t first = i * static_cast<std::size_t>(png.channels());
    const auto sample = [&](std::size_t k) { return sample_at(row, first + k, png.depth); };
    if (png.colour == 3) {
        if (sample(0) >= png.palette.size()) {
            throw not_a_picture(source, "colour " + std::to_string(sample(0)),
                                "colours must stand in the palette");
        }
        return png.palette[sample(0)];
    }
    if (png.channels() < 3) return sample(0);
    if (sample(0) == sample(1) && sample(1) == sample(2)) return sample(0);
    return grey_of(sample(0), sample(1), sample(2));
}

}  // namespace

GridFile read_png(std::string_view bytes, const std::string& source) {
    if (bytes.substr(0, 8) != std::string_view("\x89PNG\r\n\x1a\n", 8)) {
        throw not_a_picture(source, "other first bytes", "this is no PNG");
    }
    const Png png = read_chunks(bytes, source);
    const std::size_t bits = static_cast<std::size_t>(png.channels() * png.depth);
    const std::size_t stride = (png.width * bits + 7) / 8;
    const std::size_t size = png.height * (stride + 1);
    std::string rows = unpack(png.packed, size, source);
    if (rows.size() < size) throw not_a_picture(source, "end of data", "the picture is cut short");
    unfilter(rows, stride, std::max<std::size_t>(1, bits / 8), source);
    std::vector<double> grey;
    grey.reserve(png.width * png.height);
    for (std::size_t j = 0; j < png.height; ++j) {
        const std::string_view row = std::string_view(rows).substr(j * (stride + 1) + 1, stride);
        for (std::size_t i = 0; i < png.width; ++i) {
            grey.push_back(pixel_at(png, row, i, source));
        }
    }
    return picture_grid(std::move(grey), png.width, source);
}

}  // namespace batten::grids
