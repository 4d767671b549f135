// How scripts and models are laid out.
#pragma once

#include <string>
#include <vector>

namespace plprove {

/// The items separated by `, `, in lines of at most 96 characters that begin with `indent`.
std::string list(const std::vector<std::string>& items, const std::string& indent);

/// `text` broken at blanks into comment lines that begin with `sign`.
std::string comment(const std::string& sign, const std::string& text);

} // namespace plprove
