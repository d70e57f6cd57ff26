#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/base/points.hpp"
#include "batten/shape/jet.hpp"

namespace batten {

/// What a type must offer to be a `Curve`.
///
/// A curve is made of smooth pieces, piece i over [breaks()[i], breaks()[i + 1]]; smoothness may
/// drop at the breaks and nowhere else. `jets_on` evaluates one piece, its two ends included: so
/// both one-sided limits exist at every break. Output: for each t the value, then the derivatives
/// up to `order`, dim numbers each.
template <class T>
concept CurveShape =
    requires(const T& c, std::size_t piece, std::span<const double> t, std::span<double> out) {
        { c.dim() } -> std::convertible_to<int>;
        { c.breaks() } -> std::convertible_to<std::span<const double>>;
        { c.is_closed() } -> std::convertible_to<bool>;
        { c.degree() } -> std::convertible_to<std::optional<int>>;
        c.jets_on(piece, t, 0, out);
    };

/// What somebody knows of a curve beyond its shape. It goes where the curve goes; a curve made of
/// another has none.
class CurveCompanion {
public:
    virtual ~CurveCompanion() = default;
};

/// Any curve: type-erased, immutable, cheap to copy, usable from many threads.
class Curve {
public:
    template <class T>
        requires(!std::same_as<T, Curve> && CurveShape<T>)
    Curve(T shape) : model_(std::make_shared<Model<T>>(std::move(shape))) {}

    int dim() const { return model_->dim(); }
    Interval domain() const { return {breaks().front(), breaks().back()}; }
    /// Parameters where smoothness drops, both ends of the domain included; strictly increasing.
    std::span<const double> breaks() const { return model_->breaks(); }
    std::size_t pieces() const { return breaks().size() - 1; }
    Interval piece(std::size_t i) const { return {breaks()[i], breaks()[i + 1]}; }
    /// Whether the end of the domain continues at its start.
    bool is_closed() const { return model_->is_closed(); }
    /// The degree of every piece where all of them are polynomials in t.
    std::optional<int> degree() const { return model_->degree(); }

    /// The piece that holds t: right-continuous, except at the end of the domain. Parameters
    /// outside the domain belong to the first or last piece (which is extrapolated).
    std::size_t piece_of(double t) const;

    /// Value and derivatives at t; at a break those of the piece to the right.
    Jet jet(double t, int order) const { return jet_on(piece_of(t), t, order); }
    /// Value and derivatives of one piece at t: at its ends the one-sided limits.
    Jet jet_on(std::size_t piece, double t, int order) const;
    /// Many parameters at once, in any order. `out` holds t.size() x (order + 1) x dim numbers.
    /// Cost: a search for each t that is not in the piece of the one before. No allocation.
    void jets(std::span<const double> t, int order, std::span<double> out) const;
    /// Many parameters of one piece.
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        model_->jets_on(piece, t, order, out);
    }
    /// The point at t.
    std::vector<double> operator()(double t) const;

    /// The shape inside, if it is a T.
    template <class T>
    const T* shape() const {
        const auto* model = dynamic_cast<const Model<T>*>(model_.get());
        return model ? &model->shape : nullptr;
    }

    /// The same curve, accompanied.
    Curve with(std::shared_ptr<const CurveCompanion> companion) const {
        Curve curve = *this;
        curve.companion_ = std::move(companion);
        return curve;
    }
    /// The companion, if it is a T.
    template <class T>
    const T* companion() const {
        return dynamic_cast<const T*>(companion_.get());
    }

private:
    struct Concept {
        virtual ~Concept() = default;
        virtual int dim() const = 0;
        virtual std::span<const double> breaks() const = 0;
        virtual bool is_closed() const = 0;
        virtual std::optional<int> degree() const = 0;
        virtual void jets_on(std::size_t, std::span<const double>, int,
                             std::span<double>) const = 0;
        virtual bool jets(std::span<const double>, int, std::span<double>) const = 0;
    };
    template <class T>
    struct Model;

    std::shared_ptr<const Concept> model_;
    std::shared_ptr<const CurveCompanion> companion_;
};

/// A curve from the user's own function. `function(t, order, out)` writes the value and the first
/// `order` derivatives, dim numbers each, for t in the closed domain; between two breaks it must
/// be smooth. At a break it is asked just inside the piece.
struct CallableCurve {
    std::function<void(double t, int order, std::span<double> out)> function;
    int dimension = 2;
    std::vector<double> joints;  ///< breaks, both ends included, strictly increasing
    bool closed = false;

    int dim() const { return dimension; }
    std::span<const double> breaks() const { return joints; }
    bool is_closed() const { return closed; }
    std::optional<int> degree() const { return std::nullopt; }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;
};

/// The longest side of the box around the breaks' points and the pieces' middles: the scale that
/// relative tolerances refer to. Positive unless all these points are one.
double extent(const Curve& curve);

/// The part of `curve` over [part.lo, part.hi]. Throws `curve.part-empty` unless
/// part.lo < part.hi, `curve.outside` unless the domain contains both.
Curve trimmed(const Curve& curve, Interval part);

template <class T>
struct Curve::Model final : Curve::Concept {
    explicit Model(T s) : shape(std::move(s)) {}
    int dim() const override { return shape.dim(); }
    std::span<const double> breaks() const override { return shape.breaks(); }
    bool is_closed() const override { return shape.is_closed(); }
    std::optional<int> degree() const override { return shape.degree(); }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const override {
        shape.jets_on(piece, t, order, out);
    }
    bool jets(std::span<const double> t, int order, std::span<double> out) const override {
        if constexpr (requires { shape.jets(t, order, out); }) {
            shape.jets(t, order, out);
            return true;
        }
        return false;
    }
    T shape;
};

}  // namespace batten
