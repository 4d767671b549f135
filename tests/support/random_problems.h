// Random problems for tests: the same for the same seed, on every machine.
#pragma once

#include "prover/problem/reduction.h"
#include "prover/problem/signature.h"

#include <numeric>
#include <random>

namespace plprove {

class RandomProblems {
public:
    explicit RandomProblems(unsigned seed) : random_(seed) {}

    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }

    /// Any feature: a free line, or a point with up to `most_pins` pins, seen at random.
    Feature feature(int views, int most_pins) {
        Feature feature{below(4) > 0, 1, std::vector<Sight>(static_cast<std::size_t>(views))};
        if (feature.has_point) feature.lines = below(most_pins + 1);
        for (Sight& sight : feature.sights) {
            sight.point = feature.has_point && below(4) > 0;
            for (int line = 0; line < feature.lines; ++line)
                if (below(4) > 0 && (sight.point || sight.pins == 0)) sight.pins |= 1U << line;
        }
        return feature;
    }

    /// A class, chosen at random, with reducible features added: often camera-minimal, never small.
    Features around_a_class(int added) {
        const auto number = static_cast<std::size_t>(below(143494));
        Features problem = problem_of(label_classes()[number]);
        for (int i = 0; i < added; ++i) {
            Feature extra = feature(3, 9);
            // What reduces to nothing keeps the verdict; the rest may spoil it, now and then.
            if (reduce({extra}).reduced.empty() || below(10) == 0) problem.push_back(extra);
        }
        return problem;
    }

    template <class Range>
    void shuffle(Range& range) {
        for (std::size_t i = range.size(); i > 1; --i)
            std::swap(range[i - 1], range[static_cast<std::size_t>(below(static_cast<int>(i)))]);
    }

    /// The same problem with its pins renamed and its features reordered.
    Features disguised(Features problem) {
        for (Feature& feature : problem) {
            std::vector<int> names(static_cast<std::size_t>(feature.lines));
            std::iota(names.begin(), names.end(), 0);
            shuffle(names);
            for (Sight& sight : feature.sights) {
                std::uint64_t pins = 0;
                for (std::size_t line = 0; line < names.size(); ++line)
                    pins |= (sight.pins >> line & 1U) << names[line];
                sight.pins = pins;
            }
        }
        shuffle(problem);
        return problem;
    }

private:
    std::mt19937 random_;
};

} // namespace plprove
