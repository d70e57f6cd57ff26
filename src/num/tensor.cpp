#include "num/tensor.hpp"

#include <algorithm>

#include "num/lanes.hpp"

namespace batten::num {
namespace {

/// Columns worked on at a time: sums, and the same rows of the next block, stay in the first cache.
constexpr std::size_t block = 256;
/// Rows worked on before the next block of columns.
constexpr std::size_t rows_at_once = 32;

/// Rows of an array and what each is worth to some functions: factors[row * order + function].
struct Rows {
    const double* z;
    std::size_t stride;
    const double* factors;
    std::size_t order;
};

/// sums(i, s) += sum over q of factors(q, i) z(q, s). Rows of `sums` are `reach` apart.
template <int Functions, int Count>
BATTEN_INLINE void add_few(const Rows& rows, std::size_t count, double* __restrict sums,
                           std::size_t reach) {
    double a[Count][Functions];
    for (int q = 0; q < Count; ++q) {
        for (int i = 0; i < Functions; ++i) {
            a[q][i] = rows.factors[static_cast<std::size_t>(q) * rows.order +
                                   static_cast<std::size_t>(i)];
        }
    }
    std::size_t s = 0;
    for (; s + lanes <= count; s += lanes) {
        Lanes t[Functions];
        for (int i = 0; i < Functions; ++i) load(sums + static_cast<std::size_t>(i) * reach + s, t[i]);
        for (int q = 0; q < Count; ++q) {
            const double* const from = rows.z + static_cast<std::size_t>(q) * rows.stride + s;
            Lanes u;
            load(from, u);
#ifdef __GNUC__
            __builtin_prefetch(from + block);
#endif
            for (int i = 0; i < Functions; ++i) t[i] += a[q][i] * u;
        }
        for (int i = 0; i < Functions; ++i) store(t[i], sums + static_cast<std::size_t>(i) * reach + s);
    }
    for (; s < count; ++s) {
        for (int i = 0; i < Functions; ++i) {
            double& t = sums[static_cast<std::size_t>(i) * reach + s];
            for (int q = 0; q < Count; ++q) {
                t += a[q][i] * rows.z[static_cast<std::size_t>(q) * rows.stride + s];
            }
        }
    }
}

template <int Functions>
BATTEN_INLINE void add_all(Rows rows, std::size_t row_count, std::size_t count, double* sums,
                           std::size_t reach) {
    const auto go_on = [&](std::size_t by) {
        rows.z += by * rows.stride;
        rows.factors += by * rows.order;
    };
    for (; row_count >= 4; row_count -= 4) {
        add_few<Functions, 4>(rows, count, sums, reach);
        go_on(4);
    }
    if (row_count == 3) add_few<Functions, 3>(rows, count, sums, reach);
    if (row_count == 2) add_few<Functions, 2>(rows, count, sums, reach);
    if (row_count == 1) add_few<Functions, 1>(rows, count, sums, reach);
}

/// The same for all functions.
BATTEN_CLONES void add_rows(Rows rows, std::size_t row_count, std::size_t count, double* sums,
                            std::size_t reach) {
    std::size_t left = rows.order;
    const std::size_t order = rows.order;
    for (; left >= 4; left -= 4) {
        const std::size_t i = order - left;
        Rows some = rows;
        some.factors += i;
        add_all<4>(some, row_count, count, sums + i * reach, reach);
    }
    for (; left > 0; --left) {
        const std::size_t i = order - left;
        Rows some = rows;
        some.factors += i;
        add_all<1>(some, row_count, count, sums + i * reach, reach);
    }
}

typedef double Four __attribute__((vector_size(32)));

/// g(q, j) += sum over s of from(q, s) y(s, j) for `Count` rows and as many j as a vector holds.
template <class Vector, int Count>
BATTEN_INLINE void add_products_of(const double* from, std::size_t stride, const double* y,
                                   std::size_t width, std::size_t count, Vector* sums) {
    Vector t[Count] = {};
    for (std::size_t s = 0; s < count; ++s) {
        Vector v;
        std::memcpy(&v, y + s * width, sizeof v);
        for (int q = 0; q < Count; ++q) t[q] += from[static_cast<std::size_t>(q) * stride + s] * v;
    }
    for (int q = 0; q < Count; ++q) sums[q] = t[q];
}

/// One run of y-places with the same functions.
struct Product {
    const double* from;  ///< rows of numbers at these places
    std::size_t stride;
    const double* y;  ///< the functions there, `width` a place
    std::size_t width, order, places;
    double* g;  ///< of the first row and function
    std::size_t reach;
};

template <class Vector, int Count>
BATTEN_INLINE void add_product_rows(const Product& p, std::size_t row) {
    constexpr std::size_t wide = sizeof(Vector) / sizeof(double);
    for (std::size_t j = 0; j < p.order; j += wide) {
        Vector t[Count];
        add_products_of<Vector, Count>(p.from + row * p.stride, p.stride, p.y + j, p.width,
                                       p.places, t);
        const std::size_t few = std::min(wide, p.order - j);
        for (int q = 0; q < Count; ++q) {
            double* const to = p.g + (row + static_cast<std::size_t>(q)) * p.reach + j;
            for (std::size_t l = 0; l < few; ++l) to[l] += t[q][l];
        }
    }
}

template <class Vector>
BATTEN_INLINE void add_product(const Product& p, std::size_t count) {
    std::size_t row = 0;
    for (; row + 4 <= count; row += 4) add_product_rows<Vector, 4>(p, row);
    for (; row < count; ++row) add_product_rows<Vector, 1>(p, row);
}

BATTEN_CLONES void add_product_of_rows(const Product& p, std::size_t count) {
    if (p.width == 4) add_product<Four>(p, count);
    else add_product<Lanes>(p, count);
}

/// out[s] = sum of h[j] lines[j][s].
BATTEN_CLONES void combine(const double* const* lines, const double* h, std::size_t order,
                           PlaceRange places, double* __restrict out) {
    const std::size_t count = places.count();
    if (order == 4) {
        const double* const y0 = lines[0] + places.first;
        const double* const y1 = lines[1] + places.first;
        const double* const y2 = lines[2] + places.first;
        const double* const y3 = lines[3] + places.first;
        std::size_t s = 0;
        for (; s + lanes <= count; s += lanes) {
            Lanes a, b, c, d;
            load(y0 + s, a);
            load(y1 + s, b);
            load(y2 + s, c);
            load(y3 + s, d);
            store((h[0] * a + h[1] * b) + (h[2] * c + h[3] * d), out + s);
        }
        for (; s < count; ++s) {
            out[s] = (h[0] * y0[s] + h[1] * y1[s]) + (h[2] * y2[s] + h[3] * y3[s]);
        }
        return;
    }
    std::fill_n(out, count, 0.0);
    for (std::size_t j = 0; j < order; ++j) {
        const double* const line = lines[j] + places.first;
        for (std::size_t s = 0; s < count; ++s) out[s] += h[j] * line[s];
    }
}

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
    void combine_at(const double* factors, PlaceRange columns, double* out) const {
        combine(at_.data(), factors, order_, columns, out);
    }

private:
    const Tensor& tensor_;
    std::span<const double> c_;
    std::size_t order_, reach_, end_ = 0;
    AlignedNumbers lines_;
    std::vector<const double*> at_, functions_;
};

Tensor::Tensor(const TensorSide& x, const TensorSide& y) : x_(&x), y_(&y) {
    const std::size_t places = y.places(), order = static_cast<std::size_t>(y.order);
    y_turned_.resize(places * order);
    for (std::size_t s = 0; s < places; ++s) {
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
                lines.combine_at(x_->at(r), {s, std::min(places, s + block)},
                                 out.data() + (r - rows.first) * places + s);
            }
        }
    }
}

