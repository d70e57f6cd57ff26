#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "io/grids/stored_rows.hpp"
#include "io/tables/npy_grid.hpp"

namespace batten::grids {
namespace {

/// As much of a header as version 1 can declare.
constexpr std::size_t most_header = (std::size_t{1} << 16) + 12;

class NpyRows : public StoredRows {
public:
    explicit NpyRows(StoredBytes stored) : StoredRows(std::move(stored)) {
        std::string head(most_header, '\0');
        head.resize(bytes.read(0, head));
        header_ = tables::read_npy_header(head, bytes.name());
        tables::require_npy_grid(header_, bytes.size() - header_.end, bytes.name());
        if (header_.is_fortran) throw not_streamed(bytes.name(), "an array in Fortran order");
        for (std::size_t i = 0; i < header_.shape[0]; ++i) x.push_back(static_cast<double>(i));
        for (std::size_t j = 0; j < header_.shape[1]; ++j) y.push_back(static_cast<double>(j));
    }

    void read(std::size_t first, std::span<double> z) override {
        raw_.resize(z.size() * header_.width);
        bytes.read(header_.end + std::uint64_t{first} * y.size() * header_.width, raw_);
        tables::npy_numbers(header_, raw_.data(), z);
        for (std::size_t k = 0; k < z.size(); ++k) {
            if (std::isfinite(z[k])) continue;
            const std::string place = bytes.name() + " [" + std::to_string(first + k / y.size()) +
                                      "][" + std::to_string(k % y.size()) + "]";
            if (std::isnan(z[k])) throw missing_node(place);
            throw Error("grid.cell", place, "inf", "a height must be a finite number or NaN");
        }
    }

private:
    tables::NpyHeader header_;
    std::vector<char> raw_;
};

}  // namespace

std::unique_ptr<StoredRows> npy_rows(StoredBytes bytes) {
    return std::make_unique<NpyRows>(std::move(bytes));
}

}  // namespace batten::grids
