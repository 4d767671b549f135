// The versions of the software and of the certificates. The top CMakeLists.txt has the same, and a
// test compares them: they stand here, too, because the checker also builds without CMake.
#pragma once

#include <string_view>

namespace checker {
inline constexpr std::string_view software_version = "1.6.0";
inline constexpr std::string_view format_version = "2";
} // namespace checker
