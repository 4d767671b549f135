#include "prover/system/words.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <numeric>
#include <sstream>
#include <vector>

namespace plprove {

namespace {

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// The Damerau-Levenshtein distance, where no letter is edited twice.
std::size_t edits(const std::string& from, const std::string& to) {
    // rows[i][j]: from the first i letters of `from` to the first j of `to`.
    std::vector<std::vector<std::size_t>> rows(from.size() + 1,
                                               std::vector<std::size_t>(to.size() + 1));
    std::iota(rows[0].begin(), rows[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= from.size(); ++i) {
        rows[i][0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t replaced = rows[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            rows[i][j] = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced});
            const bool exchanged =
                i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
            if (exchanged) rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
        }
    }
    return rows.back().back();
}

bool is_printable(char c) {
    return c >= ' ' && c <= '~';
}

} // namespace

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    if (word.size() > longest || !std::ranges::all_of(word, is_printable)) return "this";
    return "'" + std::string(word) + "'";
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string result(text.substr(0, longest));
    std::ranges::replace_if(result, std::not_fn(is_printable), '?');
    return text.size() > longest ? result + "..." : result;
}

std::string wrapped(const std::string& text, std::size_t columns) {
    std::string result;
    std::size_t column = 0;
    std::istringstream words(text);
    for (std::string word; words >> word; column += word.size() + 1) {
        const bool fits = column + word.size() <= columns;
        if (!result.empty()) result += fits ? ' ' : '\n';
        if (!fits) column = 0;
        result += word;
    }
    return result;
}

bool has_control_character(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x20 || byte == 0x7f) return true;
        // U+0080 to U+009F, in two bytes
        if (byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0)
            return true;
    }
    return false;
}

std::optional<std::string> most_similar(const std::string& word,
                                        std::span<const std::string> candidates) {
    constexpr std::size_t longest_word = 100;
    constexpr std::size_t most_edits = 3;
    if (word.size() > longest_word) return std::nullopt;
    std::optional<std::string> best;
    std::size_t fewest = std::min(most_edits, (word.size() + 2) / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t needed = edits(lower_case(word), lower_case(candidate));
        if (needed >= fewest) continue;
        fewest = needed;
        best = candidate;
    }
    return best;
}

} // namespace plprove
