// Certificates of lower bounds on the degrees of problems in general (certs/FORMAT.md, section
// 14): the solutions that monodromy has found, carried over to integer images.
#pragma once

#include "prover/format/certificate_text.h"
#include "prover/many_views/integer_pictures.h"
#include "prover/many_views/monodromy.h"
#include "prover/monodromy/starting_values.h"

#include <span>
#include <string>
#include <vector>

namespace plprove::many_views {

/// What a record of the file says.
struct SolutionsRecord {
    Problem problem;
    IntegerImages views;                   ///< what each sees
    std::vector<StartingValues> solutions; ///< the cameras come first

    /// How many solutions these are.
    int count() const { return count_solutions(solutions); }
};

/// Follows the solutions to random integer images, on other ways again if fewer than `wanted`
/// arrive, until two ways in a row bring nothing new. The record has all that arrive, each real one
/// and each pair once. The coordinates of the images are up to `largest`. The same result for the
/// same seed, whatever the number of threads.
SolutionsRecord certify(const MonodromyResult& found, int wanted, std::uint64_t seed, int threads,
                        int largest = usual_coordinate);

/// The record that these images of points in two views have these solutions: the numbers of
/// approximate second cameras, normalised (CameraModel::normalise). The largest coordinates of the
/// image vectors have `digits` digits. Leaves out what Newton's method does not confirm.
SolutionsRecord certify(const Problem& points, const IntegerImages& integers, int digits,
                        std::span<const std::vector<Complex>> second_cameras);

/// Adds the lines `problem` and `view` of a record. Throws FormatLimit if the format does not allow
/// them.
void append_images(CertificateText& text, const Problem& problem, const IntegerImages& views);

/// The file of these records. Throws FormatLimit if the format does not allow it.
std::string write_solutions(std::span<const SolutionsRecord> records);

} // namespace plprove::many_views
