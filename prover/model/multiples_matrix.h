// The matrix of an elimination: its columns are all monomials up to some degrees, its rows the
// multiples of equations that keep within them.
#pragma once

#include "prover/model/grouped_system.h"
#include "prover/model/sparse_rows.h"

#include <unordered_map>

namespace plprove::model {

/// Columns are numbered from 0, in the order of certs/FORMAT.md. Keeps references to its arguments.
class MultiplesMatrix {
public:
    MultiplesMatrix(const GroupedSystem<Modular>& system, const Degrees& degrees);

    const GroupedSystem<Modular>& system() const { return system_; }
    const std::vector<Monomial>& columns() const { return columns_; }
    /// The number of the column of a monomial within the degrees.
    std::size_t place(const Monomial& monomial) const { return places_.at(monomial); }

    /// Whether a column may be in the basis: all its multiples by variables are columns.
    bool fits_basis(std::size_t column) const;
    /// Whether this multiple of an equation, by number in the system, is a row.
    bool fits(std::size_t equation, std::size_t column) const;

    /// A multiple of an equation, its columns by the order of elimination.
    SparseRow row(std::size_t equation, std::size_t column) const;
    /// The column that is eliminated as the k-th.
    std::size_t column_eliminated(std::size_t k) const { return order_[k]; }

private:
    const GroupedSystem<Modular>& system_;
    const Degrees& degrees_;
    std::vector<Monomial> columns_;
    std::unordered_map<Monomial, std::size_t, HashOfMonomial> places_;
    std::vector<std::size_t> order_;  // columns as they are eliminated
    std::vector<std::uint32_t> rank_; // the place of each column in that order
};

} // namespace plprove::model
