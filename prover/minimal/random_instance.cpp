#include "prover/minimal/random_instance.h"

#include <algorithm>
#include <random>

namespace plprove {

namespace {

/// Random integers of at most this size, the same on every machine.
class RandomCoordinates {
public:
    RandomCoordinates(unsigned seed, std::int64_t largest) : engine_(seed), largest_(largest) {}

    Coordinates take(int count) {
        Coordinates result;
        const auto range = static_cast<std::uint64_t>(2 * largest_ + 1);
        for (int i = 0; i < count; ++i)
            result.push_back(static_cast<std::int64_t>(engine_() % range) - largest_);
        return result;
    }

private:
    std::mt19937_64 engine_;
    std::int64_t largest_;
};

} // namespace

Instance random_instance(const Problem& problem, unsigned seed, std::int64_t largest) {
    RandomCoordinates coordinates(seed, largest);
    Instance instance;
    instance.shared = coordinates.take(problem.cameras->shared);
    for (int view = 1; view < problem.views; ++view)
        instance.cameras.push_back(coordinates.take(problem.cameras->numbers));
    std::ranges::copy(problem.cameras->start_of_second, instance.cameras.front().begin());
    instance.scene = coordinates.take(scene_coordinates(problem));
    return instance;
}

} // namespace plprove
