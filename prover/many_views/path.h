// Following a solution while the images move.
#pragma once

#include "prover/many_views/system.h"

#include <cstdint>
#include <optional>

namespace plprove::many_views {

/// How carefully a path is followed: `careful` takes some five times the steps, and jumps to
/// other paths more rarely; `precise` takes them with twice the digits, ten times as slowly.
enum class Care : std::uint8_t { usual, careful, precise };

/// From the solution of the images `from` along the straight way to those of `to`. Nothing where
/// the path gets lost.
std::optional<Point> follow(const System& system, const Images<Complex>& from,
                            const Images<Complex>& to, const Point& start, Care care);

/// The same of several solutions, by `threads` threads, side by side.
std::vector<std::optional<Point>> follow_all(const System& system, const Images<Complex>& from,
                                             const Images<Complex>& to,
                                             const std::vector<Point>& starts, Care care,
                                             int threads);

} // namespace plprove::many_views
