// The five-point problem, the only reduced minimal problem in two views, solved within a problem in
// three views: the engine, the certificates and the checker speak of three.
//
// A third camera multiplies the solutions: each of the 20 relative poses leaves equally many third
// cameras (Lemma U1 of proofs/registrations.md). Models bound both factors. So where a degree file
// has the product of the bounds as its number of solutions, both are attained, and the number of
// relative poses is certified exactly.
#pragma once

#include <cstddef>
#include <string_view>

namespace plprove {

/// How many relative poses of two cameras five generic points that both see leave (D. Nister, PAMI
/// 2004): two for each of 10 essential matrices.
inline constexpr int poses_of_five_points = 20;

/// In notation. All minimal problems in two views have its cameras.
inline constexpr std::string_view five_point_problem = "5*P/P";

/// The number of the label class that is solved in place of the five-point problem: of its
/// extensions by the registration of a third camera, the one with the fewest solutions. Views 2 and
/// 3 share the five points; view 1 sees two of them, and a line.
std::size_t five_point_extension();

} // namespace plprove
