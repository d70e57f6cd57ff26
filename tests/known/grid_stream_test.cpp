
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
            EXPECT_TRUE(std::equal(z.begin(), z.end(), want.begin() + first * columns));
        }
    }
}

TEST(GridStream, IsTheGridReadWhole) {
    const SurfaceTable table = surface_of([](double x, double y) { return x - 3 * y; }, 11, 7, 1);
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
