#include "prover/model/group.h"

#include "prover/groups/jordan.h"
#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

CycleType cycle_type_of(const Fibre& fibre) {
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor(factors, fibre.values.get());
    CycleType lengths;
    for (slong i = 0; i < factors->num; ++i)
        lengths.push_back(static_cast<int>(nmod_poly_degree(factors->p + i)));
    nmod_poly_factor_clear(factors);
    std::ranges::sort(lengths);
    return lengths;
}

bool has_cycle_length(int degree) {
    for (int length = degree / 2 + 1; length < degree - 2; ++length)
        if (shows_alternating(degree, length)) return true;
    return false;
}

} // namespace

std::string why_no_group(const Study& study) {
    if (!study.fibre) return study.no_fibre;
    const std::size_t degree = study.at_least();
    if (!study.at_most()) return "no upper bound is known on the number of solutions";
    if (study.at_most() != degree)
        return counted(degree, "solution") + " at least, and " + std::to_string(*study.at_most()) +
               " at most";
    if (!has_cycle_length(static_cast<int>(degree)))
        return counted(degree, "solution") + ": that is too few";
    return {};
}

GroupSearch find_group(const Study& study, int most,
                       const std::function<void(std::size_t)>& progress) {
    constexpr std::uint64_t first_stream = 100; // others are in use
    constexpr std::size_t most_records = 3;
    const std::size_t solutions = study.at_least();
    const int degree = static_cast<int>(solutions);
    const std::string symmetric = "S" + std::to_string(degree);
    std::vector<Fibre> fibres{*study.fibre};
    GroupSearch search{{cycle_type_of(fibres.front())}, {}, {}};
    std::vector<std::size_t> chosen;
    for (int n = 1; n < most && chosen.empty(); ++n) {
        if (progress) progress(fibres.size());
        auto next =
            find_fibre(study.model, study.program, first_stream + static_cast<std::uint64_t>(n))
                .fibre;
        if (!next || next->count() != solutions) continue;
        search.cycle_types.push_back(cycle_type_of(*next));
        fibres.push_back(std::move(*next));
        chosen = fewest_that_show(symmetric, search.cycle_types, degree, 2);
    }
    for (const std::string& group : {symmetric, ">=A" + std::to_string(degree)}) {
        if (chosen.empty())
            chosen = fewest_that_show(group, search.cycle_types, degree, most_records);
        if (chosen.empty()) continue;
        search.group = group;
        for (const std::size_t place : chosen)
            search.fibres.push_back(fibres[place]);
        break;
    }
    return search;
}

} // namespace plprove::model
