#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "curve_promises.hpp"

namespace batten::fuzz {

/// Takes options and points from bytes.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    /// 0 where nothing is left.
    unsigned byte() { return at_ < size_ ? data_[at_++] : 0; }
    unsigned below(unsigned limit) { return byte() % limit; }
    /// Mostly moderate, with all the doubles there are among them.
    double number() {
        const unsigned kind = byte();
        if (kind < 240) return (static_cast<int>(kind % 16) - 8) + (byte() - 128.0) / 64;
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    std::string number_text() {
        const std::string digits = std::to_string(below(40));
        return digits + "e-" + std::to_string(below(7));
    }
    Points points(std::size_t most, int dim) {
        Points result(0, dim);
        std::vector<double> row(static_cast<std::size_t>(dim));
        while (at_ < size_ && result.size() < most) {
            for (double& x : row) x = number();
            result.push_back(row);
        }
        return result;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_, at_ = 0;
};

inline Input points_as_input(Points points) {
    PointsInput input;
    input.table.source = "input";
    for (int k = 0; k < points.dim(); ++k) input.columns.push_back(k);
    input.table.bad.resize(input.columns.size());
    input.table.cells = std::move(points);
    return {"input", std::move(input)};
}

/// Nothing where there is none.
inline std::optional<Curve> natural_spline(const Points& points) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    try {
        return interpolate(points, options).curve;
    } catch (const Error& error) {
        check_error(error);
        return std::nullopt;
    }
}

/// Pieces from every other point to the next, the points between taken as derivatives.
inline std::optional<Curve> cubics(const Points& rows) {
    Points points(rows.dim()), slopes(rows.dim());
    std::vector<double> breaks;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
        breaks.push_back(static_cast<double>(points.size()));
        points.push_back(rows[i]);
        slopes.push_back(rows[i + 1]);
    }
    if (points.size() < 2) return std::nullopt;
    const std::size_t pieces = points.size() - 1;
    try {
        return PiecewiseCubic::hermite(points, slopes.view().part(0, pieces),
                                       slopes.view().part(1, pieces), breaks, false);
    } catch (const Error& error) {
        check_error(error);
        return std::nullopt;
    }
}

/// Numbers in results and reports are finite.
inline void check_value(const Value& value) {
    if (value.is_number()) require(std::isfinite(value.number()));
    if (const ValueList* list = value.list()) {
        for (const Value& element : *list) check_value(element);
    }
    if (const ValueMap* map = value.map()) {
        for (const auto& [key, element] : *map) check_value(element);
    }
}

/// Runs an operation: it makes finite numbers, or says what is wrong.
inline void check_operation(const std::string& name, const Input& input,
                            const std::vector<Setting>& settings) {
    const Operation* const operation = find_operation(name);
    require(operation != nullptr);
    try {
        const Outcome outcome = operation->run({&input, 1}, settings, {});
        check_value(outcome.report);
        if (const auto* rows = std::get_if<Rows>(&outcome.output)) {
            require(!rows->cells.empty());
            for (const double x : rows->cells.coordinates()) require(std::isfinite(x));
        }
        if (const auto* curve = std::get_if<Curve>(&outcome.output)) check_curve(*curve);
    } catch (const Error& error) {
        check_error(error);
    }
}

}  // namespace batten::fuzz
