// The lines of a fibre in a certificate (certs/FORMAT.md, section 16).
#pragma once

#include "prover/format/certificate_text.h"
#include "prover/model/univariate.h"

namespace plprove::model {

/// The first `count` coefficients.
std::vector<std::uint64_t> coefficients(const Univariate& polynomial, std::size_t count);

/// Adds the lines from `polynomial` to `separated by`.
void append_solutions(CertificateText& text, const Univariate& polynomial,
                      const std::vector<Univariate>& unknowns, const std::vector<int>& form);

} // namespace plprove::model
