// Text for people: put together from parts, and made safe for a terminal.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace checker {
/// The parts, written one after the other.
template <class... Part> std::string say(const Part&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

/// A number of things, one or more: `1 record`, `2 records`.
inline std::string counted(std::size_t number, std::string_view thing) {
    return say(number, ' ', thing, number == 1 ? "" : "s");
}

/// Text of unknown origin, fit for a terminal: all but printable ASCII is written \xNN. What is
/// longer than `limit` is cut.
inline std::string printable(std::string_view text, std::size_t limit) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string safe;
    for (const char c : text.substr(0, limit)) {
        if (c >= ' ' && c <= '~' && c != '\\') {
            safe += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        safe += "\\x";
        safe += digits[byte / 16];
        safe += digits[byte % 16];
    }
    return text.size() > limit ? safe + "..." : safe;
}
} // namespace checker
