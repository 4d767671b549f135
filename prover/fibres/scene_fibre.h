// All solutions of a problem in general for some integer images, modulo q: a fibre of the map from
// scenes to images (certs/FORMAT.md, section 14).
#pragma once

#include "prover/many_views/integer_pictures.h"
#include "prover/many_views/monodromy.h"
#include "prover/model/quotient.h"

#include <functional>
#include <optional>
#include <string>

namespace plprove {

struct SceneFibre {
    Problem problem;
    many_views::IntegerImages views; ///< what each sees
    model::Solutions solutions;      ///< the camera coordinates come first, then the depths
    std::vector<int> form; ///< t is the sum of the camera coordinates, each times its factor

    int degree() const { return static_cast<int>(solutions.polynomial.degree()); }
};

/// `degree` solutions for random complex images, where all fibres start; nothing if a few runs of
/// monodromy find another number. Assumes that the problem is minimal, and that all views see
/// everything.
std::optional<many_views::MonodromyResult> find_scenes(const Problem& problem, int degree,
                                                       std::uint64_t seed);

/// The fibre over random images with integer coordinates up to `largest_coordinate`, from all
/// solutions for others. Another seed, other images. Nothing where a step fails; another seed may
/// do then, or larger coordinates: paths end near singular solutions if they are small, but the
/// solutions have short coefficients. `progress` is told how many bits the solutions have.
std::optional<SceneFibre> find_scene_fibre(const many_views::MonodromyResult& scenes,
                                           std::uint64_t seed, int largest_coordinate,
                                           const std::function<void(long)>& progress);

/// The record of the fibre, without the first line of the file. Throws FormatLimit if the format
/// does not allow it.
std::string write_record(const SceneFibre& fibre);

} // namespace plprove
