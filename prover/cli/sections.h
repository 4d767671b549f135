// Reports of one fact a paragraph, each with a label in front.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace plprove {

inline constexpr int label_width = 12;
/// What is left of 100 columns behind the label.
inline constexpr std::size_t text_width = 100 - label_width;

/// Writes the label, and blanks up to where the text begins.
std::ostream& section(std::ostream& out, std::string_view label);

/// In lines that begin below each other, `indent` columns behind the label.
void write_wrapped(std::ostream& out, const std::string& text, std::size_t indent = 0);

} // namespace plprove
