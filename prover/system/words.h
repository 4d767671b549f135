// Words that people type: quoted in messages, and what a misspelled one was meant to be.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plprove {

/// The word in quotes if it is short and fit for a terminal, else `this`.
std::string in_quotes(std::string_view word);

/// `1 line`, `2 lines`.
template <std::integral Count>
std::string counted(Count count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// The text in printable ASCII: other bytes become `?`, and after `longest` follow three dots.
std::string printable(std::string_view text, std::size_t longest);

/// The words of a text in lines of at most `columns` columns, unless a word is longer.
std::string wrapped(const std::string& text, std::size_t columns);

/// Whether UTF-8 text has a control character, which may move the cursor of a terminal.
bool has_control_character(std::string_view text);

/// The candidate that the fewest edits of the word reach, regardless of case: the insertion,
/// removal or replacement of a letter, or an exchange of neighbours. Nothing if more than a third
/// of the letters, or more than three, would change; the first one of several.
std::optional<std::string> most_similar(const std::string& word,
                                        std::span<const std::string> candidates);

} // namespace plprove
