#include "batten/io/grid_stream.hpp"

#include "batten/base/error.hpp"
#include "batten/io/grid_file.hpp"
#include "io/grids/stored_rows.hpp"

namespace batten {
namespace grids {

Error not_streamed(const std::string& source, std::string value) {
    return {"grid.streamed", source, std::move(value),
            "only .npy and tables (y in the first row, x in the first column) are read in blocks: "
            "write the grid as one of these, with numpy.save for example, or read it whole"};
}

}  // namespace grids

namespace {

std::unique_ptr<grids::StoredRows> rows_in(StoredBytes bytes) {
    switch (grid_format(bytes.head("the file must hold a grid"))) {
        case GridFormat::npy: return grids::npy_rows(std::move(bytes));
        case GridFormat::text: return grids::text_rows(std::move(bytes));
        default: throw grids::not_streamed(bytes.name(), "a picture or a raster");
    }
}

}  // namespace

GridStream::GridStream(StoredBytes bytes) : rows_(rows_in(std::move(bytes))) {
    if (x().size() >= 2 && y().size() >= 2) return;
    throw Error("grid.too-small", name(),
                std::to_string(x().size()) + " x " + std::to_string(y().size()),
                "a grid has at least two lines in each direction");
}

GridStream::~GridStream() = default;
GridStream::GridStream(GridStream&&) noexcept = default;
GridStream& GridStream::operator=(GridStream&&) noexcept = default;

const std::string& GridStream::name() const { return rows_->bytes.name(); }
const std::vector<double>& GridStream::x() const { return rows_->x; }
const std::vector<double>& GridStream::y() const { return rows_->y; }
bool GridStream::x_is_turned() const { return rows_->x_is_turned; }
bool GridStream::y_is_turned() const { return rows_->y_is_turned; }
void GridStream::read(std::size_t first, std::span<double> z) { rows_->read(first, z); }

}  // namespace batten
