// A second opinion on records of degree files, by other means than the checker's: the prover's
// equations of the class, whose Jacobian is taken from differences; Newton's method with the digits
// of long double; and the prover's measure of nondegeneracy. No proof, but another way to the same
// numbers.
#pragma once

#include "tests/mutation/referee.h"

namespace referee {

/// Why the record on this line does not show this number of different solutions of the class with
/// this number, as far as approximations tell; nothing where it does.
std::optional<std::string> objection_to_degree(const Text& file, std::size_t line,
                                               std::size_t number, std::size_t solutions);

} // namespace referee
