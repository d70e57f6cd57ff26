#pragma once

#include <optional>
#include <string>

#include "batten/io/table.hpp"

namespace batten::api {

/// Which columns of a table hold scattered heights, and their errors where they stand there.
struct ScatteredColumns {
    int x = 0, y = 1, z = 2;
    std::optional<int> sigma;
};

/// Those picked (`A,B,C[,D]`), else those named x, y, z (or f, value, height), else the only three
/// in order; errors by the name sigma or error, or as the fourth of columns without names. Throws
/// `table.columns` where more columns or one of numbers of rows leave it open, and what
/// `column_index` throws.
ScatteredColumns scattered_columns(const Table& table, const std::string& picks);

}  // namespace batten::api
