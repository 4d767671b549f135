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

/// Takes lines of a digest, two spaces and a name. Lines end with LF, or CR LF. Throws Malformed.
DigestList read_digest_list(std::string_view bytes);

/// The folder in which the program runs, from the root.
std::string working_folder();

/// Where a file is: its path from the root, without `.` and `..`. A relative name starts in the
/// folder. Paths are compared as text: links are not followed.
std::string place_of(std::string_view name, std::string_view folder);

/// The folder of a file, by its place.
std::string_view folder_of(std::string_view place);
} // namespace checker
