// Certificates of upper bounds on the degrees of problems for projective cameras
// (certs/FORMAT.md, section 15): images and powers, for the checker to compute with.
#pragma once

#include "prover/many_views/integer_pictures.h"

#include <span>
#include <string>

namespace plprove::many_views {

/// So many cubic forms, and linear ones, are multiplied.
struct Powers {
    int cubics = 1;
    int linear = 1;
};

/// What a record of the file says.
struct UpperBoundRecord {
    Problem problem;
    IntegerImages views; ///< those of the problem, then further images
    Powers powers;
};

/// A record with random images: enough further ones for all cubic forms. Whether these powers give
/// a bound, and which, the checker finds. Throws FormatLimit as random_integer_images does.
UpperBoundRecord propose_upper_bound(const Problem& problem, const Powers& powers,
                                     std::uint64_t seed);

/// The file of these records. Throws FormatLimit if the format does not allow it.
std::string write_upper_bounds(std::span<const UpperBoundRecord> records);

} // namespace plprove::many_views
