#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "batten/io/grid_file.hpp"
#include "batten/io/grid_stream.hpp"
#include "promises.hpp"

namespace {

/// What is read in blocks is what is read whole; forms that are not read in blocks are refused.
void check_stream(const batten::Source& source, const batten::GridFile& whole) {
    using namespace batten;
    try {
        GridStream stream{StoredBytes(source)};
        std::vector<double> z(whole.y.size());
        fuzz::require(stream.x() == whole.x && stream.y() == whole.y);
        for (std::size_t i = 0; i < whole.x.size(); ++i) {
            stream.read(i, z);
            for (std::size_t j = 0; j < z.size(); ++j) {
                fuzz::require(whole.z.view().has(i, j) ? z[j] == whole.z(i, j) : std::isnan(z[j]));
            }
        }
    } catch (const Error& error) {
        fuzz::check_error(error);
        fuzz::require(error.code() == "grid.streamed");
    }
}

}  // namespace

/// The first byte chooses the format, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    if (size == 0) return 0;
    constexpr GridFormat formats[] = {GridFormat::text, GridFormat::npy, GridFormat::pgm,
                                      GridFormat::png};
    const Source source{"input", std::string(reinterpret_cast<const char*>(data) + 1, size - 1)};
    try {
        grid_format(source);
        const GridFile file = parse_grid(source, formats[data[0] % 4]);
        fuzz::require(file.x.size() >= 2 && file.y.size() >= 2);
        fuzz::require(file.z.nu() == file.x.size() && file.z.nv() == file.y.size());
        fuzz::require(file.sigma.empty() || file.sigma.size() == file.x.size() * file.y.size());
        for (const double z : file.z.view().values()) fuzz::require(std::isfinite(z));
        for (std::size_t i = 1; i < file.x.size(); ++i) fuzz::require(file.x[i - 1] < file.x[i]);
        for (std::size_t j = 1; j < file.y.size(); ++j) fuzz::require(file.y[j - 1] < file.y[j]);
        if (grid_format(source) == formats[data[0] % 4]) check_stream(source, file);
        const GridFile copy = parse_grid({"copy.csv", csv_grid(file.x, file.y, file.z)});
        fuzz::require(copy.x == file.x && copy.y == file.y);
    } catch (const Error& error) {
        fuzz::check_error(error);
    }
    return 0;
}
