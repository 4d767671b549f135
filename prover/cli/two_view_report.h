// What `plprove degree` says of a problem in two views, which it computes with a third camera.
#pragma once

#include "prover/cli/degree_report.h"

namespace plprove {

/// One fact a paragraph. `report.run` is of five_point_extension().
std::string two_view_report(const DegreeReport& report);

/// The same as a JSON object.
std::string json_two_view_report(const DegreeReport& report);

} // namespace plprove
