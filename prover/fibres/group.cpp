#include "prover/fibres/group.h"

#include "prover/fibres/class_fibre.h"
#include "prover/fibres/scene_fibre.h"
#include "prover/fibres/shared_matrices.h"
#include "prover/model/fibre_text.h"

#include <numeric>

namespace plprove {

namespace {

/// Solutions of classes, and of problems in general, are permuted transitively.
constexpr bool transitive = true;

std::string symmetric(int degree) {
    return "S" + std::to_string(degree);
}

/// What these fibres show.
std::string group_of(const std::vector<FibreRecord>& fibres, const std::vector<std::size_t>& places,
                     int degree) {
    std::vector<CycleType> cycle_types;
    std::vector<SharedCycles> shared;
    for (const std::size_t place : places) {
        const FibreRecord& fibre = fibres[place];
        cycle_types.push_back(fibre.cycle_type);
        if (!fibre.matrices.empty()) shared.push_back({fibre.cycle_type, fibre.matrices});
    }
    if (!shared.empty()) return group_with_blocks(shared, degree);
    return group_shown_by(cycle_types, degree, transitive);
}

std::string group_of(const std::vector<FibreRecord>& fibres, int degree) {
    std::vector<std::size_t> all(fibres.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return group_of(fibres, all, degree);
}

/// The records that show the group, in the order of their fibres.
std::string fewest_records(const std::string& group, const std::vector<FibreRecord>& fibres,
                           int degree) {
    constexpr std::size_t most_records = 4;
    std::string records;
    if (group.empty()) return fibres.empty() ? records : fibres.front().record;
    const auto chosen = fewest_that_show(fibres.size(), most_records, [&](const auto& places) {
        return group_of(fibres, places, degree) == group;
    });
    for (const std::size_t place : chosen)
        records += fibres[place].record;
    if (!chosen.empty()) return records;
    for (const FibreRecord& fibre : fibres) // more are needed than all choices are tried of
        records += fibre.record;
    return records;
}

CycleType cycles_of_matrices(const ClassFibre& fibre) {
    return model::factor_degrees(shared_matrices(fibre.solutions));
}

/// The unknowns of these are scenes.
CycleType cycles_of_matrices(const SceneFibre& /*fibre*/) {
    return {};
}

template <class Fibre>
std::optional<FibreRecord> recorded(const std::optional<Fibre>& fibre) {
    if (!fibre) return std::nullopt;
    return FibreRecord{model::factor_degrees(fibre->solutions.polynomial),
                       cycles_of_matrices(*fibre), write_record(*fibre)};
}

} // namespace

GroupSearch search_group(int degree, const GroupOptions& options, const FindFibre& find_fibre) {
    GroupSearch search{degree, {}, {}, {}};
    std::vector<FibreRecord> fibres;
    constexpr int most_in_vain = 20; // some images are not generic
    const int tries = options.fibres + most_in_vain;
    const std::uint64_t first = options.seed * static_cast<std::uint64_t>(tries);
    const int most = degree == 1 ? 1 : options.fibres;
    const auto is_enough = [&] {
        return std::ssize(fibres) == most || search.group == symmetric(degree) ||
               may_be_shown_with_blocks(search.group);
    };
    for (int n = 0; n < tries && !is_enough(); ++n) {
        auto fibre = find_fibre(first + static_cast<std::uint64_t>(n), [&](long bits) {
            options.progress(static_cast<int>(fibres.size()), bits);
        });
        if (!fibre) continue;
        search.cycle_types.push_back(fibre->cycle_type);
        fibres.push_back(std::move(*fibre));
        if (degree > 1) search.group = group_of(fibres, degree);
    }
    search.records = fewest_records(search.group, fibres, degree);
    return search;
}

GroupSearch find_group(std::size_t number, int degree, const GroupOptions& options) {
    DegreeOptions of_class;
    of_class.degree = degree;
    return search_group(degree, options, [&](std::uint64_t seed, const auto& progress) {
        of_class.seed = seed;
        return recorded(find_class_fibre(number, of_class, progress));
    });
}

GroupSearch find_group(const Problem& problem, int degree, const GroupOptions& options) {
    const auto scenes = find_scenes(problem, degree, options.seed);
    GroupSearch search{degree, {}, {}, {}};
    if (!scenes) return search;
    for (const int largest_coordinate : {3, 20}) { // the first ones do for most problems
        search = search_group(degree, options, [&](std::uint64_t seed, const auto& progress) {
            return recorded(find_scene_fibre(*scenes, seed, largest_coordinate, progress));
        });
        if (!search.cycle_types.empty()) break;
    }
    return search;
}

} // namespace plprove
