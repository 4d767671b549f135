#include "prover/groups/stabilizer_chain.h"

namespace plprove {

namespace {

constexpr int none = -1;

int first_moved(const Permutation& permutation) {
    int point = 0;
    while (permutation[as_index(point)] == point)
        ++point;
    return point;
}

} // namespace

StabilizerChain::StabilizerChain(const std::vector<Permutation>& generators) {
    constexpr int enough = 20;
    RandomElements elements(generators);
    for (int in_vain = 0; in_vain < enough;)
        in_vain = learn(elements.next()) ? 0 : in_vain + 1;
}

std::vector<int> StabilizerChain::orbit_lengths() const {
    std::vector<int> result;
    for (const Level& level : levels_)
        result.push_back(static_cast<int>(level.orbit.size()));
    return result;
}

bool StabilizerChain::leaves(const Level& level, const Permutation& element) {
    const int image = element[as_index(level.point)];
    return image != level.point && level.arrived_by[as_index(image)] == none;
}

bool StabilizerChain::learn(Permutation element) {
    // Random elements of a stabilizer: so many rarely have a smaller orbit in common.
    constexpr std::size_t few = 6;
    bool grew = false;
    for (std::size_t i = 0; !is_identity(element); ++i) {
        if (i == levels_.size()) levels_.push_back({first_moved(element), {}, {}, {}});
        Level& level = levels_[i];
        if (level.inverses.size() < few || leaves(level, element)) {
            add(level, element);
            grew = true;
        }
        while (element[as_index(level.point)] != level.point) {
            const int by = level.arrived_by[as_index(element[as_index(level.point)])];
            element = then(element, level.inverses[as_index(by)]);
        }
    }
    return grew;
}

void StabilizerChain::add(Level& level, const Permutation& element) {
    level.inverses.push_back(inverse(element));
    level.orbit = {level.point};
    level.arrived_by.assign(element.size(), none);
    std::vector<Permutation> generators;
    for (const Permutation& one : level.inverses)
        generators.push_back(inverse(one));
    for (std::size_t i = 0; i < level.orbit.size(); ++i)
        for (std::size_t by = 0; by < generators.size(); ++by) {
            const int point = generators[by][as_index(level.orbit[i])];
            if (point == level.point || level.arrived_by[as_index(point)] != none) continue;
            level.arrived_by[as_index(point)] = static_cast<int>(by);
            level.orbit.push_back(point);
        }
}

} // namespace plprove
