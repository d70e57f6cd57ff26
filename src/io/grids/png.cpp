#include "io/grids/readers.hpp"

#if BATTEN_READS_PNG

#include <png.h>

#include <csetjmp>
#include <cstring>

namespace batten::grids {
namespace {

/// libpng's two structures, and the bytes it has not read yet.
class PngReader {
public:
    explicit PngReader(std::string_view bytes) : bytes_(bytes) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::warn);
        if (png) info = png_create_info_struct(png);
        if (!info) throw std::bad_alloc();
        png_set_read_fn(png, this, &PngReader::next);
        png_set_user_limits(png, most_side, most_side);
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    png_structp png = nullptr;
    png_infop info = nullptr;
    std::jmp_buf back;
    char trouble[80] = "";

private:
    static constexpr png_uint_32 most_side = 0x7fffffff;

    static void fail(png_structp png, const char* text) {
        auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
        std::strncpy(reader->trouble, text, sizeof reader->trouble - 1);
        std::longjmp(reader->back, 1);
    }
    static void warn(png_structp, const char*) {}
    static void next(png_structp png, png_bytep out, std::size_t count) {
        auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > reader->bytes_.size()) png_error(png, "the picture is cut short");
        std::memcpy(out, reader->bytes_.data(), count);
        reader->bytes_.remove_prefix(count);
    }

    std::string_view bytes_;
};

// libpng jumps back on trouble: the two functions that call it hold nothing that needs destroying.

/// Everything before the pixels, and how they are wanted: samples of one or two bytes, grey or
/// three colours, no transparency, numbers as they stand.
bool read_header(PngReader& reader) {
    if (setjmp(reader.back) != 0) return false;
    png_read_info(reader.png, reader.info);
    if (png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE) {
        png_set_palette_to_rgb(reader.png);
    }
    png_set_packing(reader.png);
    png_set_strip_alpha(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_pixels(PngReader& reader, png_bytepp rows) {
    if (setjmp(reader.back) != 0) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

/// Luma of a colour, by the weights of ITU-R BT.709; equal ones are that grey exactly.
double grey_of(double red, double green, double blue) {
    if (red == green && green == blue) return red;
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

std::vector<double> greys(const std::vector<unsigned char>& bytes, std::size_t count, int channels,
                          int depth) {
    const auto sample = [&](std::size_t i) -> double {
        return depth == 16 ? bytes[2 * i] << 8 | bytes[2 * i + 1] : bytes[i];
    };
    std::vector<double> grey(count);
    for (std::size_t i = 0; i < count; ++i) {
        grey[i] = channels == 1 ? sample(i)
                                : grey_of(sample(3 * i), sample(3 * i + 1), sample(3 * i + 2));
    }
    return grey;
}

}  // namespace

GridFile read_png(std::string_view bytes, const std::string& source) {
    const auto refuse = [&](std::string value) {
        return not_a_picture(source, std::move(value), "this is no whole PNG");
    };
    if (bytes.substr(0, 8) != std::string_view("\x89PNG\r\n\x1a\n", 8)) {
        throw refuse("other first bytes");
    }
    PngReader reader(bytes);
    if (!read_header(reader)) throw refuse(reader.trouble);
    const std::size_t width = png_get_image_width(reader.png, reader.info);
    const std::size_t height = png_get_image_height(reader.png, reader.info);
    if (width > most_pixels / height) {
        throw refuse(std::to_string(width) + " x " + std::to_string(height) + " pixels");
    }
    const std::size_t stride = png_get_rowbytes(reader.png, reader.info);
    std::vector<unsigned char> pixels(stride * height);
    std::vector<png_bytep> rows(height);
    for (std::size_t j = 0; j < height; ++j) rows[j] = pixels.data() + j * stride;
    if (!read_pixels(reader, rows.data())) throw refuse(reader.trouble);
    return picture_grid(greys(pixels, width * height,
                              png_get_channels(reader.png, reader.info),
                              png_get_bit_depth(reader.png, reader.info)),
                        width, source);
}

}  // namespace batten::grids

#else

namespace batten::grids {

GridFile read_png(std::string_view, const std::string& source) {
    throw not_a_picture(source, "a PNG", "this build of Batten reads no PNG: convert it to PGM");
}

}  // namespace batten::grids

#endif
