#include "num/tensor.hpp"

#include <algorithm>

#include "num/lanes.hpp"
#include "num/rows.hpp"
#include "num/tensor_kernels.hpp"

namespace batten::num {
namespace {

constexpr std::size_t block = tensor_block;
/// Rows worked on before the next block of columns.
constexpr std::size_t rows_at_once = 32;

}  // namespace

/// The lines sum over j of c(i, j) y_j(s) that the present x-place needs, in a ring.
class Tensor::Lines {
public:
    Lines(const Tensor& tensor, std::span<const double> c)
        : tensor_(tensor), c_(c), order_(static_cast<std::size_t>(tensor.x_->order)),
          reach_(whole_lanes(tensor.y_->places())), lines_(order_ * reach_), at_(order_),
          functions_(static_cast<std::size_t>(tensor.y_->order)) {
        for (std::size_t j = 0; j < functions_.size(); ++j) {
            functions_[j] = tensor.y_turned_.data() + j * tensor.y_->places();
        }
    }

    /// `first` must not fall from call to call.
    void go_to(std::size_t first) {
        for (std::size_t i = std::max(first, end_); i < first + order_; ++i) {
            double* const line = lines_.data() + (i % order_) * reach_;
            const double* const c = c_.data() + i * tensor_.y_->functions;
            for (const Run& run : tensor_.runs_) {
                combine(functions_.data(), c + run.function, functions_.size(),
                        {run.first, run.last}, line + run.first);
            }
        }
        end_ = first + order_;
        for (std::size_t i = 0; i < order_; ++i) {
            at_[i] = lines_.data() + ((first + i) % order_) * reach_;
        }
    }
    const double* const* present() const { return at_.data(); }

private:
    const Tensor& tensor_;
    std::span<const double> c_;
    std::size_t order_, reach_, end_ = 0;
    AlignedNumbers lines_;
    std::vector<const double*> at_, functions_;
};

Tensor::Tensor(const TensorSide& x, const TensorSide& y, Use use) : x_(&x), y_(&y) {
    const std::size_t places = y.places(), order = static_cast<std::size_t>(y.order);
    y_turned_.resize(use == Use::all ? places * order : 0);
    for (std::size_t s = 0; s < places && use == Use::all; ++s) {
        for (std::size_t j = 0; j < order; ++j) y_turned_[j * places + s] = y.at(s)[j];
    }
    y_width_ = order <= 4 ? 4 : whole_lanes(order);
    if (y_width_ != order) {
        y_widened_.assign(places * y_width_, 0.0);
        for (std::size_t s = 0; s < places; ++s) {
            std::copy_n(y.at(s), order, y_widened_.data() + s * y_width_);
        }
    }
    for (std::size_t s = 0; s < places; ++s) {
        if (s % block == 0) block_runs_.push_back(runs_.size());
        if (s % block == 0 || y.first[s] != y.first[s - 1]) runs_.push_back({s, s, y.first[s]});
        runs_.back().last = s + 1;
    }
    block_runs_.push_back(runs_.size());
}

PlaceRange Tensor::rows_alike(std::size_t first, std::size_t last) const {
    PlaceRange rows{first, first + 1};
    while (rows.last < std::min(last, first + rows_at_once) &&
           x_->first[rows.last] == x_->first[first]) {
        ++rows.last;
    }
    return rows;
}

std::span<const Tensor::Run> Tensor::runs_of(std::size_t block_index) const {
    return {runs_.data() + block_runs_[block_index],
            block_runs_[block_index + 1] - block_runs_[block_index]};
}

void Tensor::expand(std::span<const double> c, PlaceRange rows, std::span<double> out) const {
    const std::size_t places = y_->places();
    Lines lines(*this, c);
    for (PlaceRange few; few.last < rows.last;) {
        few = rows_alike(std::max(few.last, rows.first), rows.last);
        lines.go_to(x_->first[few.first]);
        for (std::size_t s = 0; s < places; s += block) {
            for (std::size_t r = few.first; r < few.last; ++r) {
                combine(lines.present(), x_->at(r), static_cast<std::size_t>(x_->order),
                        {s, std::min(places, s + block)},
                        out.data() + (r - rows.first) * places + s);
            }
        }
    }
}

void Tensor::for_each_block(std::span<const double> c, const Visit& visit) const {
    const std::size_t places = y_->places();
    Lines lines(*this, c);
    for (PlaceRange few; few.last < x_->places();) {
        few = rows_alike(few.last, x_->places());
        lines.go_to(x_->first[few.first]);
        for (std::size_t s = 0; s < places; s += block) {
            visit({few, {s, std::min(places, s + block)}, lines.present()});
        }
    }
}

void Tensor::add_products(Sums sums, std::size_t count, std::size_t block_index, double* g) const {
    const std::size_t order = static_cast<std::size_t>(y_->order);
    const double* const y = y_widened_.empty() ? y_->values.data() : y_widened_.data();
    for (const Run& run : runs_of(block_index)) {
        num::add_products({sums.from + (run.first - block_index * block), sums.stride,
                             y + run.first * y_width_, y_width_, order, run.last - run.first,
                             g + run.function, y_->functions},
                            count);
    }
}

/// What x-places with neighbouring functions have gathered so far, a line a function.
class Tensor::Gathered {
public:
    Gathered(const Tensor& tensor, std::span<double> g, std::size_t first)
        : tensor_(tensor), g_(g), order_(static_cast<std::size_t>(tensor.x_->order)),
          reach_(whole_lanes(tensor.y_->places())), lines_(order_ * reach_), first_(first),
          at_(order_) {
        go_to(first);
    }

