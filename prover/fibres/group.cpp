#include "prover/fibres/group.h"

#include "prover/fibres/class_fibre.h"
#include "prover/fibres/scene_fibre.h"
#include "prover/model/fibre_text.h"

namespace plprove {

namespace {

/// Solutions of classes, and of problems in general, are permuted transitively.
constexpr bool transitive = true;

std::string symmetric(int degree) {
    return "S" + std::to_string(degree);
}

/// The records that show the group, in the order of their fibres.
std::string fewest_records(const GroupSearch& search, const std::vector<FibreRecord>& fibres) {
    constexpr std::size_t most_records = 4;
    std::string records;
    if (search.group.empty()) return fibres.empty() ? records : fibres.front().record;
    const auto chosen =
        fewest_that_show(search.group, search.cycle_types, search.degree, most_records, transitive);
    for (const std::size_t place : chosen)
        records += fibres[place].record;
    if (!chosen.empty()) return records;
    for (const FibreRecord& fibre : fibres) // more are needed than all choices are tried of
        records += fibre.record;
    return records;
}

template <class Fibre>
std::optional<FibreRecord> recorded(const std::optional<Fibre>& fibre) {
    if (!fibre) return std::nullopt;
    return FibreRecord{model::factor_degrees(fibre->solutions.polynomial), write_record(*fibre)};
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
        return std::ssize(fibres) == most || search.group == symmetric(degree);
    };
    for (int n = 0; n < tries && !is_enough(); ++n) {
        auto fibre = find_fibre(first + static_cast<std::uint64_t>(n), [&](long bits) {
            options.progress(static_cast<int>(fibres.size()), bits);
        });
        if (!fibre) continue;
        search.cycle_types.push_back(fibre->cycle_type);
        fibres.push_back(std::move(*fibre));
        if (degree > 1) search.group = group_shown_by(search.cycle_types, degree, transitive);
    }
    search.records = fewest_records(search, fibres);
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
    if (!scenes) return {degree, {}, {}, {}};
    return search_group(degree, options, [&](std::uint64_t seed, const auto& progress) {
        return recorded(find_scene_fibre(*scenes, seed, progress));
    });
}

} // namespace plprove
