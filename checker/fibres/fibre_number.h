// Numbers of F_q[t] / (g) as a ring for the equations of cameras: constants are made without g.
#pragma once

#include "checker/algebra/vector3.h"
#include "checker/fibres/extension.h"

namespace checker {
class FibreNumber {
public:
    FibreNumber() = default; // 0
    /// Of an integer that the double holds exactly.
    explicit FibreNumber(double integer)
        : value_{integer < 0 ? -Residue::of(static_cast<std::uint64_t>(-integer))
                             : Residue::of(static_cast<std::uint64_t>(integer))} {}
    explicit FibreNumber(const mpz_class& integer) : value_{residue(integer)} {}
    /// An element of the extension, which must outlive the number.
    FibreNumber(Polynomial value, const Extension& extension)
        : value_(std::move(value)), extension_(&extension) {}

    FibreNumber operator+(const FibreNumber& other) const {
        return value_.size() < other.value_.size()
                   ? FibreNumber(sum_of(other.value_, value_), other.extension_)
                   : FibreNumber(sum_of(value_, other.value_), extension_);
    }
    FibreNumber operator-() const { return FibreNumber(-1) * *this; }
    FibreNumber operator-(const FibreNumber& other) const { return *this + -other; }
    FibreNumber operator*(const FibreNumber& other) const {
        if (is_constant()) return other.times(constant_term());
        if (other.is_constant()) return times(other.constant_term());
        return {extension_->multiply(value_, other.value_), *extension_};
    }

    /// Whether it is 0 at each root of g.
    bool is_zero() const { return checker::is_zero(value_); }

    /// Whether it is nowhere 0 at the roots of g.
    friend bool nonzero(const FibreNumber& x) {
        return x.is_constant() ? !x.is_zero() : x.extension_->is_unit(x.value_);
    }

    /// As an element of the extension.
    Polynomial in(const Extension& extension) const {
        return is_constant() ? extension.constant(constant_term()) : value_;
    }

private:
    FibreNumber(Polynomial value, const Extension* extension)
        : value_(std::move(value)), extension_(extension) {}

    bool is_constant() const { return extension_ == nullptr; }
    Residue constant_term() const { return value_.empty() ? Residue{} : value_[0]; }
    FibreNumber times(Residue factor) const {
        FibreNumber result = *this;
        for (Residue& coefficient : result.value_)
            coefficient = coefficient * factor;
        return result;
    }

    Polynomial value_{};                   // of a constant: at most one coefficient
    const Extension* extension_ = nullptr; // none of a constant
};
} // namespace checker
