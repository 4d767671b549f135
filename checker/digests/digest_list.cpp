#include "checker/digests/digest_list.h"

#include <filesystem>

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
        std::string_view name = line.substr(std::min(line.size(), digest_size + 2));
        if (name.ends_with('\r')) name.remove_suffix(1);
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

std::string working_folder() {
    std::error_code none; // without a folder, relative names start at the root
    return printable(std::filesystem::current_path(none).string(), longest_name);
}

std::string place_of(std::string_view name, std::string_view folder) {
    const std::string path = name.starts_with('/') ? std::string(name) : say(folder, '/', name);
    std::string place;
    for (std::size_t start = 0; start < path.size();) {
        const std::size_t end = std::min(path.find('/', start), path.size());
        const std::string_view part = std::string_view(path).substr(start, end - start);
        start = end + 1;
        if (part == "..")
            place.resize(place.empty() ? 0 : place.rfind('/'));
        else if (!part.empty() && part != ".")
            place += say('/', part);
    }
    return place;
}

std::string_view folder_of(std::string_view place) {
    return place.substr(0, place.rfind('/'));
}
} // namespace checker
