// Proofs that a fibre solves a system of equations (proofs/fibres.md): exact, modulo q and g.
//
// A class At<T> stands for the system at some place, over a ring T of numbers, as in
// checker/degrees/krawczyk_operator.h.
#pragma once

#include "checker/fibres/fibre.h"
#include "checker/fibres/fibre_number.h"

namespace checker {
/// The effort of a fibre with so many unknowns.
inline std::uint64_t effort_of(const Fibre& fibre) {
    const std::uint64_t unknowns = fibre.unknowns.size(), degree = fibre.lower.size();
    return 1 + (unknowns * unknowns + 2'500) * unknowns * degree / 10'000;
}

/// Throws Refused unless the fibre has one nondegenerate solution of the system for each root of g.
template <template <class> class At, class System>
void prove_fibre(const System& system, const Fibre& fibre) {
    const Extension extension(fibre.lower);
    require_separate_solutions(extension, fibre);
    std::vector<FibreNumber> place;
    for (const Polynomial& unknown : fibre.unknowns)
        place.emplace_back(unknown, extension);
    At<FibreNumber> equations(system);
    equations.move_to(place);
    std::vector<std::vector<Polynomial>> jacobian;
    for (std::size_t e = 0; e < place.size(); ++e) {
        std::vector<FibreNumber> row(place.size());
        if (!equations.equation(e, row).is_zero()) throw Refused("equation ", e + 1, " is not 0");
        std::vector<Polynomial>& derivatives = jacobian.emplace_back();
        for (const FibreNumber& derivative : row)
            derivatives.push_back(derivative.in(extension));
    }
    const std::string_view degeneracy = equations.degeneracy();
    if (!degeneracy.empty()) throw Refused(degeneracy);
    if (!is_regular(extension, std::move(jacobian))) throw Refused("the Jacobian has no inverse");
}
} // namespace checker
