// Writing a file so that it appears under its name whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace plprove {

/// Writes `content` to a temporary file beside `path`, forces it to the disk and renames it to
/// `path`. Throws std::system_error that names the path; then the old file, if any, is as it was.
void write_atomically(const std::filesystem::path& path, std::string_view content);

} // namespace plprove
