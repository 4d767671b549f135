#include "prover/model/fibre_text.h"

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

} // namespace plprove::model
