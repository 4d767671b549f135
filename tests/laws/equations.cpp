#include "tests/laws/equations.h"

#include <algorithm>
#include <set>

namespace laws {

namespace {

std::vector<Equation::Entry> entries_of(const Relation& relation, const Product& factor,
                                        const DegreeForm& form) {
    std::map<std::size_t, std::int64_t> coefficients;
    for (const Term& term : relation.terms)
        if (const auto index = form.class_of(term.product * factor))
            coefficients[*index] += term.coefficient;
    std::vector<Equation::Entry> entries;
    for (const auto& [index, coefficient] : coefficients)
        if (coefficient != 0) entries.push_back({index, coefficient});
    return entries;
}

} // namespace

std::vector<Equation> equations(const std::vector<Relation>& relations, const DegreeForm& form) {
    std::vector<Equation> all;
    std::set<std::vector<Equation::Entry>> known;
    for (std::size_t r = 0; r < relations.size(); ++r)
        for (const Product& factor : products(checker::camera_unknowns - relations[r].weight)) {
            std::vector<Equation::Entry> entries = entries_of(relations[r], factor, form);
            if (!entries.empty() && known.insert(entries).second)
                all.push_back({r, std::move(entries)});
        }
    return all;
}

std::int64_t residual(const Equation& equation, const DegreeForm& form) {
    std::int64_t sum = 0;
    for (const Equation::Entry& entry : equation.entries)
        sum += entry.coefficient * form.classes()[entry.constraint_class].degree;
    return sum;
}

std::vector<std::size_t> failures(const std::vector<Equation>& equations, const DegreeForm& form) {
    std::vector<std::size_t> failed;
    for (std::size_t i = 0; i < equations.size(); ++i)
        if (residual(equations[i], form) != 0) failed.push_back(i);
    return failed;
}

namespace {

/// The coefficient of a class in an equation; 0 if it does not contain the class.
std::int64_t coefficient_of(const Equation& equation, std::size_t constraint_class) {
    const auto found =
        std::ranges::find(equation.entries, constraint_class, &Equation::Entry::constraint_class);
    return found == equation.entries.end() ? 0 : found->coefficient;
}

/// Whether an error of this size in the degree of the class is what all equations show.
bool explains(std::size_t constraint_class, std::int64_t error,
              const std::vector<Equation>& equations, const DegreeForm& form) {
    return std::ranges::all_of(equations, [&](const Equation& equation) {
        return residual(equation, form) == coefficient_of(equation, constraint_class) * error;
    });
}

} // namespace

std::vector<Suspect> single_mistakes(const std::vector<Equation>& equations,
                                     const std::vector<std::size_t>& failed,
                                     const DegreeForm& form) {
    std::vector<Suspect> suspects;
    if (failed.empty()) return suspects;
    const Equation& first = equations[failed.front()];
    const std::int64_t excess = residual(first, form);
    for (const Equation::Entry& entry : first.entries) {
        if (excess % entry.coefficient != 0) continue;
        const std::int64_t error = excess / entry.coefficient;
        if (explains(entry.constraint_class, error, equations, form))
            suspects.push_back(
                {entry.constraint_class, form.classes()[entry.constraint_class].degree - error});
    }
    return suspects;
}

std::vector<std::size_t> classes_in_most(const std::vector<Equation>& equations,
                                         const std::vector<std::size_t>& failed, std::size_t most) {
    std::map<std::size_t, std::size_t> counts;
    for (const std::size_t index : failed)
        for (const Equation::Entry& entry : equations[index].entries)
            ++counts[entry.constraint_class];
    std::vector<std::size_t> classes;
    for (const auto& [index, count] : counts)
        classes.push_back(index);
    std::ranges::stable_sort(
        classes, [&](std::size_t a, std::size_t b) { return counts.at(a) > counts.at(b); });
    classes.resize(std::min(classes.size(), most));
    return classes;
}

std::vector<bool> guarded_by_equations(const std::vector<Equation>& equations,
                                       std::size_t classes) {
    std::vector<bool> guarded(classes, false);
    for (const Equation& equation : equations)
        for (const Equation::Entry& entry : equation.entries)
            guarded[entry.constraint_class] = true;
    return guarded;
}

} // namespace laws
