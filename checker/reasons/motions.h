// What each kind of motion says (FORMAT.md, section 13), in the numbers of the part. All throw
// Refused if the motion does not fit the part.
#pragma once

#include "checker/reasons/part.h"

namespace checker {
/// The span W of the generators of a motion, or of an element.
Span span_of_generators(const Problem& part, const Selection& moved);

/// κ of cameras that slide towards centres, some with what they see, so that all images stay.
int central_parameters(const Problem& part, const std::vector<Element>& elements);

// How many conditions the images satisfy at least: what they say of the directions of lines, or of
// the lines through one point, and of cameras as far as they map these.
int excess_of_directions(const Problem& part, const Motion& motion);
int excess_of_pencils(const Problem& part, std::size_t centre);
} // namespace checker
