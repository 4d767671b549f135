#include "checker/model/elimination.h"

#include "checker/minimal/record_lines.h"

namespace checker {
using Residues = SparsePolynomials<Residue>;
using Rationals = SparsePolynomials<mpq_class>;

static constexpr std::size_t most_columns = 4000;

static bool is_known(const Declared& declared, std::string_view name) {
    return std::ranges::any_of(declared.names, [&](const auto& own) { return own.first == name; });
}

/// How many times a group has the name: the degree that its variables have there.
static int times(const Elimination::Group& group, const std::string& name) {
    return static_cast<int>(std::ranges::count(group.names, name));
}

/// Takes the groups: of names of unknowns, and of `let` statements outside of loops.
static std::vector<Elimination::Group> read_groups(Reader& reader, const Layout& layout) {
    std::vector<Elimination::Group> groups;
    while (groups.empty() || reader.comes("degree")) {
        reader.take("degree");
        Elimination::Group group{.degree = reader.small_integer(1, 20)};
        reader.take("in");
        do {
            const std::string name(reader.word());
            if (!layout.values.contains(name) || is_known(layout.data, name))
                reader.fail(name, "an unknown, or the name of a `let` statement");
            group.names.push_back(name);
        } while (!reader.at_end());
        reader.end_line();
        groups.push_back(std::move(group));
    }
    return groups;
}

/// The variables of an elimination: those of the names, as these come first.
struct Variables {
    std::vector<std::string> names{};
    std::vector<std::vector<int>> degrees{}; // of each variable, by groups
};

static Variables variables_of(const Layout& layout, const Elimination& elimination) {
    Variables variables;
    for (const Elimination::Group& group : elimination.groups)
        for (const std::string& name : group.names) {
            if (std::ranges::count(variables.names, name) > 0) continue;
            variables.names.push_back(name);
            std::vector<int> degrees;
            for (const Elimination::Group& other : elimination.groups)
                degrees.push_back(times(other, name));
            for (std::size_t i = 0; i < layout.values.at(name); ++i)
                variables.degrees.push_back(degrees);
        }
    return variables;
}

Elimination read_elimination(Reader& reader, const Layout& layout) {
    Elimination result;
    reader.take("elimination $");
    result.data = read_residue_line(reader, "data", layout.data.scalars);
    result.groups = read_groups(reader, layout);
    reader.take("basis");
    if (!reader.at_end()) result.basis = read_ascending(reader, 999'999);
    reader.end_line();
    int last = 0; // equation
    while (result.rows.empty() || reader.comes("rows")) {
        reader.take("rows");
        last = reader.small_integer(last + 1, 999'999);
        result.rows.push_back(
            {static_cast<std::size_t>(last) - 1, read_ascending(reader, 999'999)});
        reader.end_line();
    }
    reader.take("minor");
    result.minor = read_minor(reader);
    return result;
}

/// Throws Refused if a relation of the model is no identity.
static void require_relations(const Program& program, const Layout& layout,
                              const Residues::Spend& spend) {
    if (layout.relations == 0) return;
    Rationals ring(1, spend);
    Given<Rationals> given;
    std::size_t next = 0;
    for (const Declared* declared : {&layout.data, &layout.unknowns})
        for (const auto& [name, size] : declared->names)
            for (std::size_t i = 0; i < size; ++i)
                given[name].push_back(ring.variable(next++, {1}));
    const Outcome<Rationals> outcome = Machine<Rationals>(ring, given).run(program);
    for (std::size_t i = 0; i < outcome.relations.size(); ++i)
        if (!outcome.relations[i].terms.empty())
            throw Refused("relation ", i + 1, " does not hold for all data and unknowns");
}

/// The values of names: data, variables, and unknowns that are none.
static Given<Residues> values_for(const Residues& ring, const Layout& layout,
                                  const Elimination& elimination, const Variables& variables) {
    Given<Residues> given;
    std::size_t next = 0;
    for (const auto& [name, size] : layout.data.names)
        for (std::size_t i = 0; i < size; ++i)
            given[name].push_back(ring.value(elimination.data[next++]));
    for (const auto& [name, size] : layout.unknowns.names)
        given[name].assign(size, ring.foreign());
    next = 0;
    for (const std::string& name : variables.names) {
        given[name].clear();
        for (std::size_t i = 0; i < layout.values.at(name); ++i, ++next)
            given[name].push_back(ring.variable(next, variables.degrees[next]));
    }
    return given;
}

/// Throws Refused if the variables do not determine what counts.
static void require_determined(const Layout& layout, const Variables& variables,
                               const Outcome<Residues>& outcome) {
    bool determined = true;
    for (const Fraction<Residues::Element>& scalar : outcome.counted) {
        determined &= !scalar.numerator.is_foreign;
        for (const auto& [divisor, power] : scalar.denominator)
            determined &= !outcome.divisors[divisor].is_foreign;
    }
    for (const auto& [name, size] : layout.unknowns.names)
        determined &= layout.counted > 0 || std::ranges::count(variables.names, name) > 0;
    if (!determined) throw Refused("what counts is not given by the variables");
}

/// All monomials within the degrees of the groups, in ascending lexicographic order; and how large
/// their degrees are.
struct Columns {
    std::vector<Powers> monomials{};
    std::vector<std::vector<int>> degrees{};
};

/// Whether degrees are at most those of the groups.
static bool is_within(const std::vector<int>& degrees, const Elimination& elimination) {
    for (std::size_t g = 0; g < degrees.size(); ++g)
        if (degrees[g] > elimination.groups[g].degree) return false;
    return true;
}

static std::vector<int> sum_of(std::vector<int> a, const std::vector<int>& b) {
    for (std::size_t g = 0; g < a.size(); ++g)
        a[g] += b[g];
    return a;
}

static Columns columns_of(const Elimination& elimination, const Variables& variables) {
    Columns columns{{{}}, {std::vector<int>(elimination.groups.size())}};
    for (const std::vector<int>& own : variables.degrees) {
        Columns longer;
        for (std::size_t i = 0; i < columns.monomials.size(); ++i) {
            std::vector<int> degrees = columns.degrees[i];
            for (std::uint8_t power = 0; is_within(degrees, elimination); ++power) {
                longer.monomials.push_back(columns.monomials[i]);
                longer.monomials.back().push_back(power);
                longer.degrees.push_back(degrees);
                if (longer.monomials.size() > most_columns)
                    throw Refused("there are more than ", most_columns, " columns");
                degrees = sum_of(std::move(degrees), own);
            }
        }
        columns = std::move(longer);
    }
    return columns;
}

static Powers trimmed(Powers powers) {
    while (!powers.empty() && powers.back() == 0)
        powers.pop_back();
    return powers;
}

/// Throws Refused if the degrees are not within those of the groups.
static void require_within(const std::vector<int>& degrees, const Elimination& elimination,
                           std::string_view what) {
    if (!is_within(degrees, elimination))
        throw Refused(what, " has a larger degree than that of a group");
}

/// The number of a monomial from 1, as an index.
static std::size_t place_in(const Columns& columns, int number) {
    if (static_cast<std::size_t>(number) > columns.monomials.size())
        throw Refused("there is no monomial ", number);
    return static_cast<std::size_t>(number) - 1;
}

/// The columns that are not in the basis, by their monomials, numbered in their order.
static std::map<Powers, std::size_t> columns_beside_basis(const Columns& columns,
                                                          const Elimination& elimination,
                                                          const Variables& variables) {
    std::vector<bool> in_basis(columns.monomials.size());
    for (const int number : elimination.basis) {
        const std::size_t place = place_in(columns, number);
        for (const std::vector<int>& degrees : variables.degrees)
            require_within(sum_of(columns.degrees[place], degrees), elimination,
                           "a monomial of the basis, times a variable,");
        in_basis[place] = true;
    }
    std::map<Powers, std::size_t> numbers;
    for (std::size_t i = 0; i < columns.monomials.size(); ++i)
        if (!in_basis[i]) numbers.emplace(trimmed(columns.monomials[i]), numbers.size());
    return numbers;
}

/// The equations, and those of relations after them.
static std::vector<Residues::Element> equations_of(Outcome<Residues>& outcome) {
    std::vector<Residues::Element> all = std::move(outcome.equations);
    all.insert(all.end(), outcome.relations.begin(), outcome.relations.end());
    return all;
}

std::size_t check_elimination(const Program& program, const Layout& layout,
                              const Elimination& elimination, const Residues::Spend& spend) {
    require_relations(program, layout, spend);
    Residues ring(elimination.groups.size(), spend);
    const Variables variables = variables_of(layout, elimination);
    const Given<Residues> given = values_for(ring, layout, elimination, variables);
    Outcome<Residues> outcome = Machine<Residues>(ring, given).run(program);
    require_determined(layout, variables, outcome);
    const std::vector<Residues::Element> equations = equations_of(outcome);
    const Columns columns = columns_of(elimination, variables);
    const auto numbers = columns_beside_basis(columns, elimination, variables);
    const std::uint64_t size = numbers.size();
    spend(size * size * size / 3);
    // Filled from its last row and column on, which changes no determinant: so each row begins with
    // the largest monomials, and elimination leaves most entries 0.
    SquareMatrix matrix(numbers.size());
    const std::size_t last = numbers.size() - 1;
    std::size_t row = 0;
    for (const auto& [equation, monomials] : elimination.rows) {
        if (equation >= equations.size()) throw Refused("there is no equation ", equation + 1);
        const Residues::Element& own = equations[equation];
        if (own.is_foreign)
            throw Refused("equation ", equation + 1, " has an unknown that is no variable");
        for (const int number : monomials) {
            const std::size_t place = place_in(columns, number);
            if (own.degrees)
                require_within(sum_of(columns.degrees[place], *own.degrees), elimination,
                               say("a multiple of equation ", equation + 1));
            if (row == numbers.size()) throw Refused("there are more rows than columns");
            for (const auto& [powers, coefficient] : own.terms) {
                const Powers shifted = trimmed(product_of(powers, columns.monomials[place]));
                if (const auto column = numbers.find(shifted); column != numbers.end())
                    matrix[last - row][last - column->second] = coefficient;
            }
            ++row;
        }
    }
    if (row < numbers.size()) throw Refused("there are fewer rows than columns");
    const Residue minor = determinant(std::move(matrix));
    if (minor != elimination.minor) throw Refused("the minor is ", minor.value, " modulo q");
    return elimination.basis.size();
}
} // namespace checker
