// The checker as a library, for programs that have certificates as bytes: a server, a test, another
// prover. In CMake: find_package(plcheck), and link plcheck::plcheck. See docs/install.md.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plcheck {
/// A file's bytes, and the name by which the report calls it.
struct File {
    std::string_view name;
    std::string_view bytes;
};

/// What files prove together, as the command plcheck says it.
struct Report {
    int status = 0; ///< 0 every certificate holds, 1 one is refused, 2 a file is not well-formed
    std::string text{};       ///< what `plcheck FILE...` prints
    std::string json{};       ///< what `plcheck --json FILE...` prints
    std::string complaints{}; ///< what is refused and why, a line each; what plcheck calls errors
};

/// Replays the files, and believes none: certs/FORMAT.md says what is verified. A status of 0 says
/// that every claim holds, not which claims these are: compare them with those that you expect.
/// Any bytes are allowed. Nothing is kept between calls, and threads may call it side by side.
/// Throws std::bad_alloc if memory runs out.
Report check(std::span<const File> files);

/// The version of the library, `1.1.0`.
std::string_view version();
} // namespace plcheck
