#include "prover/model/grouped_system.h"

#include <algorithm>
#include <set>

namespace plprove::model {

namespace {

const Array& array_of(const Program& program, const std::string& name) {
    for (const auto* list : {&program.unknown_names, &program.lets})
        for (const Named& named : *list)
            if (named.name == name) return named.value;
    throw std::logic_error("no unknown and no let has the name " + name);
}

bool is_group_name(const Program& program, const std::string& name) {
    for (const auto* list : {&program.unknown_names, &program.lets})
        for (const Named& named : *list)
            if (named.name == name) return true;
    return false;
}

/// The scalars that count: those of `count` statements, or all unknowns.
std::vector<ScalarIndex> counted(const Program& program) {
    if (program.counts) return program.counted;
    std::vector<ScalarIndex> result;
    for (const Named& named : program.unknown_names)
        result.insert(result.end(), named.value.scalars.begin(), named.value.scalars.end());
    return result;
}

/// The names without those that data and the names before them determine.
std::vector<std::string> independent(const Program& program,
                                     const std::vector<std::string>& names) {
    std::vector<std::string> result;
    std::map<ScalarIndex, bool> given;
    for (const std::string& name : names) {
        if (!is_group_name(program, name)) continue;
        const std::vector<ScalarIndex>& scalars = array_of(program, name).scalars;
        const std::vector<bool> needed = needed_operations(program, scalars, given);
        bool has_unknowns = false;
        for (std::size_t i = 0; i < needed.size(); ++i)
            has_unknowns = has_unknowns || (needed[i] && !given.contains(i) &&
                                            program.operations[i].kind == Operation::Kind::unknown);
        if (!has_unknowns) continue;
        result.push_back(name);
        for (const ScalarIndex scalar : scalars)
            given.emplace(scalar, true);
    }
    return result;
}

void add_groupings(const std::vector<std::string>& names, std::set<Grouping>& known,
                   std::vector<Grouping>& all) {
    if (names.empty()) return;
    Grouping apart;
    for (const std::string& name : names)
        apart.push_back({name});
    for (const Grouping& grouping : {Grouping{names}, apart})
        if (known.insert(grouping).second) all.push_back(grouping);
}

} // namespace

Degrees GroupedSystem::degrees_of(const Monomial& monomial) const {
    Degrees result(groups);
    for (std::size_t v = 0; v < group_of.size(); ++v)
        result[group_of[v]] += monomial.exponents[v];
    return result;
}

std::size_t GroupedSystem::count_monomials(const Degrees& degrees, std::size_t most) const {
    std::size_t count = 1;
    for (std::size_t g = 0; g < groups; ++g) {
        // Binomial coefficient (n + d choose d), n the number of variables.
        const auto n = static_cast<std::size_t>(std::ranges::count(group_of, g));
        std::size_t binomial = 1;
        for (std::size_t i = 1; i <= static_cast<std::size_t>(degrees[g]); ++i) {
            binomial = binomial * (n + i) / i;
            if (binomial > most) return most + 1;
        }
        count *= binomial;
        if (count > most) return most + 1;
    }
    return count;
}

std::optional<std::vector<Monomial>> GroupedSystem::monomials(const Degrees& degrees,
                                                              std::size_t most) const {
    if (count_monomials(degrees, most) > most) return std::nullopt;
    std::vector<Monomial> result{{}};
    for (std::size_t v = 0; v < group_of.size(); ++v) {
        std::vector<Monomial> longer;
        for (Monomial monomial : result)
            for (int left = degrees[group_of[v]] - degrees_of(monomial)[group_of[v]]; left >= 0;
                 --left) {
                longer.push_back(monomial);
                ++monomial.exponents[v];
            }
        result = std::move(longer);
    }
    std::ranges::sort(result);
    return result;
}

bool at_most(const Degrees& a, const Degrees& b) {
    return std::ranges::equal(a, b, std::less_equal{});
}

Degrees sum_of(const Degrees& a, const Degrees& b) {
    Degrees result = a;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += b[i];
    return result;
}

std::vector<Grouping> groupings(const Program& program) {
    std::vector<std::string> unknowns;
    for (const Named& named : program.unknown_names)
        unknowns.push_back(named.name);
    std::vector<Grouping> all;
    std::set<Grouping> known;
    for (const std::vector<std::string>* names :
         {&program.counted_names, &program.related, &std::as_const(unknowns)}) {
        add_groupings(independent(program, *names), known, all);
        std::vector<std::string> with_unknowns = unknowns;
        with_unknowns.insert(with_unknowns.end(), names->begin(), names->end());
        add_groupings(independent(program, with_unknowns), known, all);
    }
    return all;
}

std::optional<GroupedSystem> grouped_system(const Program& program, std::span<const Modular> data,
                                            const Grouping& grouping) {
    GroupedSystem system;
    system.groups = grouping.size();
    FractionRing ring(data, grouping.size());
    std::map<ScalarIndex, Fraction> variables;
    for (std::size_t group = 0; group < grouping.size(); ++group)
        for (const std::string& name : grouping[group])
            for (const ScalarIndex scalar : array_of(program, name).scalars) {
                if (system.group_of.size() == most_variables) return std::nullopt;
                variables.emplace(scalar, ring.variable(system.group_of.size(), group));
                system.group_of.push_back(group);
            }
    std::vector<ScalarIndex> equations = scalars_of(program.equations);
    for (const ScalarIndex scalar : scalars_of(program.relations))
        equations.push_back(scalar);
    std::vector<ScalarIndex> wanted = counted(program);
    wanted.insert(wanted.end(), equations.begin(), equations.end());
    const auto values = evaluate(program, ring, wanted, variables);
    for (const ScalarIndex scalar : counted(program))
        if (values[scalar].foreign) return std::nullopt;
    for (std::size_t i = 0; i < equations.size(); ++i) {
        const Fraction& value = values[equations[i]];
        if (value.foreign || value.numerator.is_zero() || !value.degrees) continue;
        system.equations.push_back({i + 1, value.numerator, *value.degrees});
    }
    return system;
}

} // namespace plprove::model
