#include "prover/model/elimination.h"

#include "prover/model/multiples_matrix.h"

#include <algorithm>

namespace plprove::model {

namespace {

/// A grouping with degrees: what one trial tries.
struct Trial {
    std::size_t system = 0;
    Degrees degrees;
    std::size_t columns = 0;
};

/// What elimination leaves: numbers of columns from 0.
struct Result {
    std::vector<std::size_t> basis;
    std::vector<std::pair<std::size_t, std::size_t>> rows; ///< equation of the system, column
};

/// How far to look for an elimination.
struct EliminationLimits {
    std::size_t columns;
    std::size_t trials; ///< of one grouping of variables
    bool all;           ///< whether all equations must keep within the degrees, or one
};

/// All degrees that the equations keep within.
void add_trials(const GroupedSystem<Modular>& system, std::size_t number,
                const EliminationLimits& limits, std::vector<Trial>& trials) {
    constexpr int largest_degree = 20;
    Degrees degrees(system.variables.groups, 1);
    while (true) {
        const auto monomials = system.variables.monomials(degrees, limits.columns);
        const bool fits = monomials.has_value();
        const auto within = [&](const GroupedEquation<Modular>& e) {
            return at_most(e.degrees, degrees);
        };
        const bool useful = limits.all ? std::ranges::all_of(system.equations, within)
                                       : std::ranges::any_of(system.equations, within);
        if (fits && useful) trials.push_back({number, degrees, monomials->size()});
        // The next degrees: the first that can grow does, those before it begin again.
        std::size_t g = 0;
        if (!fits) { // larger first degrees do not fit either
            while (g < degrees.size() && degrees[g] == 1)
                ++g;
            if (g == degrees.size()) return;
            degrees[g++] = 1;
        }
        while (g < degrees.size() && degrees[g] == largest_degree)
            degrees[g++] = 1;
        if (g == degrees.size()) return;
        ++degrees[g];
    }
}

/// The basis, if it may be one and is smaller than `smaller_than`.
std::optional<Result> eliminate(const MultiplesMatrix& matrix, std::size_t smaller_than) {
    SparseRows rows(matrix.columns().size());
    Result result;
    for (std::size_t e = 0; e < matrix.system().equations.size(); ++e)
        for (std::size_t column = 0; column < matrix.columns().size(); ++column)
            if (matrix.fits(e, column) && rows.reduce_and_add(matrix.row(e, column)))
                result.rows.emplace_back(e, column);
    if (matrix.columns().size() - result.rows.size() >= smaller_than) return std::nullopt;
    for (std::size_t k = 0; k < matrix.columns().size(); ++k) {
        if (rows.has_pivot(k)) continue;
        const std::size_t column = matrix.column_eliminated(k);
        if (!matrix.fits_basis(column)) return std::nullopt;
        result.basis.push_back(column);
    }
    std::ranges::sort(result.basis);
    return result;
}

/// The determinant of the rows of a result without the columns of its basis.
Modular minor(const MultiplesMatrix& matrix, const Result& result) {
    const auto size = static_cast<int>(result.rows.size());
    std::vector<int> places(matrix.columns().size(), -1);
    int next = 0;
    for (std::size_t column = 0; column < places.size(); ++column)
        if (!std::ranges::binary_search(result.basis, column)) places[column] = next++;
    ResidueMatrix square(size, size);
    for (int i = 0; i < size; ++i) {
        const auto& [equation, column] = result.rows[static_cast<std::size_t>(i)];
        for (const Term& term : matrix.system().equations[equation].polynomial.terms()) {
            const int place = places[matrix.place(term.monomial * matrix.columns()[column])];
            if (place >= 0) square.at(i, place) = term.coefficient.value();
        }
    }
    return Modular::of(nmod_mat_det(square.get()));
}

Elimination elimination_of(const GroupedSystem<Modular>& system, const Grouping& grouping,
                           const Degrees& degrees, const Result& result,
                           const std::vector<Modular>& data) {
    Elimination elimination;
    elimination.data = data;
    for (std::size_t g = 0; g < grouping.size(); ++g)
        elimination.groups.push_back({degrees[g], grouping[g]});
    for (const std::size_t column : result.basis)
        elimination.basis.push_back(column + 1);
    for (const auto& [equation, column] : result.rows) {
        const std::size_t number = system.equations[equation].number;
        if (elimination.rows.empty() || elimination.rows.back().first != number)
            elimination.rows.push_back({number, {}});
        elimination.rows.back().second.push_back(column + 1);
    }
    elimination.minor = minor(MultiplesMatrix(system, degrees), result);
    return elimination;
}

/// The best of some groupings, as find_elimination says.
std::optional<Elimination> best_of(const Program& program, const std::vector<Grouping>& groupings,
                                   const std::vector<Modular>& data, std::size_t target,
                                   const EliminationLimits& limits) {
    std::vector<Grouping> names;
    std::vector<GroupedSystem<Modular>> systems;
    std::vector<Trial> trials;
    for (const Grouping& grouping : groupings) {
        auto system = grouped_system(program, std::span(data), grouping);
        if (!system) continue;
        add_trials(*system, systems.size(), limits, trials);
        systems.push_back(std::move(*system));
        names.push_back(grouping);
    }
    std::ranges::stable_sort(trials, {}, &Trial::columns);
    std::vector<std::size_t> tried(systems.size());
    std::erase_if(trials,
                  [&](const Trial& trial) { return ++tried[trial.system] > limits.trials; });
    std::optional<std::pair<Trial, Result>> best;
    for (const Trial& trial : trials) {
        const std::size_t smaller_than = best ? best->second.basis.size() : SIZE_MAX;
        const MultiplesMatrix matrix(systems[trial.system], trial.degrees);
        if (auto result = eliminate(matrix, smaller_than)) best = {trial, std::move(*result)};
        if (best && best->second.basis.size() <= target) break;
    }
    if (!best) return std::nullopt;
    const auto& [trial, result] = *best;
    return elimination_of(systems[trial.system], names[trial.system], trial.degrees, result, data);
}

} // namespace

std::optional<Elimination> find_elimination(const Model& model, const Program& program,
                                            std::size_t target) {
    constexpr std::uint64_t stream = 2;
    RandomResidues random(model, stream);
    const std::vector<Modular> data = random.residues(program.data);
    constexpr EliminationLimits small{600, 60, false}, large{2500, 20, true},
        largest{4000, 5, true};
    std::optional<Elimination> best;
    const auto improve = [&](const std::vector<Grouping>& groupings,
                             const EliminationLimits& limits) {
        if (best && best->basis.size() <= target) return;
        auto found = best_of(program, groupings, data, target, limits);
        if (found && (!best || found->basis.size() < best->basis.size())) best = std::move(found);
    };
    improve(groupings(program), small);
    improve(groupings_in_two(program), small);
    if (!best) improve(weighted_groupings(program), small);
    if (best && target == 0) return best; // as good as any, for all that is known
    improve(groupings(program), large);
    improve(groupings(program), largest);
    return best;
}

} // namespace plprove::model
