// Images with integer coordinates, as a certificate has them (certs/FORMAT.md, section 14).
#pragma once

#include "prover/many_views/moving_images.h"
#include "prover/three_views/random.h"

#include <cstdint>

namespace plprove::many_views {

/// Integer images: what each view sees, number by number.
using IntegerImages = std::vector<std::vector<int>>;

/// The largest coordinate of random image vectors, if nothing else is asked for.
inline constexpr int usual_coordinate = 99;

/// Random ones of this number of views that meet the conditions of the format, with coordinates up
/// to `largest`. Throws FormatLimit if that takes too long.
IntegerImages random_integer_images(const Problem& problem, int views, Random& random,
                                    int largest = usual_coordinate);

/// What the numbers say, as integers.
Images<std::int64_t> exact_images(const Problem& problem, const IntegerImages& integers);

/// Image vectors for computing: those of free points and of lines are divided by `scale`, so that
/// they are about as long as random complex ones.
Images<Complex> scaled(const Problem& problem, const IntegerImages& integers, double scale);

} // namespace plprove::many_views
