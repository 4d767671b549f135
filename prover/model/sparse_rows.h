// Elimination of sparse rows modulo q, or modulo a small prime. Columns are numbered in the order
// in which they are eliminated; a row has an entry 1 in its first column, its pivot.
#pragma once

#include "prover/geometry/modular.h"
#include "prover/model/small_modular.h"

#include <cstdint>
#include <vector>

namespace plprove::model {

/// The entries of a row other than 0, with ascending columns.
template <class Number>
struct SparseRowOf {
    std::vector<std::uint32_t> columns;
    std::vector<Number> entries;

    bool empty() const { return columns.empty(); }
};

template <class Number>
class SparseRowsOf {
public:
    using Row = SparseRowOf<Number>;

    explicit SparseRowsOf(std::size_t columns) : pivots_(columns), accumulator_(columns) {}

    /// Makes a row, as it is, the pivot of its first column, which has none. Scales it.
    void add_pivot(Row row);
    bool has_pivot(std::size_t column) const { return !pivots_[column].empty(); }
    const Row& pivot(std::size_t column) const { return pivots_[column]; }

    /// The row minus multiples of pivots, without entries in columns that have one. If
    /// `keep_first`, the first column of the row stays, even if it has a pivot.
    Row reduce(const Row& row, bool keep_first = false);

    /// Reduces, and makes what is left a pivot. False if nothing is left.
    bool reduce_and_add(const Row& row);

private:
    std::vector<Row> pivots_;         // by column, empty where there is none
    std::vector<Number> accumulator_; // 0 between calls
};

using SparseRow = SparseRowOf<Modular>;
using SparseRows = SparseRowsOf<Modular>;

} // namespace plprove::model
