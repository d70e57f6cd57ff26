#include "batten/shape/jet.hpp"

namespace batten {

Jet::Jet(int dim, int order) : dim_(dim), order_(order) {
    const std::size_t count = width() * static_cast<std::size_t>(order + 1);
    if (count > few_.size()) many_.resize(count);
}

std::span<double> Jet::values() {
    if (!many_.empty()) return many_;
    return {few_.data(), width() * static_cast<std::size_t>(order_ + 1)};
}

std::span<const double> Jet::values() const {
    if (!many_.empty()) return many_;
    return {few_.data(), width() * static_cast<std::size_t>(order_ + 1)};
}

}  // namespace batten
