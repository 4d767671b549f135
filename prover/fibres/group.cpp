#include "prover/fibres/group.h"

#include "prover/groups/jordan.h"

#include <algorithm>

namespace plprove {

namespace {

/// Adds what a fibre shows; its record if that is new.
void add(GroupSearch& search, const ClassFibre& fibre) {
    const std::vector<model::Univariate> factors = factors_of(fibre);
    std::vector<int>& lengths = search.cycle_types.emplace_back();
    for (const model::Univariate& factor : factors)
        lengths.push_back(static_cast<int>(factor.degree()));
    const auto found = std::ranges::find_if(factors, [&](const model::Univariate& factor) {
        return shows_alternating(search.degree, static_cast<int>(factor.degree()));
    });
    const bool is_even = (search.degree - static_cast<int>(factors.size())) % 2 == 0;
    bool& parity = is_even ? search.even : search.odd;
    const bool new_cycle = !search.alternating && found != factors.end();
    if (!new_cycle && parity) return;
    search.alternating |= new_cycle;
    parity = true;
    search.records += write_record(fibre, new_cycle ? &*found : nullptr);
}

} // namespace

bool has_cycle_length(int degree) {
    for (int cycle = degree / 2 + 1; cycle < degree - 2; ++cycle)
        if (shows_alternating(degree, cycle)) return true;
    return false;
}

std::string GroupSearch::group() const {
    if (!alternating) return {};
    return (symmetric() ? "S" : ">=A") + std::to_string(degree);
}

GroupSearch find_group(std::size_t number, int degree, const GroupOptions& options) {
    GroupSearch search;
    search.degree = degree;
    const std::uint64_t first = options.seed * static_cast<std::uint64_t>(options.fibres);
    for (int n = 0; n < options.fibres && !search.symmetric(); ++n) {
        const auto fibre =
            find_class_fibre(number, degree, first + static_cast<std::uint64_t>(n), [&](long bits) {
                options.progress(static_cast<int>(search.cycle_types.size()), bits);
            });
        if (fibre) add(search, *fibre);
    }
    return search;
}

} // namespace plprove
