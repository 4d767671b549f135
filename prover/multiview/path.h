// Following a solution while the images move.
#pragma once

#include "prover/multiview/system.h"

#include <optional>

namespace plprove::multiview {

/// From the solution of the images `from` along the straight way to those of `to`. Nothing where
/// the path gets lost.
std::optional<Point> follow(const System& system, const Images<Complex>& from,
                            const Images<Complex>& to, const Point& start);

} // namespace plprove::multiview
