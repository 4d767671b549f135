// Solutions in the standard chart, where equal cameras have equal coordinates, and those of real
// cameras are real.
#pragma once

#include "prover/many_views/system.h"

#include <optional>

namespace plprove::many_views {

/// The same cameras and places in the standard chart (CameraChart::standard).
Point in_standard_chart(const System& system, const Point& point);

/// Whether the point is real, up to rounding of a well-conditioned one; tried, not believed.
bool is_real(const Point& point);

/// Where at most eight Newton steps lead for these images, as the checker makes them; nothing where
/// they do not converge. The evaluation is room for them.
std::optional<Point> refined(const System& system, const Images<Moving>& images, Point point,
                             Evaluation& room);

} // namespace plprove::many_views
