#include "prover/model/group.h"

#include "prover/model/fibre_text.h"
#include "prover/system/words.h"

namespace plprove::model {

std::string why_no_group(const Study& study) {
    if (!study.fibre) return study.no_fibre;
    const std::size_t degree = study.at_least();
    if (!study.at_most()) return "no upper bound is known on the number of solutions";
    if (study.at_most() != degree)
        return counted(degree, "solution") + " at least, and " + std::to_string(*study.at_most()) +
               " at most";
    if (degree < 2) return "it has one solution";
    return {};
}

GroupSearch find_group(const Study& study, int most,
                       const std::function<void(std::size_t)>& progress) {
    constexpr std::uint64_t first_stream = 100; // others are in use
    constexpr std::size_t most_records = 3;
    constexpr bool transitive = false; // nothing says so but cycles
    const std::size_t solutions = study.at_least();
    const int degree = static_cast<int>(solutions);
    const std::string symmetric = "S" + std::to_string(degree);
    std::vector<Fibre> fibres{*study.fibre};
    GroupSearch search{{factor_degrees(fibres.front().values)}, {}, {}};
    std::vector<std::size_t> chosen;
    const auto fewest = [&](const std::string& group) {
        const auto shows = [&](const std::vector<std::size_t>& places) {
            std::vector<CycleType> own;
            for (const std::size_t place : places)
                own.push_back(search.cycle_types[place]);
            return group_shown_by(own, degree, transitive) == group;
        };
        return fewest_that_show(fibres.size(), most_records, shows);
    };
    for (int n = 1; n < most && chosen.empty(); ++n) {
        if (progress) progress(fibres.size());
        auto next =
            find_fibre(study.model, study.program, first_stream + static_cast<std::uint64_t>(n))
                .fibre;
        if (!next || next->count() != solutions) continue;
        search.cycle_types.push_back(factor_degrees(next->values));
        fibres.push_back(std::move(*next));
        chosen = fewest(symmetric);
    }
    for (const std::string& group : {symmetric, ">=A" + std::to_string(degree)}) {
        if (chosen.empty()) chosen = fewest(group);
        if (chosen.empty()) continue;
        search.group = group;
        for (const std::size_t place : chosen)
            search.fibres.push_back(fibres[place]);
        break;
    }
    return search;
}

} // namespace plprove::model
