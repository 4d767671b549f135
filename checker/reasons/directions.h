// Counts of directions (FORMAT.md, section 13): what images say of lines through one point, or of
// the directions of lines, and of cameras as far as they map these.
#pragma once

#include "checker/reasons/part.h"

namespace checker {
// How many conditions the images of a part satisfy at least, in the numbers of the part. Throw
// Refused if the motion does not fit it.
int excess_of_directions(const Problem& part, const Motion& motion);
int excess_of_pencils(const Problem& part, std::size_t centre);
} // namespace checker
