#include "prover/model/solver/loop_group.h"

#include "prover/model/solver/start.h"

#include <algorithm>
#include <memory>

namespace plprove::model {

namespace {

/// Solutions for random data, and how loops permute the values that count.
class CountedLoops {
public:
    CountedLoops(const Program& program, std::unique_ptr<StartSearch> search, const ModelSize& size)
        : search_(std::move(search)),
          loops_(std::move(search_->monodromy()), size.solutions, near_at_starts) {
        if (loops_.complete()) number_values(program);
        complete_ = loops_.complete() && values_ == size.values;
    }

    bool complete() const { return complete_; }

    /// As loops that go back along the first edge.
    void add_bijections(int count) {
        loops_.add_bijections(count);
        bijections_.clear();
        for (const Permutation& along : loops_.bijections())
            if (auto of_values = on_values(then(along, inverse(loops_.bijections().front()))))
                bijections_.push_back(std::move(*of_values));
    }
    const std::vector<Permutation>& bijections() const { return bijections_; }

    std::optional<Permutation> next() { return on_values(loops_.next()); }
    std::optional<Permutation> next_both_ways() { return on_values(loops_.next_both_ways()); }

private:
    void number_values(const Program& program) {
        SolutionSet<Numbers> seen(near_at_starts, Nearness::of_coordinates);
        for (const Numbers& solution : loops_.solutions()) {
            const auto values = counted_values(program, search_->data(), solution);
            if (!values) return;
            const std::optional<int> known = seen.find(*values);
            value_of_.push_back(known ? *known : seen.add(*values));
        }
        values_ = seen.size();
    }

    /// Nothing where solutions with the same value seem to part: then a path jumped.
    std::optional<Permutation> on_values(const std::optional<Permutation>& of_solutions) const {
        if (!of_solutions) return std::nullopt;
        constexpr int none = -1;
        Permutation result(as_index(values_), none);
        for (std::size_t i = 0; i < of_solutions->size(); ++i) {
            int& image = result[as_index(value_of_[i])];
            const int found = value_of_[as_index((*of_solutions)[i])];
            if (image != none && image != found) return std::nullopt;
            image = found;
        }
        return result;
    }

    std::unique_ptr<StartSearch> search_; // the loops refer to it
    SolutionLoops<DataLoops> loops_;
    std::vector<int> value_of_; // of each solution
    int values_ = 0;
    bool complete_ = false;
    std::vector<Permutation> bijections_;
};

/// The sets of points that the permutations lead to one another.
std::vector<std::vector<int>> orbits(const std::vector<Permutation>& generators) {
    std::vector<std::vector<int>> result;
    std::vector<bool> seen(generators.front().size());
    for (std::size_t first = 0; first < seen.size(); ++first) {
        if (seen[first]) continue;
        seen[first] = true;
        std::vector<int>& orbit = result.emplace_back(1, static_cast<int>(first));
        for (std::size_t i = 0; i < orbit.size(); ++i)
            for (const Permutation& generator : generators) {
                const int image = generator[as_index(orbit[i])];
                if (seen[as_index(image)]) continue;
                seen[as_index(image)] = true;
                orbit.push_back(image);
            }
    }
    return result;
}

/// The permutations of an orbit.
std::vector<Permutation> on_orbit(const std::vector<Permutation>& generators,
                                  const std::vector<int>& orbit) {
    std::vector<int> place(generators.front().size());
    for (std::size_t i = 0; i < orbit.size(); ++i)
        place[as_index(orbit[i])] = static_cast<int>(i);
    std::vector<Permutation> result;
    for (const Permutation& generator : generators) {
        Permutation& own = result.emplace_back();
        for (const int point : orbit)
            own.push_back(place[as_index(generator[as_index(point)])]);
    }
    return result;
}

ModelGroup parts_of(const std::vector<Permutation>& generators) {
    ModelGroup result{static_cast<int>(generators.size()), {}};
    for (const std::vector<int>& orbit : orbits(generators))
        result.parts.push_back(monodromy_group(on_orbit(generators, orbit)));
    std::ranges::stable_sort(result.parts, {}, &MonodromyGroup::degree);
    return result;
}

} // namespace

std::optional<ModelGroup> group_of_loops(const Program& program, const ModelSize& size,
                                         std::uint64_t seed, unsigned threads,
                                         const LoopProgress& progress) {
    constexpr std::uint64_t most_data = 4;
    const TrackedEquations equations(program);
    for (std::uint64_t attempt = 0; attempt < most_data; ++attempt) {
        auto search =
            std::make_unique<StartSearch>(program, equations,
                                          StartSettings{most_data * seed + attempt,
                                                        threads,
                                                        static_cast<std::size_t>(size.solutions),
                                                        {},
                                                        Bends::wide});
        search->run();
        CountedLoops solutions(program, std::move(search), size);
        if (!solutions.complete()) continue;
        if (const auto found = symmetric_group_of(solutions, progress))
            return ModelGroup{found->loops, {found->group}};
        LoopPermutations loops(std::move(solutions), progress);
        if (const auto found = group_of(loops)) return ModelGroup{found->loops, {found->group}};
        if (!loops.permutations().empty() && !is_transitive(loops.permutations()))
            return parts_of(loops.permutations());
    }
    return std::nullopt;
}

} // namespace plprove::model
