
#include "batten/base/error.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/grid_stream.hpp"
#include "errors.hpp"
#include "surface_samples.hpp"

/// Grids read in blocks are those read whole.
namespace batten {
namespace grid_stream_test {

using namespace testing;

GridStream streamed(const std::string& name, const std::string& bytes) {
    return GridStream(StoredBytes(Source{name, bytes}));
}

void expect_same(GridStream stream, const GridFile& whole) {
    EXPECT_EQ(stream.x(), whole.x);
    EXPECT_EQ(stream.y(), whole.y);
    const std::span<const double> want = whole.z.view().values();
    const std::size_t rows = whole.x.size(), columns = whole.y.size();
    for (const std::size_t size : {1, 3}) {
        for (std::size_t first = 0; first < rows; first += size) {
            std::vector<double> z(std::min(size, rows - first) * columns);
            stream.read(first, z);
            for (std::size_t k = 0; k < z.size(); ++k) {
                if (whole.z.view().has(first + k / columns, k % columns)) {
                    EXPECT_EQ(z[k], want[first * columns + k]);
                } else {
                    EXPECT_TRUE(std::isnan(z[k]));
                }
            }
        }
    }
}

TEST(GridStream, IsTheGridReadWhole) {
    SurfaceTable table = surface_of([](double x, double y) { return x - 3 * y; }, 11, 7, 1);
    table.z.drop(4, 5);
    const std::string csv = csv_grid(table.x, table.y, table.z);
    expect_same(streamed("g.csv", csv), parse_grid({"g.csv", csv}));
    const std::string npy = npy_grid(table.z);
    expect_same(streamed("g.npy", npy), parse_grid({"g.npy", npy}));
    std::string returns = "\xef\xbb\xbf# remark\r\n\r\n";
    for (const char c : csv) returns += c == '\n' ? "\r\n" : std::string(1, c);
    expect_same(streamed("g.csv", returns), parse_grid({"g.csv", returns}));
    std::string old = csv;
    std::replace(old.begin(), old.end(), '\n', '\r');
    expect_same(streamed("g.csv", old), parse_grid({"g.csv", old}));
    const std::string quoted = "corner;\"3\";2;1\n\"1\";4;5;6\n 0;7;8;9";
    expect_same(streamed("g.txt", quoted), parse_grid({"g.txt", quoted}));
    const std::string blanks = "c  1 2 3\n  1\t4 5 6\n 3 7 8 9\n";
    expect_same(streamed("g.txt", blanks), parse_grid({"g.txt", blanks}));
}

/// A NumPy array in Fortran order, of bytes.
std::string by_columns(std::size_t rows, std::size_t columns, const std::string& numbers) {
    std::string header = "{'descr': '|u1', 'fortran_order': True, 'shape': (" +
                         std::to_string(rows) + ", " + std::to_string(columns) + "), }";
    header.append(117 - header.size(), ' ');
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(118) + '\0' + header + '\n' +
           numbers;
}

TEST(GridStream, ReadsColumnsOfFortranOrder) {
    const std::string small = by_columns(3, 9, "abcdefghijklmnopqrstuvwxyz0");
    expect_same(streamed("g.npy", small), parse_grid({"g.npy", small}));
    // Rows are held up to 64 MB: these are two such bands.
    constexpr std::size_t rows = 30, columns = 300'000;
    std::string numbers;
    for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < rows; ++i) numbers += static_cast<char>((7 * i + 3 * j) % 251);
    }
    GridStream stream = streamed("g.npy", by_columns(rows, columns, numbers));
    std::vector<double> z(columns);
    for (const std::size_t row : {0, 26, 27, 28, 29, 3}) {
        stream.read(row, z);
        for (std::size_t j = 0; j < columns; j += 999) {
            ASSERT_EQ(z[j], static_cast<double>((7 * row + 3 * j) % 251));
        }
    }
}

TEST(GridStream, ReadsNumbersOfEveryType) {
    // Three rows of two numbers of two bytes, big-endian and signed.
    std::string header = "{'descr': '>i2', 'fortran_order': False, 'shape': (3, 2), }";
    header.append(63 - (10 + header.size()) % 64, ' ');
    header += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size());
    bytes += '\0';
    bytes += header + std::string("\0\1\0\2\xff\xff\1\0\0\5\0\6", 12);
    expect_same(streamed("g.npy", bytes), parse_grid({"g.npy", bytes}));
    std::vector<double> z(2);
    GridStream stream = streamed("g.npy", bytes);
    stream.read(1, z);
    EXPECT_EQ(z, (std::vector<double>{-1, 256}));
}

/// Lines longer than the blocks that are looked through for their ends.
TEST(GridStream, ReadsLinesOfAnyLengthFromAFile) {
    const SurfaceTable table = surface_of([](double x, double y) { return x / (y + 1); }, 3, 60'000);
    const std::string csv = csv_grid(table.x, table.y, table.z);
    ASSERT_GT(csv.size(), std::size_t{3} << 20);
    const std::string path = scratch_file("long_lines.csv");
    write_file(path, csv);
    expect_same(GridStream(StoredBytes(path)), parse_grid({"g.csv", csv}));
}

}  // namespace grid_stream_test
}  // namespace batten
