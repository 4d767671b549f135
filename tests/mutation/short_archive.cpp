#include "tests/mutation/short_archive.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace {

/// The instances of each feature that some of the classes uses.
checker::Signature needed(const checker::Classification& few) {
    checker::Signature most{};
    for (const auto& signature : few.representatives)
        for (std::size_t i = 0; i < signature.size(); ++i)
            most[i] = std::max(most[i], signature[i]);
    return most;
}

/// Whether a line of a pool is kept: of a feature, the instances that are still needed.
bool keep(const std::string& line, checker::Signature& still_needed) {
    if (!line.starts_with("feature ")) return true;
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (line.starts_with("feature " + std::string(checker::features[i].notation) + " "))
            return still_needed[i] > 0 && still_needed[i]-- > 0;
    return true;
}

} // namespace

std::string shorten(std::string_view archive, const checker::Classification& all,
                    std::span<const std::size_t> numbers) {
    checker::Signature still_needed = needed(classification_of(all, numbers));
    std::istringstream in{std::string(archive)};
    std::string text;
    bool in_record = false;
    bool wanted = true;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("#")) continue;
        if (line.starts_with("minimal ") || line.starts_with("deficient ")) {
            in_record = true;
            const std::size_t start = line.find(' ') + 1;
            const std::size_t end = line.find(' ', start);
            const auto place = std::find(numbers.begin(), numbers.end(),
                                         std::stoul(line.substr(start, end - start)));
            wanted = place != numbers.end();
            if (wanted) line.replace(start, end - start, std::to_string(place - numbers.begin()));
        }
        if (in_record ? wanted : keep(line, still_needed)) text += line + "\n";
    }
    return text;
}
