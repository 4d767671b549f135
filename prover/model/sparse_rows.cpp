#include "prover/model/sparse_rows.h"

#include <utility>

namespace plprove::model {

template <class Number>
void SparseRowsOf<Number>::add_pivot(Row row) {
    const Number scale = row.entries.front().inverse();
    for (Number& entry : row.entries)
        entry = entry * scale;
    const std::size_t column = row.columns.front();
    pivots_[column] = std::move(row);
}

template <class Number>
SparseRowOf<Number> SparseRowsOf<Number>::reduce(const Row& row, bool keep_first) {
    Row rest;
    if (row.empty()) return rest;
    for (std::size_t i = 0; i < row.columns.size(); ++i)
        accumulator_[row.columns[i]] = row.entries[i];
    for (std::size_t column = row.columns.front(); column < accumulator_.size(); ++column) {
        const Number entry = std::exchange(accumulator_[column], Number{});
        if (entry.is_zero()) continue;
        const Row& pivot = pivots_[column];
        if (pivot.empty() || (keep_first && column == row.columns.front())) {
            rest.columns.push_back(static_cast<std::uint32_t>(column));
            rest.entries.push_back(entry);
            continue;
        }
        const Number factor = -entry;
        for (std::size_t i = 1; i < pivot.columns.size(); ++i) {
            Number& place = accumulator_[pivot.columns[i]];
            place = place + factor * pivot.entries[i];
        }
    }
    return rest;
}

template <class Number>
bool SparseRowsOf<Number>::reduce_and_add(const Row& row) {
    Row rest = reduce(row);
    if (rest.empty()) return false;
    add_pivot(std::move(rest));
    return true;
}

template class SparseRowsOf<Modular>;
template class SparseRowsOf<SmallModular>;

} // namespace plprove::model
