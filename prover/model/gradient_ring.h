// A program over a field or an algebra, with derivatives. Field has a type Element and functions
// constant(int), sum, difference, product, inverse, is_zero.
#pragma once

#include "prover/model/evaluation.h"

#include <utility>

namespace plprove::model {

template <class Field>
class GradientRing {
public:
    using Element = typename Field::Element;

    /// A value, and its derivatives other than 0 by number of the variable, ascending.
    struct Scalar {
        Element value{};
        std::vector<std::pair<std::size_t, Element>> gradient;
    };

    /// Derivatives are taken by the unknowns, numbered from 0, and then by the data, if
    /// `by_data`.
    GradientRing(const Field& field, std::vector<Element> data, std::vector<Element> unknowns,
                 bool by_data = false)
        : field_(&field), data_(std::move(data)), unknowns_(std::move(unknowns)),
          by_data_(by_data) {}

    Scalar constant(int value) const { return {field_->constant(value), {}}; }
    Scalar zero() const { return constant(0); }
    Scalar datum(std::size_t index) const {
        if (!by_data_) return {data_[index], {}};
        return {data_[index], {{unknowns_.size() + index, field_->constant(1)}}};
    }
    Scalar unknown(std::size_t index) const {
        return {unknowns_[index], {{index, field_->constant(1)}}};
    }
    Scalar sum(const Scalar& a, const Scalar& b) const {
        return combined(field_->sum(a.value, b.value), a, field_->constant(1), b,
                        field_->constant(1));
    }
    Scalar difference(const Scalar& a, const Scalar& b) const {
        return combined(field_->difference(a.value, b.value), a, field_->constant(1), b,
                        field_->constant(-1));
    }
    Scalar product(const Scalar& a, const Scalar& b) const {
        return combined(field_->product(a.value, b.value), a, b.value, b, a.value);
    }
    Scalar quotient(const Scalar& a, const Scalar& b, const Operation& /*which*/) const {
        const Element inverse = field_->inverse(b.value);
        const Element value = field_->product(a.value, inverse);
        const Element slope =
            field_->product(field_->difference(field_->constant(0), value), inverse);
        return combined(value, a, inverse, b, slope);
    }

private:
    /// `value` with the gradient x a' + y b'.
    Scalar combined(Element value, const Scalar& a, const Element& x, const Scalar& b,
                    const Element& y) const {
        Scalar result{std::move(value), {}};
        auto i = a.gradient.begin();
        auto j = b.gradient.begin();
        while (i != a.gradient.end() || j != b.gradient.end()) {
            const bool from_a =
                j == b.gradient.end() || (i != a.gradient.end() && i->first <= j->first);
            const bool from_b =
                i == a.gradient.end() || (j != b.gradient.end() && j->first <= i->first);
            const std::size_t index = from_a ? i->first : j->first;
            Element slope = from_a ? field_->product(x, i++->second) : field_->constant(0);
            if (from_b) slope = field_->sum(slope, field_->product(y, j++->second));
            if (!field_->is_zero(slope)) result.gradient.emplace_back(index, std::move(slope));
        }
        return result;
    }

    const Field* field_;
    std::vector<Element> data_, unknowns_;
    bool by_data_;
};

} // namespace plprove::model