void Tensor::for_each_piece(std::span<const double> c, PlaceRange rows, const Visit& visit) const {
    const std::size_t places = y_->places();
    AlignedNumbers values(block);
    Lines lines(*this, c);
    for (PlaceRange few; few.last < rows.last;) {
        few = rows_alike(std::max(few.last, rows.first), rows.last);
        lines.go_to(x_->first[few.first]);
        for (std::size_t s = 0; s < places; s += block) {
            const PlaceRange columns{s, std::min(places, s + block)};
            for (std::size_t r = few.first; r < few.last; ++r) {
                lines.combine_at(x_->at(r), columns, values.data());
                visit(r, columns, values.data());
            }
        }
    }
}

void Tensor::add_products(Sums sums, std::size_t count, std::size_t block_index, double* g) const {
    const std::size_t order = static_cast<std::size_t>(y_->order);
    const double* const y = y_widened_.empty() ? y_->values.data() : y_widened_.data();
    for (const Run& run : runs_of(block_index)) {
        add_product_of_rows({sums.from + (run.first - block_index * block), sums.stride,
                             y + run.first * y_width_, y_width_, order, run.last - run.first,
                             g + run.function, y_->functions},
                            count);
    }
}

void Tensor::contract(std::span<const double> z, PlaceRange rows, std::span<double> g) const {
    const std::size_t places = y_->places(), order = static_cast<std::size_t>(x_->order);
    const std::size_t reach = whole_lanes(places);
    AlignedNumbers sums(order * reach);
    for (std::size_t r = rows.first; r < rows.last;) {
        const std::size_t function = x_->first[r];
        std::fill_n(sums.data(), order * reach, 0.0);
        while (r < rows.last && x_->first[r] == function) {
            const PlaceRange few = rows_alike(r, rows.last);
            for (std::size_t s = 0; s < places; s += block) {
                add_rows({z.data() + (r - rows.first) * places + s, places, x_->at(r), order},
                         few.count(), std::min(block, places - s), sums.data() + s, reach);
            }
            r = few.last;
        }
        for (std::size_t b = 0; b + 1 < block_runs_.size(); ++b) {
            add_products({sums.data() + b * block, reach}, order, b,
                         g.data() + function * y_->functions);
        }
    }
}

void Tensor::contract_apart(std::span<const double> z, PlaceRange rows, std::span<double> by_x,
                            std::span<double> by_y) const {
    const std::size_t places = y_->places(), order = static_cast<std::size_t>(x_->order);
    for (PlaceRange few; few.last < rows.last;) {
        few = rows_alike(std::max(few.last, rows.first), rows.last);
        for (std::size_t b = 0; b + 1 < block_runs_.size(); ++b) {
            const std::size_t s = b * block;
            const double* const from = z.data() + (few.first - rows.first) * places + s;
            add_rows({from, places, x_->at(few.first), order}, few.count(),
                     std::min(block, places - s),
                     by_x.data() + x_->first[few.first] * places + s, places);
            add_products({from, places}, few.count(), b,
                         by_y.data() + (few.first - rows.first) * y_->functions);
        }
    }
}

}  // namespace batten::num
