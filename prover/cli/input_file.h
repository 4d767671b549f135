// Files that a command reads.
#pragma once

#include <string>

namespace plprove {

/// Whether there is a file of this name. Arguments that are no names may be asked, too: a problem
/// may be too long for one.
bool names_file(const std::string& argument);

/// The bytes of the file. Throws BadInput if it cannot be read.
std::string content_of(const std::string& path);

} // namespace plprove
