#include "prover/model/fibre_text.h"

#include <algorithm>
#include <flint/nmod_poly.h>

namespace plprove::model {

std::vector<std::uint64_t> coefficients(const Univariate& polynomial, std::size_t count) {
    std::vector<std::uint64_t> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(polynomial.coefficient(i).value());
    return result;
}

void append_solutions(CertificateText& text, const Univariate& polynomial,
                      const std::vector<Univariate>& unknowns, const std::vector<int>& form) {
    const std::size_t count = polynomial.degree();
    text.line("polynomial", coefficients(polynomial, count));
    for (const Univariate& unknown : unknowns)
        text.line("unknown", coefficients(unknown, count));
    text.line("separated by", form);
}

std::vector<int> factor_degrees(const Univariate& polynomial) {
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor(factors, polynomial.get());
    std::vector<int> degrees;
    for (slong i = 0; i < factors->num; ++i)
        degrees.push_back(static_cast<int>(nmod_poly_degree(factors->p + i)));
    nmod_poly_factor_clear(factors);
    std::ranges::sort(degrees);
    return degrees;
}

} // namespace plprove::model
