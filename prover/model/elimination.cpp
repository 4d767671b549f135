#include "prover/model/elimination.h"

#include "prover/model/grouped_system.h"
#include "prover/model/sparse_rows.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

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
void add_trials(const GroupedSystem& system, std::size_t number, const EliminationLimits& limits,
                std::vector<Trial>& trials) {
    constexpr int largest_degree = 20;
    Degrees degrees(system.groups, 1);
    while (true) {
        const auto monomials = system.monomials(degrees, limits.columns);
        const bool fits = monomials.has_value();
        const auto within = [&](const GroupedEquation& e) { return at_most(e.degrees, degrees); };
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

class Matrix {
public:
    Matrix(const GroupedSystem& system, const Degrees& degrees)
        : system_(system), degrees_(degrees), columns_(*system.monomials(degrees, SIZE_MAX >> 8U)) {
        for (std::size_t i = 0; i < columns_.size(); ++i)
            places_.emplace(columns_[i], i);
        order_.resize(columns_.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        // Eliminated first: what cannot be in the basis, then what has a larger degree.
        std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
            const bool fits_a = fits_basis(a), fits_b = fits_basis(b);
            if (fits_a != fits_b) return fits_b;
            return grevlex_less(columns_[b], columns_[a]);
        });
        rank_.resize(columns_.size());
        for (std::size_t k = 0; k < order_.size(); ++k)
            rank_[order_[k]] = static_cast<std::uint32_t>(k);
    }

    /// The basis, if it may be one and is smaller than `smaller_than`.
    std::optional<Result> eliminate(std::size_t smaller_than) const {
        SparseRows rows(columns_.size());
        Result result;
        for (std::size_t e = 0; e < system_.equations.size(); ++e)
            for (std::size_t column = 0; column < columns_.size(); ++column)
                if (fits(e, column) && rows.reduce_and_add(row(e, column)))
                    result.rows.emplace_back(e, column);
        if (columns_.size() - result.rows.size() >= smaller_than) return std::nullopt;
        for (std::size_t k = 0; k < order_.size(); ++k) {
            if (rows.has_pivot(k)) continue;
            if (!fits_basis(order_[k])) return std::nullopt;
            result.basis.push_back(order_[k]);
        }
        std::ranges::sort(result.basis);
        return result;
    }

    /// The determinant of the rows of a result without the columns of its basis.
    Modular minor(const Result& result) const {
        const auto size = static_cast<int>(result.rows.size());
        std::vector<int> places(columns_.size(), -1);
        int next = 0;
        for (std::size_t column = 0; column < columns_.size(); ++column)
            if (!std::ranges::binary_search(result.basis, column)) places[column] = next++;
        ResidueMatrix square(size, size);
        for (int i = 0; i < size; ++i) {
            const auto& [equation, column] = result.rows[static_cast<std::size_t>(i)];
            for (const Term& term : system_.equations[equation].polynomial.terms()) {
                const int place = places[places_.at(term.monomial * columns_[column])];
                if (place >= 0) square.at(i, place) = term.coefficient.value();
            }
        }
        return Modular::of(nmod_mat_det(square.get()));
    }

private:
    bool fits_basis(std::size_t column) const {
        return std::ranges::equal(system_.degrees_of(columns_[column]), degrees_, std::less{});
    }

    bool fits(std::size_t equation, std::size_t column) const {
        return at_most(
            sum_of(system_.equations[equation].degrees, system_.degrees_of(columns_[column])),
            degrees_);
    }

    /// A multiple of an equation, its columns by the order of elimination.
    SparseRow row(std::size_t equation, std::size_t column) const {
        std::vector<std::pair<std::uint32_t, Modular>> entries;
        for (const Term& term : system_.equations[equation].polynomial.terms())
            entries.emplace_back(rank_[places_.at(term.monomial * columns_[column])],
                                 term.coefficient);
        std::ranges::sort(entries, {}, [](const auto& entry) { return entry.first; });
        SparseRow result;
        for (const auto& [place, entry] : entries) {
            result.columns.push_back(place);
            result.entries.push_back(entry);
        }
        return result;
    }

    const GroupedSystem& system_;
    const Degrees& degrees_;
    std::vector<Monomial> columns_;
    std::unordered_map<Monomial, std::size_t, HashOfMonomial> places_;
    std::vector<std::size_t> order_;  // columns as they are eliminated
    std::vector<std::uint32_t> rank_; // the place of each column in that order
};

Elimination elimination_of(const GroupedSystem& system, const Grouping& grouping,
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
    elimination.minor = Matrix(system, degrees).minor(result);
    return elimination;
}

/// The best of some groupings, as find_elimination says.
std::optional<Elimination> best_of(const Program& program, const std::vector<Grouping>& groupings,
                                   const std::vector<Modular>& data, std::size_t target,
                                   const EliminationLimits& limits) {
    std::vector<Grouping> names;
    std::vector<GroupedSystem> systems;
    std::vector<Trial> trials;
    for (const Grouping& grouping : groupings) {
        auto system = grouped_system(program, data, grouping);
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
        const Matrix matrix(systems[trial.system], trial.degrees);
        if (auto result = matrix.eliminate(smaller_than)) best = {trial, std::move(*result)};
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
    improve(overlapping_groupings(program), small);
    if (best && target == 0) return best; // as good as any, for all that is known
    improve(groupings(program), large);
    improve(groupings(program), largest);
    return best;
}

} // namespace plprove::model
