// Everything that a reader needs in thirty years: the certificates, what their format is, why they
// prove what they claim, and the checker, with a line that builds it.
#pragma once

#include "prover/bundle/tarball.h"

#include <filesystem>

namespace plprove {

/// The bundle made from the project's source folder: licence and citation, the certificates with
/// their format, the proofs and their Coq sources, the checker's sources, a README that says how to
/// build and run it, and SHA256SUMS of all of these. Throws std::runtime_error if `source` is not
/// the source folder of this project, if a file cannot be read, or if a certificate file is not the
/// one whose digest is in certs/SHA256SUMS.
Files bundle(const std::filesystem::path& source);

/// The folder that the bundle unpacks to.
inline constexpr const char* bundle_folder = "point-line-certificates";

/// The checker alone, made from the project's source folder: licence and citation, its sources with
/// what CMake needs to install them, the format, `example` as example.plc, a README that says how
/// to build and run it, and SHA256SUMS of all of these. Throws std::runtime_error if `source` is
/// not the source folder of this project, or if a file cannot be read.
Files checker_archive(const std::filesystem::path& source, const std::string& example);

} // namespace plprove
