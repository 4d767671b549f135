// Lists of SHA-256 digests, as the program sha256sum writes them (FORMAT.md, section 11).
#pragma once

#include "checker/file/complaint.h"

namespace checker {
struct ListedDigest {
    std::string sha256{};
    std::string name{}; // printable
};

struct DigestList {
    std::vector<ListedDigest> files{};
};

/// Whether the bytes look like such a list: they begin with a digest.
bool is_digest_list(std::string_view bytes);

/// Takes lines of a digest, two spaces and a name. Throws Malformed.
DigestList read_digest_list(std::string_view bytes);
} // namespace checker
