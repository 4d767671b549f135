#include "checker/general_bounds/small_field.h"

#include <algorithm>

namespace checker {
void RowSpace::reduce(Rest& rest, const Reduced& by) {
    const std::uint32_t factor = (-Small::of(rest[by.pivot])).value;
    if (factor == 0) return;
    for (std::size_t k = by.pivot; k < rest.size(); ++k)
        rest[k] =
            (rest[k] & small_prime) + (rest[k] >> 31) + std::uint64_t{factor} * by.row[k].value;
}

/// Adds a row that is reduced by all rows.
bool RowSpace::add_reduced(const Rest& rest) {
    SmallRow row;
    for (const std::uint64_t number : rest)
        row.push_back(Small::of(number));
    const auto pivot = std::ranges::find_if(row, [](Small x) { return x != Small{}; });
    if (pivot == row.end()) return false;
    const auto column = static_cast<std::size_t>(pivot - row.begin());
    const Small scale = pivot->inverse();
    for (Small& number : row)
        number = number * scale;
    rows_.push_back({std::move(row), column});
    return true;
}

bool RowSpace::add(const std::vector<SmallRow>& rows) {
    std::vector<Rest> rests;
    for (const SmallRow& row : rows) {
        Rest& rest = rests.emplace_back();
        for (const Small number : row)
            rest.push_back(number.value);
    }
    const std::size_t known = rows_.size();
    for (std::size_t i = 0; i < known; ++i)
        for (Rest& rest : rests)
            reduce(rest, rows_[i]);
    for (Rest& rest : rests) {
        for (std::size_t i = known; i < rows_.size(); ++i)
            reduce(rest, rows_[i]);
        add_reduced(rest);
    }
    return rows_.size() > known;
}
} // namespace checker
