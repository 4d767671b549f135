// The lines of a fibre in a certificate (certs/FORMAT.md, section 16), and what its polynomial
// shows.
#pragma once

#include "prover/format/certificate_text.h"
#include "prover/model/univariate.h"

#include <vector>

namespace plprove::model {

/// The first `count` coefficients.
std::vector<std::uint64_t> coefficients(const Univariate& polynomial, std::size_t count);

/// Adds the lines from `polynomial` to `separated by`.
void append_solutions(CertificateText& text, const Univariate& polynomial,
                      const std::vector<Univariate>& unknowns, const std::vector<int>& form);

/// The degrees of the irreducible factors, ascending: the lengths of the cycles of a permutation of
/// the solutions.
std::vector<int> factor_degrees(const Univariate& polynomial);

} // namespace plprove::model
