#include "prover/model/grouped_system.h"

#include <algorithm>
#include <map>

namespace plprove::model {

namespace {

using Names = std::vector<std::string>;

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
Names independent(const Program& program, const Names& names) {
    Names result;
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

/// The lists of names whose scalars may be the variables.
std::vector<Names> lists_of_names(const Program& program) {
    Names unknowns;
    for (const Named& named : program.unknown_names)
        unknowns.push_back(named.name);
    std::vector<Names> all;
    for (const Names& names : {program.counted_names, program.related, unknowns}) {
        Names with_unknowns = names;
        with_unknowns.insert(with_unknowns.end(), unknowns.begin(), unknowns.end());
        for (const Names& list : {names, with_unknowns}) {
            Names found = independent(program, list);
            if (!found.empty() && std::ranges::find(all, found) == all.end())
                all.push_back(std::move(found));
        }
    }
    return all;
}

GroupedVariables variables_of(const Program& program, const Grouping& grouping) {
    GroupedVariables variables;
    variables.groups = grouping.size();
    for (const std::string& name : variable_names(grouping)) {
        Degrees unit;
        for (const Names& group : grouping)
            unit.push_back(static_cast<int>(std::ranges::count(group, name)));
        variables.units.resize(variables.units.size() + array_of(program, name).scalars.size(),
                               unit);
    }
    return variables;
}

/// The groupings in `groups` groups, none empty, where each name is in each at most `most` times,
/// and in one of them at least once. Of two that differ by the order of the groups, one.
std::vector<Grouping> with_times(const Names& names, std::size_t groups, std::size_t most) {
    std::vector<Grouping> all;
    const std::size_t places = names.size() * groups;
    std::vector<std::size_t> times(places); // of each name in each group
    while (true) {
        Grouping grouping(groups);
        bool each_somewhere = true;
        for (std::size_t i = 0; i < names.size(); ++i) {
            bool somewhere = false;
            for (std::size_t g = 0; g < groups; ++g) {
                const std::size_t n = times[i * groups + g];
                grouping[g].insert(grouping[g].end(), n, names[i]);
                somewhere = somewhere || n > 0;
            }
            each_somewhere = each_somewhere && somewhere;
        }
        const bool none_empty = std::ranges::none_of(grouping, &Names::empty);
        if (each_somewhere && none_empty && std::ranges::is_sorted(grouping))
            all.push_back(std::move(grouping));
        std::size_t place = 0;
        while (place < places && times[place] == most)
            times[place++] = 0;
        if (place == places) return all;
        ++times[place];
    }
}

/// Whether a name is several times in a group.
bool has_weights(const Grouping& grouping) {
    return std::ranges::any_of(grouping, [](const Names& group) {
        return std::ranges::adjacent_find(group) != group.end();
    });
}

} // namespace

const Array& array_of(const Program& program, const std::string& name) {
    for (const auto* list : {&program.unknown_names, &program.lets})
        for (const Named& named : *list)
            if (named.name == name) return named.value;
    throw std::logic_error("no unknown and no let has the name " + name);
}

Degrees GroupedVariables::degrees_of(const Monomial& monomial) const {
    Degrees result(groups);
    for (std::size_t v = 0; v < units.size(); ++v)
        for (std::size_t g = 0; g < groups && monomial.exponents[v] > 0; ++g)
            result[g] += units[v][g] * monomial.exponents[v];
    return result;
}

std::optional<std::vector<Monomial>> GroupedVariables::monomials(const Degrees& degrees,
                                                                 std::size_t most) const {
    std::vector<std::pair<Monomial, Degrees>> found{{{}, Degrees(groups)}};
    for (std::size_t v = 0; v < units.size(); ++v) {
        std::vector<std::pair<Monomial, Degrees>> longer;
        for (auto [monomial, has] : found)
            for (; at_most(has, degrees); has = sum_of(has, units[v])) {
                longer.emplace_back(monomial, has);
                ++monomial.exponents[v];
            }
        found = std::move(longer);
        if (found.size() > most) return std::nullopt;
    }
    std::vector<Monomial> result;
    for (const auto& item : found)
        result.push_back(item.first);
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
    std::vector<Grouping> all;
    for (const Names& names : lists_of_names(program)) {
        Grouping apart;
        for (const std::string& name : names)
            apart.push_back({name});
        for (const Grouping& grouping : {Grouping{names}, apart})
            if (std::ranges::find(all, grouping) == all.end()) all.push_back(grouping);
    }
    return all;
}

std::vector<Grouping> groupings_in_two(const Program& program) {
    constexpr std::size_t most_names = 5;
    std::vector<Grouping> all;
    for (const Names& names : lists_of_names(program)) {
        if (names.size() < 2 || names.size() > most_names) continue;
        for (const Grouping& grouping : with_times(names, 2, 1)) {
            // That of two names apart is among the groupings above.
            const bool is_new = names.size() > 2 || grouping[0].size() + grouping[1].size() > 2;
            if (is_new && std::ranges::find(all, grouping) == all.end()) all.push_back(grouping);
        }
    }
    return all;
}

std::vector<Grouping> weighted_groupings(const Program& program) {
    std::vector<Grouping> all;
    const auto add = [&](const std::vector<Grouping>& groupings) {
        for (const Grouping& grouping : groupings)
            if (has_weights(grouping) && std::ranges::find(all, grouping) == all.end())
                all.push_back(grouping);
    };
    for (const Names& names : lists_of_names(program)) {
        if (names.size() >= 2 && names.size() <= 4) add(with_times(names, 1, 3));
        if (names.size() >= 2 && names.size() <= 3) add(with_times(names, 2, 2));
    }
    return all;
}

std::vector<std::string> variable_names(const Grouping& grouping) {
    std::vector<std::string> names;
    for (const auto& group : grouping)
        for (const std::string& name : group)
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

template <class Coefficient>
std::optional<GroupedSystem<Coefficient>> grouped_system(const Program& program,
                                                         std::span<const Coefficient> data,
                                                         const Grouping& grouping) {
    GroupedSystem<Coefficient> system;
    system.variables = variables_of(program, grouping);
    if (system.variables.units.size() > most_variables) return std::nullopt;
    FractionRing<Coefficient> ring(data, grouping.size());
    std::map<ScalarIndex, Fraction<Coefficient>> variables;
    std::size_t next = 0;
    for (const std::string& name : variable_names(grouping))
        for (const ScalarIndex scalar : array_of(program, name).scalars) {
            variables.emplace(scalar, ring.variable(next, system.variables.units[next]));
            ++next;
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
        const Fraction<Coefficient>& value = values[equations[i]];
        if (value.foreign || value.numerator.is_zero() || !value.degrees) continue;
        system.equations.push_back({i + 1, value.numerator, *value.degrees});
    }
    return system;
}

template std::optional<GroupedSystem<Modular>>
grouped_system(const Program&, std::span<const Modular>, const Grouping&);
template std::optional<GroupedSystem<DataPolynomial>>
grouped_system(const Program&, std::span<const DataPolynomial>, const Grouping&);

} // namespace plprove::model