    /// What functions below have gathered is complete.
    void go_to(std::size_t first) {
        for (std::size_t i = first_; i < std::min(first, first_ + order_); ++i) {
            double* const line = lines_.data() + (i % order_) * reach_;
            for (std::size_t b = 0; b + 1 < tensor_.block_runs_.size(); ++b) {
                tensor_.add_products({line + b * block, reach_}, 1, b,
                                     g_.data() + i * tensor_.y_->functions);
            }
            std::fill_n(line, reach_, 0.0);
        }
        first_ = first;
        for (std::size_t i = 0; i < order_; ++i) {
            at_[i] = lines_.data() + ((first + i) % order_) * reach_;
        }
    }
    double* const* present() const { return at_.data(); }

private:
    const Tensor& tensor_;
    std::span<double> g_;
    std::size_t order_, reach_;
    AlignedNumbers lines_;
    std::size_t first_;
    std::vector<double*> at_;
};

void Tensor::contract(std::span<const double> z, PlaceRange rows, std::span<double> g) const {
    if (rows.count() == 0) return;
    const std::size_t places = y_->places(), order = static_cast<std::size_t>(x_->order);
    Gathered gathered(*this, g, x_->first[rows.first]);
    AlignedNumbers near(order * block);  // in the first cache; the lines are not
    std::vector<double*> nearby;
    for (std::size_t i = 0; i < order; ++i) nearby.push_back(near.data() + i * block);
    for (PlaceRange few; few.last < rows.last;) {
        few = rows_alike(std::max(few.last, rows.first), rows.last);
        gathered.go_to(x_->first[few.first]);
        for (std::size_t s = 0; s < places; s += block) {
            const std::size_t count = std::min(block, places - s);
            std::fill_n(near.data(), order * block, 0.0);
            add_rows({z.data() + (few.first - rows.first) * places + s, places,
                      x_->at(few.first), order},
                     few.count(), {nearby.data(), 0, count});
            for (std::size_t i = 0; i < order; ++i) {
                add_times(1, {nearby[i], count}, {gathered.present()[i] + s, count});
            }
        }
    }
    gathered.go_to(x_->first[rows.last - 1] + order);
}

void Tensor::contract_apart(std::span<const double> z, PlaceRange rows, std::span<double> by_x,
                            std::span<double> by_y) const {
    const std::size_t places = y_->places(), order = static_cast<std::size_t>(x_->order);
    std::vector<double*> sums(order);
    for (PlaceRange few; few.last < rows.last;) {
        few = rows_alike(std::max(few.last, rows.first), rows.last);
        for (std::size_t i = 0; i < order; ++i) {
            sums[i] = by_x.data() + (x_->first[few.first] + i) * places;
        }
        for (std::size_t b = 0; b + 1 < block_runs_.size(); ++b) {
            const std::size_t s = b * block;
            const double* const from = z.data() + (few.first - rows.first) * places + s;
            add_rows({from, places, x_->at(few.first), order}, few.count(),
                     {sums.data(), s, std::min(block, places - s)});
            add_products({from, places}, few.count(), b,
                         by_y.data() + (few.first - rows.first) * y_->functions);
        }
    }
}

}  // namespace batten::num
