// A second method for problems in general: the rank of the derivative of the images by all
// coordinates of scene and cameras, of all cameras, without a choice of equations or of unknowns.
#pragma once

#include "checker/problem/problem.h"

#include <random>

/// The same problems and places for the same seed, on every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    std::size_t below(std::size_t bound) { return random_() % bound; }
    int from_to(int low, int high) {
        return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1)));
    }
    bool one_in(std::size_t bound) { return below(bound) == 0; }

private:
    std::mt19937_64 random_;
};

/// The dimension of the images of generic scenes in generic cameras, with high probability: the
/// rank at a random place, modulo a prime other than q. FLINT computes it.
std::size_t image_rank(const checker::Problem& problem, Dice& dice);

/// The dimension of the images, were all conditions on them those inside a view.
std::size_t image_dimension(const checker::Problem& problem);

/// The dimension of scenes and cameras, less that of the transformations of space.
std::size_t scene_dimension(const checker::Problem& problem);

/// A problem that conforms: some points, lines and views, which do not always see all.
checker::Problem random_problem(Dice& dice, bool all_visible);

/// The problem of a notation. Throws Malformed.
checker::Problem problem_of(const std::string& notation);
