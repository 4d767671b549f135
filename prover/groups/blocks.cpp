#include "prover/groups/blocks.h"

#include <numeric>
#include <utility>

namespace plprove {

namespace {

/// Which points are in one set, where sets are only ever united.
class Sets {
public:
    explicit Sets(std::size_t points) : parent_(identity(static_cast<int>(points))) {}

    int root(int point) {
        while (parent_[as_index(point)] != point) {
            parent_[as_index(point)] = parent_[as_index(parent_[as_index(point)])];
            point = parent_[as_index(point)];
        }
        return point;
    }

    /// Whether they were in two sets. The smaller root stays one.
    bool unite(int point, int other) {
        int root_of_one = root(point), root_of_other = root(other);
        if (root_of_one == root_of_other) return false;
        if (root_of_one > root_of_other) std::swap(root_of_one, root_of_other);
        parent_[as_index(root_of_other)] = root_of_one;
        return true;
    }

private:
    Permutation parent_;
};

BlockSystem numbered(Sets& sets, std::size_t points) {
    BlockSystem result{std::vector<int>(points), 0};
    for (std::size_t i = 0; i < points; ++i) {
        const int root = sets.root(static_cast<int>(i));
        result.block_of[i] =
            root == static_cast<int>(i) ? result.blocks++ : result.block_of[as_index(root)];
    }
    return result;
}

} // namespace

bool is_transitive(const std::vector<Permutation>& generators) {
    if (generators.empty()) return false;
    Sets sets(generators.front().size());
    std::size_t orbits = generators.front().size();
    for (const Permutation& generator : generators)
        for (std::size_t i = 0; i < generator.size(); ++i)
            if (sets.unite(static_cast<int>(i), generator[i])) --orbits;
    return orbits == 1;
}

BlockSystem blocks_joining(const std::vector<Permutation>& generators, int point, int other) {
    const std::size_t points = generators.front().size();
    Sets sets(points);
    std::vector<std::pair<int, int>> open = {{point, other}};
    sets.unite(point, other);
    // Where two points share a block, so do their images.
    while (!open.empty()) {
        const auto [one, two] = open.back();
        open.pop_back();
        for (const Permutation& generator : generators) {
            const std::pair<int, int> images = {generator[as_index(one)], generator[as_index(two)]};
            if (sets.unite(images.first, images.second)) open.push_back(images);
        }
    }
    return numbered(sets, points);
}

BlockSystem least_blocks(const std::vector<Permutation>& generators) {
    const int points = static_cast<int>(generators.front().size());
    BlockSystem best{std::vector<int>(as_index(points), 0), 1};
    for (int other = 1; other < points; ++other) {
        BlockSystem system = blocks_joining(generators, 0, other);
        if (system.blocks > best.blocks) best = std::move(system);
    }
    return best;
}

std::vector<Permutation> on_blocks(const std::vector<Permutation>& generators,
                                   const BlockSystem& system) {
    std::vector<Permutation> result;
    for (const Permutation& generator : generators) {
        Permutation& moved = result.emplace_back(as_index(system.blocks));
        for (std::size_t i = 0; i < generator.size(); ++i)
            moved[as_index(system.block_of[i])] = system.block_of[as_index(generator[i])];
    }
    return result;
}

} // namespace plprove
