// JSON whose numbers are kept as they are written.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace plprove {

/// The value that the text stands for, in which each number is a string of its characters. Throws
/// std::invalid_argument, with the place, where the text is no JSON or an object has two members of
/// the same name.
nlohmann::json parse_exact_json(const std::string& text);

} // namespace plprove
