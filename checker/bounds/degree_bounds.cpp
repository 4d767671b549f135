#include "checker/bounds/degree_bounds.h"

#include "checker/bounds/registration.h"
#include "checker/bounds/theorems.h"
#include "checker/degrees/constraint_class.h"

#include <set>

namespace checker {
/// The signature of a problem in the notation of section 1, made of features of the table.
static Signature signature_of(std::string_view problem) {
    Signature signature{};
    while (!problem.empty()) {
        std::string_view summand = problem.substr(0, problem.find(' '));
        problem.remove_prefix(std::min(summand.size() + 3, problem.size())); // with " + "
        unsigned count = 1;
        if (const std::size_t star = summand.find('*'); star != std::string_view::npos) {
            std::from_chars(summand.data(), summand.data() + star, count);
            summand.remove_prefix(star + 1);
        }
        signature[index_of(summand)] += count;
    }
    return signature;
}

/// The bounds by theorem, by constraint class. No class has two.
static std::map<Signature, UpperBound> bounds_by_theorem(const Classification& classes) {
    std::map<Signature, UpperBound> bounds;
    std::size_t row = 0;
    for (const auto& [theorem, problem, bound] : theorem_bounds)
        bounds[constraint_class(signature_of(problem))] = {bound, TheoremRow{row++, theorem}};
    const auto add = [&](std::string_view theorem, const std::vector<NumberedBound>& rows) {
        for (const auto& [number, bound] : rows) {
            if (number >= classes.representatives.size()) continue; // of a shorter list of classes
            const Signature key = constraint_class(classes.representatives[number]);
            bounds[key] = {bound, TheoremRow{row++, theorem}};
        }
    };
    add(theorem_of_common_centres, common_centre_rows());
    add(theorem_of_many_pins, many_pin_rows());
    return bounds;
}

static void add_lower(DegreeBounds& known, const LowerBound& bound) {
    if (bound.solutions < known.at_least) return;
    if (bound.solutions > known.at_least) known.complete = false;
    known.at_least = bound.solutions;
    known.complete |= bound.complete;
}

static void add_upper(DegreeBounds& known, const UpperBound& bound) {
    if (!known.at_most || bound.solutions < known.at_most->solutions) known.at_most = bound;
}

/// The source of an upper bound, the same for problems that all have the same degree.
static BoundSource source(const UpperBound& bound) {
    const auto* theorem = std::get_if<TheoremRow>(&bound.by);
    if (!theorem || theorem->theorem != theorem_of_equal_degrees) return bound.by;
    return TheoremRow{0, theorem->theorem}; // one for all of this theorem, which comes first
}

/// Where one class attains its bound, so do all whose bound has the same source: the degree of an
/// extension of the five-point problem depends on the type of registration only (Proposition U7),
/// and the problems of Theorem U8 have the same degree.
static void spread_attained(DegreeTable& table) {
    std::set<BoundSource> attained;
    for (const auto& [signature, known] : table)
        if (known.exact()) attained.insert(source(*known.at_most));
    for (auto& [signature, known] : table)
        if (known.at_most && attained.contains(source(*known.at_most)))
            known.at_least = std::max(known.at_least, known.at_most->solutions);
}

DegreeTable combine(const Classification& classes, const std::vector<bool>& minimal,
                    const std::vector<LowerBound>& lower, const RegistrationBounds& upper) {
    DegreeTable table;
    for (const LowerBound& bound : lower)
        add_lower(table[constraint_class(classes.representatives[bound.number])], bound);
    const std::map<Signature, UpperBound> theorems = bounds_by_theorem(classes);
    for (std::size_t n = 0; n < minimal.size(); ++n) {
        if (!minimal[n]) continue;
        const Signature& signature = classes.representatives[n];
        const Signature key = constraint_class(signature);
        if (const auto found = bound_by_registration(signature, upper))
            add_upper(table[key], {found->bound, found->type});
        if (const auto bound = theorems.find(key); bound != theorems.end())
            add_upper(table[key], bound->second);
    }
    spread_attained(table);
    return table;
}

DegreeBounds bounds_of(const DegreeTable& table, const Signature& signature) {
    const auto place = table.find(constraint_class(signature));
    return place == table.end() ? DegreeBounds{} : place->second;
}

std::optional<std::string> contradiction(const DegreeTable& table) {
    for (const auto& [signature, known] : table)
        if (known.at_most && known.at_least > known.at_most->solutions)
            return say(notation(signature), " has at least ", known.at_least,
                       " solutions, and at most ", known.at_most->solutions);
    return std::nullopt;
}
} // namespace checker
