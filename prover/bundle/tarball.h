// A tar file as a value: the bytes depend on the files alone, not on the day, the owner or the
// order in which a file system lists them.
#pragma once

#include <map>
#include <string>

namespace plprove {

/// Contents by path; a path is relative, with '/' between its parts.
using Files = std::map<std::string, std::string>;

/// The files as a POSIX ustar archive under the folder `root`, compressed with zstd, in the order
/// of their paths: readable by all, owned by nobody in particular, all of one fixed date. Another
/// version of the zstd library may compress the same tar file to other bytes. Throws
/// std::runtime_error with libarchive's message.
std::string tar_zst(const Files& files, const std::string& root);

} // namespace plprove
