// What the trials ask of a file that was replayed, whatever its kind.
#pragma once

#include "checker/report/report.h"

#include <optional>
#include <string>

/// Why a file is refused: it does not conform to the format, or a record of it does not hold.
struct Refusal {
    bool conforms = true;
    std::string reason{}; // the first
};

/// None if all of the file holds.
inline std::optional<Refusal> refusal_of(const checker::ReplayedFile& file) {
    if (const auto* malformed = std::get_if<checker::Malformed>(&file.content))
        return Refusal{false, malformed->complaint.reason};
    const checker::Refusals& refusals = checker::refusals_of(file);
    if (refusals.count == 0) return std::nullopt;
    return Refusal{true, refusals.first[0].reason};
}

/// What the file proves, if it is of this kind; else nothing of it.
template <class Content>
Content proved_by(const checker::ReplayedFile& file) {
    const auto* content = std::get_if<Content>(&file.content);
    return content ? *content : Content{};
}
