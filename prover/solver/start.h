// The start of a label class: images with all solutions, from which paths lead to other images.
#pragma once

#include "prover/three_views/images.h"

#include <filesystem>
#include <optional>
#include <string>

namespace plprove {

struct Start {
    std::size_t number = 0;          ///< of the label class
    CameraChart chart;               ///< of the solutions
    std::vector<Complex3> constants; ///< of the auxiliary lines and points
    Images images;
    std::vector<CameraPoint> solutions;

    int degree() const { return static_cast<int>(solutions.size()); }
};

/// Random complex images of the class with all solutions that monodromy reaches, from which paths
/// to images of scenes are short. The same start for the same number and seed on any machine.
/// Assumes that the class is minimal.
Start find_start(std::size_t number, std::uint64_t seed);

/// The start as a file: JSON with a digest. The same bytes for the same start.
std::string write_start(const Start& start);

/// Reads such a file. Throws BadInput where it is damaged or of another version; `name` names the
/// file in messages.
Start read_start(const std::string& text, const std::string& name);

/// Where starts are kept: $XDG_CACHE_HOME/pointline, or ~/.cache/pointline; nothing where neither
/// variable has an absolute path.
std::optional<std::filesystem::path> start_cache();

/// The start of the class from the cache; made and kept there if it is not there. A damaged file in
/// the cache is replaced. That a start cannot be kept is no error: it is made again the next time.
Start cached_start(std::size_t number);

} // namespace plprove
