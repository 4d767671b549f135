// Writing a file so that it appears under its name whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace plprove {

/// Puts `content` under `path`: it is written to a file without a name, forced to the disk and only
/// then named, so that a reader finds the old file or the new one, whenever the program is killed
/// or the machine stops. A symbolic link stays, and the file it leads to is replaced; a device or a
/// pipe is written to as it is. Throws std::system_error that names the path; then the old file, if
/// any, is as it was.
void write_atomically(const std::filesystem::path& path, std::string_view content);

} // namespace plprove
