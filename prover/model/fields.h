// Where programs are run with derivatives beside prime fields: polynomials in t modulo q and g.
#pragma once

#include "prover/model/prime_field.h"
#include "prover/model/univariate.h"

namespace plprove::model {

/// Polynomials modulo q and g.
class Algebra {
public:
    using Element = Univariate;

    explicit Algebra(Univariate polynomial) : polynomial_(std::move(polynomial)) {}

    const Univariate& polynomial() const { return polynomial_; }
    Univariate constant(int value) const { return reduced(Univariate({Modular(value)})); }
    Univariate reduced(const Univariate& a) const;
    static Univariate sum(const Univariate& a, const Univariate& b);
    static Univariate difference(const Univariate& a, const Univariate& b);
    Univariate product(const Univariate& a, const Univariate& b) const;
    static bool is_zero(const Univariate& a) { return a.is_zero(); }
    /// Throws NotInvertible if a and g have a common factor.
    Univariate inverse(const Univariate& a) const;

    /// g without the factors that it has in common with a.
    Univariate without_common_factors(const Univariate& a) const;

private:
    Univariate polynomial_;
};

/// The determinant of a square matrix by rows, without divisions but by integers (Faddeev and
/// LeVerrier).
Univariate determinant(const Algebra& algebra, const std::vector<std::vector<Univariate>>& matrix);

} // namespace plprove::model
