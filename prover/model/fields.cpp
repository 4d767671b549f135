#include "prover/model/fields.h"

namespace plprove::model {

Univariate::Univariate(const std::vector<Modular>& coefficients) : Univariate() {
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        nmod_poly_set_coeff_ui(value_, static_cast<slong>(i), coefficients[i].value());
}

std::size_t Univariate::degree() const {
    return is_zero() ? 0 : static_cast<std::size_t>(nmod_poly_degree(value_));
}

Modular Univariate::coefficient(std::size_t power) const {
    return Modular::of(nmod_poly_get_coeff_ui(value_, static_cast<slong>(power)));
}

Univariate recurrence_of(const std::vector<Modular>& sequence) {
    nmod_berlekamp_massey_t massey;
    nmod_berlekamp_massey_init(massey, modulus);
    for (const Modular& value : sequence)
        nmod_berlekamp_massey_add_point(massey, value.value());
    nmod_berlekamp_massey_reduce(massey);
    Univariate result;
    nmod_poly_set(result.get(), nmod_berlekamp_massey_V_poly(massey));
    nmod_berlekamp_massey_clear(massey);
    return result;
}

Univariate Algebra::reduced(const Univariate& a) const {
    Univariate result;
    nmod_poly_rem(result.get(), a.get(), polynomial_.get());
    return result;
}

Univariate Algebra::sum(const Univariate& a, const Univariate& b) {
    Univariate result;
    nmod_poly_add(result.get(), a.get(), b.get());
    return result;
}

Univariate Algebra::difference(const Univariate& a, const Univariate& b) {
    Univariate result;
    nmod_poly_sub(result.get(), a.get(), b.get());
    return result;
}

Univariate Algebra::product(const Univariate& a, const Univariate& b) const {
    Univariate result;
    nmod_poly_mulmod(result.get(), a.get(), b.get(), polynomial_.get());
    return result;
}

Univariate Algebra::inverse(const Univariate& a) const {
    Univariate result;
    if (a.is_zero() || nmod_poly_invmod(result.get(), a.get(), polynomial_.get()) == 0)
        throw NotInvertible();
    return result;
}

Univariate Algebra::without_common_factors(const Univariate& a) const {
    Univariate common, rest;
    nmod_poly_gcd(common.get(), polynomial_.get(), a.get());
    nmod_poly_div(rest.get(), polynomial_.get(), common.get());
    return rest;
}

Univariate determinant(const Algebra& algebra, const std::vector<std::vector<Univariate>>& matrix) {
    // M_1 = A, c_k = trace(M_k) / k, M_(k+1) = A (M_k - c_k I); the determinant is c_n, up to sign.
    const std::size_t n = matrix.size();
    auto power = matrix;
    Univariate coefficient;
    for (std::size_t k = 1; k <= n; ++k) {
        Univariate trace;
        for (std::size_t i = 0; i < n; ++i)
            trace = Algebra::sum(trace, power[i][i]);
        const Modular inverse = Modular(static_cast<std::int64_t>(k)).inverse();
        coefficient = algebra.product(trace, Univariate({inverse}));
        if (k == n) break;
        for (std::size_t i = 0; i < n; ++i)
            power[i][i] = Algebra::difference(power[i][i], coefficient);
        std::vector<std::vector<Univariate>> next(n, std::vector<Univariate>(n));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t l = 0; l < n; ++l)
                    next[i][j] =
                        Algebra::sum(next[i][j], algebra.product(matrix[i][l], power[l][j]));
        power = std::move(next);
    }
    return n % 2 == 0 ? Algebra::difference({}, coefficient) : coefficient;
}

} // namespace plprove::model
