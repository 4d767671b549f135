// Digests of files.
#pragma once

#include <string>

namespace plprove {

/// The SHA-256 digest in 64 hexadecimal digits, as sha256sum has it.
std::string sha256(const std::string& content);

} // namespace plprove
