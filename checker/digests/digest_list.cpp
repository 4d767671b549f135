#include "checker/digests/digest_list.h"

namespace checker {
static constexpr std::size_t digest_size = 64; // hexadecimal digits
static constexpr std::size_t longest_name = 4096;

bool is_digest_list(std::string_view bytes) {
    return bytes.find_first_not_of("0123456789abcdef") == digest_size;
}

DigestList read_digest_list(std::string_view bytes) {
    DigestList list;
    while (!bytes.empty()) {
        const std::size_t number = list.files.size() + 1;
        const std::string_view line = bytes.substr(0, bytes.find('\n'));
        const std::string_view name = line.substr(std::min(line.size(), digest_size + 2));
        const bool complete = line.size() < bytes.size();
        const bool has_name = !name.empty() && name.size() <= longest_name;
        if (!complete || !is_digest_list(line) || !has_name || line.substr(digest_size, 2) != "  ")
            throw Malformed{{number, "expected a SHA-256 digest, two spaces, a name"}};
        list.files.push_back(
            {std::string(line.substr(0, digest_size)), printable(name, longest_name)});
        bytes.remove_prefix(line.size() + 1);
    }
    return list;
}
} // namespace checker
