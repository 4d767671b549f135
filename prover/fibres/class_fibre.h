// All solutions of a label class for some integer images, modulo q: a fibre of the map from scenes
// to images (certs/FORMAT.md, section 9).
#pragma once

#include "prover/model/quotient.h"
#include "prover/three_views/degree.h"

#include <functional>
#include <optional>
#include <string>

namespace plprove {

struct ClassFibre {
    std::size_t number = 0; ///< of the label class
    std::vector<FeatureImage> images;
    model::Solutions solutions;
    std::vector<int> form; ///< t is the sum of the camera coordinates, each times its factor

    int degree() const { return static_cast<int>(solutions.polynomial.degree()); }
};

/// The fibre over random images with small coordinates, by all solutions of the engine. Another
/// seed, other images. Nothing where a step fails; another seed may do then. `bits` is told how
/// many the solutions have. Assumes that the options have the degree.
std::optional<ClassFibre> find_class_fibre(std::size_t number, DegreeOptions options,
                                           const std::function<void(long)>& bits = {});

/// Looks for a fibre, over some images after the other. The run has its record, or a note.
DegreeRun compute_class_fibre(std::size_t number, const DegreeOptions& options);

/// The record of the fibre, without the first line of the file. Throws FormatLimit if the format
/// does not allow it.
std::string write_record(const ClassFibre& fibre);

} // namespace plprove
