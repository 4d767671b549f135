// Images with integer coordinates, as a certificate has them (certs/FORMAT.md, section 14).
#pragma once

#include "prover/many_views/moving_images.h"
#include "prover/three_views/random.h"

namespace plprove::many_views {

/// Integer images: what each view sees, number by number.
using IntegerImages = std::vector<std::vector<int>>;

/// Random ones of this number of views that meet the conditions of the format. Throws FormatLimit
/// if that takes too long.
IntegerImages random_integer_images(const Problem& problem, int views, Random& random);

/// Image vectors for computing: those of free points and of lines are divided by `scale`, so that
/// they are about as long as random complex ones.
Images<Complex> scaled(const Problem& problem, const IntegerImages& integers, double scale);

} // namespace plprove::many_views
