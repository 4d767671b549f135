// The families of problems (FORMAT.md, section 13): each kind of cameras has one.
#pragma once

#include "checker/family/by_problem.h"

#include <string_view>
#include <variant>

namespace checker {
/// Problems, each but once.
using Problems = ByProblem<std::monostate>;

/// The name of a kind's family: `plmp`, or that of the cameras.
std::string_view family_name(const CameraModel& cameras);

/// The cameras of the family with this name; none if there is no such family.
const CameraModel* cameras_of_family(std::string_view name);

/// All problems of a kind's family.
Problems family(const CameraModel& cameras);
} // namespace checker
