#include "prover/model/sparse_rows.h"

#include <utility>

namespace plprove::model {

void SparseRows::add_pivot(SparseRow row) {
    const Modular scale = row.entries.front().inverse();
    for (Modular& entry : row.entries)
        entry = entry * scale;
    const std::size_t column = row.columns.front();
    pivots_[column] = std::move(row);
}

SparseRow SparseRows::reduce(const SparseRow& row, bool keep_first) {
    SparseRow rest;
    if (row.empty()) return rest;
    for (std::size_t i = 0; i < row.columns.size(); ++i)
        accumulator_[row.columns[i]] = row.entries[i];
    for (std::size_t column = row.columns.front(); column < accumulator_.size(); ++column) {
        const Modular entry = std::exchange(accumulator_[column], Modular{});
        if (entry.is_zero()) continue;
        const SparseRow& pivot = pivots_[column];
        if (pivot.empty() || (keep_first && column == row.columns.front())) {
            rest.columns.push_back(static_cast<std::uint32_t>(column));
            rest.entries.push_back(entry);
            continue;
        }
        const Modular factor = -entry;
        for (std::size_t i = 1; i < pivot.columns.size(); ++i) {
            Modular& place = accumulator_[pivot.columns[i]];
            place = place + factor * pivot.entries[i];
        }
    }
    return rest;
}

bool SparseRows::reduce_and_add(const SparseRow& row) {
    SparseRow rest = reduce(row);
    if (rest.empty()) return false;
    add_pivot(std::move(rest));
    return true;
}

} // namespace plprove::model
