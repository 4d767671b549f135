// Problems that have a name in the literature.
#pragma once

#include "prover/problem/notation.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plprove {

struct NamedProblem {
    std::string_view name;
    std::string_view notation;
};

/// In two views the five-point problem. In three views the problems of complete visibility by their
/// names in PLMP, Table 1 (Duff, Kohn, Leykin, Pajdla, ICCV 2019): 3002_1 is 3 points, 0 of them
/// dependent, 0 free lines, 2 pins, at most 1 at a point. Two of them have a name of their own
/// (Fabbri et al., TRPLP, CVPR 2020). And the registrations of a third camera after the five-point
/// problem, by the names of the resection problems in PoseLib.
std::span<const NamedProblem> named_problems();

/// The problem with this name, whatever the case of its letters and the blanks in it; nothing if
/// there is none.
std::optional<Features> problem_named(std::string_view name);

/// All names, joined by commas.
std::string list_of_names();

} // namespace plprove
