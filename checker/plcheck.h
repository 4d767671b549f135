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

/// What the files are expected to prove, in the words that follow the options of plcheck with these
/// names; nothing in particular by default.
struct Expectation {
    std::string expect{};  ///< a problem, like `2*Pa/Pa/Pa + P/P/P`; needs a verdict or a degree
    std::string verdict{}; ///< `minimal`, `not-minimal`, ...
    std::string degree{};  ///< `312`, or at least 312, `>=312`
    bool classification = false; ///< that every label class has a certificate
    std::string family{};        ///< that every problem of it has one: `plmp`, `focal`, ...
};

/// What files prove together, as the command plcheck says it.
struct Report {
    int status = 0;           ///< 0 verified, 1 refused or not proved, 2 a file is not well-formed
    std::string conclusion{}; ///< the last line of the text: `VERIFIED: ...`, `NOT VERIFIED: ...`
    std::string text{};       ///< what `plcheck FILE...` prints
    std::string json{};       ///< what `plcheck --json FILE...` prints
    std::string complaints{}; ///< what is refused and why, a line each
};

/// Replays the files, and believes none: certs/FORMAT.md says what is verified. A file chooses its
/// own claim: say what you expect, and a status of 0 says that the files prove just that. Any bytes
/// are allowed. Nothing is kept between calls, and threads may call it side by side. Throws
/// std::invalid_argument if the expectation makes no sense, and std::bad_alloc.
Report check(std::span<const File> files, const Expectation& expectation = {});

/// The version of the library, `1.6.0`.
std::string_view version();
} // namespace plcheck
