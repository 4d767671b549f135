#include "checker/conclusion/degree_bounds.h"

#include "checker/conclusion/pages_of_theorems.h"
#include "checker/degrees/constraint_class.h"
#include "checker/permutations/all_permutations.h"
#include "checker/permutations/five_shared_points.h"
#include "checker/permutations/half_turns.h"

#include <set>

namespace checker {
static void add_upper(DegreeBounds& known, const UpperBound& bound) {
    if (!known.at_most || bound.solutions < known.at_most->solutions) known.at_most = bound;
}

/// Whether a theorem says that these views have no more essential matrices: ten for five points, or
/// half as many as there are solutions.
static bool are_all_matrices(const Signature& signature, const BlockCycles& cycles) {
    const std::size_t matrices = points_of(cycles.matrices);
    if (cycles.views == views_with_five_points(signature)) return matrices == 10;
    return cycles.views == views_beside_half_turns(signature) &&
           2 * matrices == points_of(cycles.solutions);
}

DegreeTable bounds_by_files(const Classification& classes, const std::vector<bool>& minimal,
                            const std::vector<LowerBound>& lower, const RegistrationBounds& upper) {
    DegreeTable table;
    for (const LowerBound& bound : lower) {
        const Signature& signature = classes.representatives[bound.number];
        DegreeBounds& known = table[constraint_class(signature)];
        known.counted = known.at_least = std::max(known.counted, bound.solutions);
        known.cycle_types.insert(known.cycle_types.end(), bound.cycle_types.begin(),
                                 bound.cycle_types.end());
        for (const BlockCycles& cycles : bound.block_cycles)
            if (are_all_matrices(signature, cycles)) known.block_cycles.push_back(cycles);
    }
    for (std::size_t n = 0; n < minimal.size() && !upper.empty(); ++n) {
        if (!minimal[n]) continue;
        const Signature& signature = classes.representatives[n];
        const auto found = bound_by_registration(signature, upper);
        if (found) add_upper(table[constraint_class(signature)], {found->bound, found->type});
    }
    return table;
}

/// The constraint classes whose degrees are asked from theorems.
static std::set<Signature> asked_classes(const DegreeTable& table, const Classification& classes,
                                         const std::vector<bool>& minimal,
                                         const AskedDegrees& asked) {
    std::set<Signature> keys;
    if (asked.minimal_class)
        keys.insert(constraint_class(classes.representatives[*asked.minimal_class]));
    for (std::size_t n = 0; n < minimal.size(); ++n) {
        if (!minimal[n] || (table.empty() && !asked.all)) continue;
        const Signature key = constraint_class(classes.representatives[n]);
        if (asked.all || table.contains(key)) keys.insert(key);
    }
    return keys;
}

static std::string_view theorem_on_group(const Signature& signature) {
    if (has_all_permutations(signature)) return theorem_of_permutations;
    return has_all_permutations_of_third_cameras(signature) ? theorem_of_five_points : "";
}

void add_theorems(DegreeTable& table, const Classification& classes,
                  const std::vector<bool>& minimal, const AskedDegrees& asked) {
    exactly::Degrees degrees;
    for (const Signature& key : asked_classes(table, classes, minimal, asked)) {
        const auto degree = degrees.of(key);
        if (!degree) continue;
        DegreeBounds& known = table[key];
        known.theorem = degree;
        known.group_theorem = theorem_on_group(key);
        known.at_least = std::max(known.at_least, degree->solutions);
        if (!known.at_most || degree->solutions <= known.at_most->solutions)
            known.at_most = UpperBound{degree->solutions, ByTheorem{degree->theorem}};
    }
}

DegreeBounds bounds_of(const DegreeTable& table, const Signature& signature) {
    const auto place = table.find(constraint_class(signature));
    return place == table.end() ? DegreeBounds{} : place->second;
}

std::optional<std::string> contradiction(std::size_t counted,
                                         const std::optional<UpperBound>& at_most) {
    if (!at_most || counted <= at_most->solutions) return std::nullopt;
    return say("at least ", counted, " solutions, and ", in_words(*at_most));
}

std::string in_words(const UpperBound& bound) {
    const std::string at_most = say("at most ", bound.solutions, ", by ");
    if (std::holds_alternative<ByForms>(bound.by))
        return at_most + "forms that vanish at all solutions: proofs/fixed_forms.md";
    if (const auto* by = std::get_if<ByTheorem>(&bound.by))
        return say(at_most, "Theorem ", by->theorem, " of proofs/", page_of(by->theorem));
    return at_most + "models of relative pose and registration: proofs/registrations.md";
}
} // namespace checker
