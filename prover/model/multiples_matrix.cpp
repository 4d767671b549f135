#include "prover/model/multiples_matrix.h"

#include <algorithm>
#include <numeric>

namespace plprove::model {

MultiplesMatrix::MultiplesMatrix(const GroupedSystem<Modular>& system, const Degrees& degrees)
    : system_(system), degrees_(degrees),
      columns_(*system.variables.monomials(degrees, SIZE_MAX >> 8U)) {
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

bool MultiplesMatrix::fits_basis(std::size_t column) const {
    const Degrees own = system_.variables.degrees_of(columns_[column]);
    return std::ranges::all_of(system_.variables.units, [&](const Degrees& unit) {
        return at_most(sum_of(own, unit), degrees_);
    });
}

bool MultiplesMatrix::fits(std::size_t equation, std::size_t column) const {
    return at_most(
        sum_of(system_.equations[equation].degrees, system_.variables.degrees_of(columns_[column])),
        degrees_);
}

SparseRow MultiplesMatrix::row(std::size_t equation, std::size_t column) const {
    std::vector<std::pair<std::uint32_t, Modular>> entries;
    for (const Term& term : system_.equations[equation].polynomial.terms())
        entries.emplace_back(rank_[place(term.monomial * columns_[column])], term.coefficient);
    std::ranges::sort(entries, {}, [](const auto& entry) { return entry.first; });
    SparseRow result;
    for (const auto& [place, entry] : entries) {
        result.columns.push_back(place);
        result.entries.push_back(entry);
    }
    return result;
}

} // namespace plprove::model
