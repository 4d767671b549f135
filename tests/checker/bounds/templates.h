// Files of upper bounds for tests: the committed one, small templates, and what the checker makes
// of them.
#pragma once

#include "checker/conclusion/degree_bounds.h"
#include "checker/degrees/constraint_class.h"
#include "checker/replay.h"
#include "tests/support/minimal_classes.h"
#include "tests/support/text.h"

namespace templates {
/// The bytes of certs/bounds.plc.
const std::string& committed_bytes();

/// What it proves.
const checker::BoundsFile& committed();

/// Two known points and a line: the smallest template of the committed file.
extern const std::string two_points_and_a_line;

/// Two known points, one with a pin, and a ray.
extern const std::string on_the_axis;

/// The template of the relative pose in the committed file: a single group of five rays.
std::string template_of_the_relative_pose();

/// What a file of these templates proves, or why it does not conform.
checker::FileContent replayed(const std::string& templates);

/// What the checker makes of templates: `holds`, or the first complaint; with `syntax: ` if the
/// file does not conform.
std::string outcome(const std::string& templates);

/// What is known of degrees if all minimal classes are certified, by these bounds.
checker::DegreeTable table_of(const checker::RegistrationBounds& upper,
                              const std::vector<checker::LowerBound>& lower = {});

/// The upper bound of a class in a table; 0 if it has none.
std::size_t bound_of(const checker::DegreeTable& table, std::size_t number);

/// The same of a class in notation.
std::size_t bound_of(const checker::DegreeTable& table, std::string_view problem);
} // namespace templates
