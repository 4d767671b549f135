// Certificates of lower bounds on the degrees of problems in general (certs/FORMAT.md, section
// 14): the solutions that monodromy has found, carried over to integer images.
#pragma once

#include "prover/many_views/integer_pictures.h"
#include "prover/many_views/monodromy.h"

#include <array>
#include <span>
#include <string>

namespace plprove::many_views {

/// Starting values of a solution, times 2^bits: of each coordinate the real part, and unless it is
/// real the imaginary part. The cameras come first.
struct StartingValues {
    bool real = true;
    int bits = 0;
    std::vector<std::int64_t> values;
};

/// What a record of the file says.
struct SolutionsRecord {
    general::Problem problem;
    IntegerImages views; ///< what each sees
    std::vector<StartingValues> solutions;

    /// How many solutions these are: one that is not real stands for its conjugate, too.
    int count() const;
};

/// Follows the solutions to random integer images, on other ways again if fewer than `wanted`
/// arrive, until two ways in a row bring nothing new. The record has all that arrive, each real one
/// and each pair once. The same result for the same seed, whatever the number of threads.
SolutionsRecord certify(const MonodromyResult& found, int wanted, std::uint64_t seed, int threads);

/// A calibrated camera: a quaternion, not of the norm 0, and t of its matrix, times any number.
struct QuaternionCamera {
    std::array<Complex, 4> quaternion;
    std::array<Complex, 3> t;
};

/// The record that these images of points in two views have these solutions: approximate second
/// cameras, whose quaternions and t do not begin with 0. The largest coordinates of the image
/// vectors have `digits` digits. Leaves out what Newton's method does not confirm.
SolutionsRecord certify(const general::Problem& points, const IntegerImages& integers, int digits,
                        std::span<const QuaternionCamera> cameras);

/// The file of these records. Throws FormatLimit if the format does not allow it.
std::string write_solutions(std::span<const SolutionsRecord> records);

} // namespace plprove::many_views
