#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/tables/npy_grid.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::tables {
namespace {

/// Reads the header, a literal of Python: {'descr': '<f8', 'fortran_order': False, 'shape': (3, 2)}
class HeaderReader {
public:
    HeaderReader(std::string_view text, const std::string& source) : rest_(text), source_(source) {}

    NpyHeader read() {
        NpyHeader header;
        bool has_type = false, has_order = false, has_shape = false;
        need('{');
        while (!take('}')) {
            const std::string_view key = quoted();
            need(':');
            if (key == "descr") {
                type(header);
                has_type = true;
            } else if (key == "fortran_order") {
                header.is_fortran = truth();
                has_order = true;
            } else if (key == "shape") {
                header.shape = shape();
                has_shape = true;
            } else {
                fail(key);
            }
            if (!take(',')) {
                need('}');
                break;
            }
        }
        if (!has_type || !has_order || !has_shape) fail("an entry is missing");
        return header;
    }

private:
    void type(NpyHeader& header) {
        const std::string_view start = trimmed(rest_);
        const std::string_view name = !start.empty() && start[0] == '[' ? start : quoted();
        const std::optional<long long> width =
            name.size() == 3 ? parse_integer(name.substr(2)) : std::nullopt;
        const bool is_float = width && name[1] == 'f' && (*width == 4 || *width == 8);
        const bool is_integer = width && (name[1] == 'i' || name[1] == 'u') &&
                                (*width == 1 || *width == 2 || *width == 4 || *width == 8);
        if ((!is_float && !is_integer) || std::string_view("<>|=").find(name[0]) == name.npos) {
            throw Error("npy.type", source_, utf8::shown(name),
                        "floats of 4 or 8 bytes and integers are read");
        }
        header.kind = name[1];
        header.width = static_cast<std::size_t>(*width);
        header.is_big_endian = name[0] == '>';
    }

    bool truth() {
        for (const std::string_view word : {"True", "False"}) {
            rest_ = trimmed(rest_);
            if (rest_.substr(0, word.size()) == word) {
                rest_.remove_prefix(word.size());
                return word == "True";
            }
        }
        fail(rest_);
    }

    std::vector<std::size_t> shape() {
        std::vector<std::size_t> sizes;
        need('(');
        while (!take(')')) {
            rest_ = trimmed(rest_);
            const std::size_t end = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
            const std::optional<long long> size = parse_integer(rest_.substr(0, end));
            if (!size || sizes.size() == 32) fail(rest_);
            sizes.push_back(static_cast<std::size_t>(*size));
            rest_.remove_prefix(end);
            if (!take(',')) {
                need(')');
                break;
            }
        }
        return sizes;
    }

    std::string_view quoted() {
        rest_ = trimmed(rest_);
        const char quote = rest_.empty() ? '\0' : rest_[0];
        const std::size_t end = rest_.find(quote, 1);
        if ((quote != '\'' && quote != '"') || end == std::string_view::npos) fail(rest_);
        const std::string_view text = rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        return text;
    }

    bool take(char c) {
        rest_ = trimmed(rest_);
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    void need(char c) {
        if (!take(c)) fail(rest_);
    }
    [[noreturn]] void fail(std::string_view value) const {
        throw Error("npy.header", source_,
                    value.empty() ? "end of header" : utf8::shown(value),
                    "the header must tell descr, fortran_order and shape, and nothing else");
    }

    std::string_view rest_;
    const std::string& source_;
};

}  // namespace

NpyHeader read_npy_header(std::string_view bytes, const std::string& source) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
    };
    const auto fail = [&](const std::string& value, const char* rule) {
        return Error("npy.header", source, value, rule);
    };
    if (bytes.substr(0, 6) != "\x93NUMPY") {
        throw fail("other first bytes", "a NumPy file starts with \\x93NUMPY");
    }
    if (bytes.size() < 12) throw fail("end of file", "the header is cut short");
    if (byte(6) < 1 || byte(6) > 3) {
        throw fail("version " + std::to_string(byte(6)), "versions 1, 2 and 3 are read");
    }
    const bool is_long = byte(6) > 1;
    const std::size_t start = is_long ? 12 : 10;
    std::size_t size = byte(8) | byte(9) << 8;
    if (is_long) size |= byte(10) << 16 | byte(11) << 24;
    if (size > bytes.size() - start) throw fail("end of file", "the header is cut short");
    NpyHeader header = HeaderReader(bytes.substr(start, size), source).read();
    header.end = start + size;
    return header;
}

