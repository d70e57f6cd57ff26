#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "io/grids/stored_rows.hpp"
#include "io/tables/npy_grid.hpp"

namespace batten::grids {
namespace {

/// What is kept of an array in Fortran order, of whose rows every number is read by itself.
constexpr std::size_t band_bytes = std::size_t{1} << 26;
constexpr std::size_t columns_at_once = 8;

class NpyRows : public StoredRows {
public:
    explicit NpyRows(StoredBytes stored) : StoredRows(std::move(stored)) {
        header_ = tables::stored_npy_grid(bytes);
        for (std::size_t i = 0; i < header_.shape[0]; ++i) x.push_back(static_cast<double>(i));
        for (std::size_t j = 0; j < header_.shape[1]; ++j) y.push_back(static_cast<double>(j));
        band_rows_ = std::clamp<std::size_t>(band_bytes / (y.size() * sizeof(double)), 1, x.size());
    }

    void read(std::size_t first, std::span<double> z) override {
        if (header_.is_fortran) {
            for (std::size_t r = 0; r < z.size() / y.size(); ++r) {
                copy_from_band(first + r, z.subspan(r * y.size(), y.size()));
            }
        } else {
            read_run(first * y.size(), z);
        }
        for (std::size_t k = 0; k < z.size(); ++k) {
            if (!std::isinf(z[k])) continue;
            throw Error("grid.cell",
                        bytes.name() + " [" + std::to_string(first + k / y.size()) + "][" +
                            std::to_string(k % y.size()) + "]",
                        "inf", "a height must be a finite number or NaN");
        }
    }

private:
    /// Numbers that stand one behind the other, from number `first` of the array on.
    void read_run(std::size_t first, std::span<double> to) {
        raw_.resize(to.size() * header_.width);
        bytes.read(header_.end + std::uint64_t{first} * header_.width, raw_);
        tables::npy_numbers(header_, raw_.data(), to);
    }

    void copy_from_band(std::size_t row, std::span<double> to) {
        if (band_.empty() || row < band_first_ || row >= band_first_ + band_count_) {
            read_band(row / band_rows_ * band_rows_);
        }
        std::copy_n(band_.data() + (row - band_first_) * to.size(), to.size(), to.data());
    }

    /// Some rows, of a few columns at a time, so that both stay in the cache.
    void read_band(std::size_t first) {
        const std::size_t columns = y.size(), count = std::min(band_rows_, x.size() - first);
        band_first_ = first;
        band_count_ = count;
        band_.resize(count * columns);
        std::vector<double> few(columns_at_once * count);
        for (std::size_t j = 0; j < columns; j += columns_at_once) {
            const std::size_t width = std::min(columns_at_once, columns - j);
            for (std::size_t k = 0; k < width; ++k) {
                read_run((j + k) * x.size() + first, std::span(few).subspan(k * count, count));
            }
            for (std::size_t r = 0; r < count; ++r) {
                for (std::size_t k = 0; k < width; ++k) {
                    band_[r * columns + j + k] = few[k * count + r];
                }
            }
        }
    }

    tables::NpyHeader header_;
    std::vector<char> raw_;
    std::size_t band_rows_, band_first_ = 0, band_count_ = 0;
    std::vector<double> band_;  ///< row after row
};

}  // namespace

std::unique_ptr<StoredRows> npy_rows(StoredBytes bytes) {
    return std::make_unique<NpyRows>(std::move(bytes));
}

}  // namespace batten::grids