namespace {

double number_at(const char* bytes, const NpyHeader& header) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < header.width; ++i) {
        const std::size_t from = header.is_big_endian ? i : header.width - 1 - i;
        bits = bits << 8 | static_cast<unsigned char>(bytes[from]);
    }
    if (header.kind == 'u') return static_cast<double>(bits);
    if (header.kind == 'i') {
        const unsigned unused = static_cast<unsigned>(64 - 8 * header.width);
        return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }
    if (header.width == 4) {
        const std::uint32_t half = static_cast<std::uint32_t>(bits);
        float x = 0;
        std::memcpy(&x, &half, sizeof x);
        return x;
    }
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

/// Throws unless so many bytes hold rows x columns numbers; divides, so that nothing overflows.
void require_numbers(const NpyHeader& header, std::uint64_t bytes, std::size_t rows,
                     std::size_t columns, const std::string& source) {
    if (rows <= bytes / header.width / columns) return;
    throw Error("npy.truncated", source, std::to_string(bytes) + " bytes",
                std::to_string(rows) + " x " + std::to_string(columns) + " numbers of " +
                    std::to_string(header.width) + " bytes are declared");
}

}  // namespace

Table read_npy(std::string_view bytes, const std::string& source) {
    const NpyHeader header = read_npy_header(bytes, source);
    const std::string_view body = bytes.substr(header.end);
    const std::vector<std::size_t>& shape = header.shape;
    const bool is_table = shape.size() == 1 || (shape.size() == 2 && shape[1] <= most_columns);
    if (!is_table) {
        std::string text;
        for (const std::size_t size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
        throw Error("npy.shape", source, text.empty() ? "a single value" : text,
                    "an array of one or two dimensions, at most " + std::to_string(most_columns) +
                        " columns, is needed");
    }
    const std::size_t rows = shape[0];
    const std::size_t columns = shape.size() == 2 ? shape[1] : 1;
    if (rows == 0 || columns == 0) throw no_rows(source);
    require_numbers(header, body.size(), rows, columns, source);
    Table table;
    table.source = source;
    table.bad.resize(columns);
    table.cells = Points(rows, static_cast<int>(columns));
    for (std::size_t i = 0; i < rows; ++i) {
        table.line_of_row.push_back(static_cast<int>(i) + 1);
        for (std::size_t k = 0; k < columns; ++k) {
            const std::size_t place = header.is_fortran ? k * rows + i : i * columns + k;
            const double x = number_at(body.data() + place * header.width, header);
            table.cells(i, static_cast<int>(k)) =
                std::isfinite(x) ? x : table.mark_bad(k, x, {i, format_number(x)});
        }
    }
    return table;
}

void require_npy_grid(const NpyHeader& header, std::uint64_t bytes, const std::string& source) {
    const std::vector<std::size_t>& shape = header.shape;
    if (shape.size() != 2 || shape[0] == 0 || shape[1] == 0) {
        throw Error("npy.shape", source,
                    std::to_string(shape.size()) +
                        (shape.size() == 1 ? " dimension" : " dimensions"),
                    "a grid is an array of two dimensions that holds something");
    }
    require_numbers(header, bytes, shape[0], shape[1], source);
}

NpyHeader stored_npy_grid(StoredBytes& bytes) {
    // As much as version 1 can declare.
    constexpr std::size_t most_header = (std::size_t{1} << 16) + 12;
    std::string head(most_header, '\0');
    head.resize(bytes.read(0, head));
    NpyHeader header = read_npy_header(head, bytes.name());
    require_npy_grid(header, bytes.size() - header.end, bytes.name());
    return header;
}

void npy_numbers(const NpyHeader& header, const char* bytes, std::span<double> out) {
    const bool is_native = header.kind == 'f' && header.width == sizeof(double) &&
                           header.is_big_endian == (std::endian::native == std::endian::big);
    if (is_native) {
        std::memcpy(out.data(), bytes, out.size_bytes());
        return;
    }
    for (double& x : out) {
        x = number_at(bytes, header);
        bytes += header.width;
    }
}

NpyGrid read_npy_grid(std::string_view bytes, const std::string& source) {
    const NpyHeader header = read_npy_header(bytes, source);
    require_npy_grid(header, bytes.size() - header.end, source);
    const std::size_t rows = header.shape[0], columns = header.shape[1];
    NpyGrid grid{rows, columns, std::vector<double>(rows * columns)};
    if (!header.is_fortran) {
        npy_numbers(header, bytes.data() + header.end, grid.values);
        return grid;
    }
    std::vector<double> line(rows);
    for (std::size_t k = 0; k < columns; ++k) {
        npy_numbers(header, bytes.data() + header.end + k * rows * header.width, line);
        for (std::size_t i = 0; i < rows; ++i) grid.values[i * columns + k] = line[i];
    }
    return grid;
}

}  // namespace batten::tables
