// Reads a certificate file by lines and words, strictly as FORMAT.md, section 5, spells them, and
// knows nothing of what they mean.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <vector>

namespace checker {
using Numbers = std::vector<std::int64_t>;
inline constexpr std::size_t largest_file = std::size_t{64} << 20, longest_line = 16384; // bytes

/// The parts, written one after the other.
template <class... Part> std::string say(const Part&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

/// Text of unknown origin made fit for a terminal: all but printable ASCII is written \xNN, and
/// what is longer than `limit` is cut.
inline std::string printable(std::string_view text, std::size_t limit) {
    std::string safe;
    for (const char c : text.substr(0, limit)) {
        const bool plain = c >= ' ' && c <= '~' && c != '\\';
        const auto digit = [c](int shift) { return "0123456789abcdef"[c >> shift & 15]; };
        safe += plain ? std::string{c} : std::string{'\\', 'x', digit(4), digit(0)};
    }
    return text.size() > limit ? safe + "..." : safe;
}

/// What is wrong with a line of a file.
struct Complaint {
    std::size_t line;
    std::string reason;
};

/// A place in a file. Members throw a Complaint if the file is not as they expect.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {
        if (bytes.size() > largest_file) throw Complaint{0, "the file is larger than 64 MiB"};
        end_line();
    }
    std::size_t line() const { return line_; }
    /// Whether the line has no more words; after end_line(), whether there are no more lines.
    bool at_end() const { return rest_.empty(); }
    bool comes(std::string_view word) const { return rest_.substr(0, rest_.find(' ')) == word; }
    std::string_view rest() const { return rest_; } // the words to come
    std::string_view word() { return cut(rest_); }  // the next; empty if there is none

    /// Takes these words: @ stands for a coordinate, # for a count, $ for the end of the line.
    Numbers take(std::string_view pattern) {
        Numbers numbers;
        while (!pattern.empty()) {
            const std::string_view expected = cut(pattern);
            if (expected == "@")
                numbers.push_back(integer(-999'999, 999'999));
            else if (expected == "#")
                numbers.push_back(integer(0, 999'999));
            else if (expected == "$")
                end_line();
            else if (const auto found = word(); found != expected)
                fail(found, say('`', expected, '`'));
        }
        return numbers;
    }

    std::int64_t integer(std::int64_t low, std::int64_t high) {
        const std::string_view found = word();
        std::int64_t value = 0;
        const auto error = std::from_chars(found.data(), found.data() + found.size(), value).ec;
        if (!canonical(found) || error != std::errc{} || value < low || value > high)
            fail(found, say("an integer from ", low, " to ", high));
        return value;
    }

    /// An integer of at most 1000 digits.
    std::string big_integer() {
        const std::string found(word());
        if (!canonical(found) || found.size() - found.starts_with('-') > 1000)
            fail(found, "an integer of at most 1000 digits");
        return found;
    }

    /// Goes to the next line that is no comment.
    void end_line() {
        if (!at_end()) fail(rest_, "the end of the line");
        do {
            rest_ = {};
            if (bytes_.empty()) return;
            ++line_;
            const std::string_view start = bytes_.substr(0, longest_line + 1);
            rest_ = start.substr(0, start.find('\n'));
            if (rest_.size() == start.size()) fail(rest_, "a line feed within 16384 bytes");
            bytes_.remove_prefix(rest_.size() + 1);
            for (const char& c : rest_)
                if (c < ' ' || c > '~') fail({&c, 1}, "printable ASCII, a line feed at the end");
        } while (line_ > 1 && rest_.starts_with('#'));
        if (at_end() || rest_[0] == ' ' || rest_.back() == ' ' || rest_.find("  ") != rest_.npos)
            fail(rest_, "words separated by one space");
    }

    [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
        const std::string what = found.empty() ? "nothing" : '`' + printable(found, 40) + '`';
        throw Complaint{line_, say("found ", what, ", expected ", expected)};
    }

private:
    static std::string_view cut(std::string_view& words) {
        const std::string_view word = words.substr(0, words.find(' '));
        words.remove_prefix(std::min(word.size() + 1, words.size()));
        return word;
    }

    /// Whether this is how an integer is spelled: there is one way for each.
    static bool canonical(std::string_view word) {
        if (word.starts_with('-') && word != "-0") word.remove_prefix(1);
        return !word.empty() && (word[0] != '0' || word == "0") &&
               word.find_first_not_of("0123456789") == word.npos;
    }

    std::string_view bytes_, rest_; // the lines after this one; the words not taken
    std::size_t line_ = 0;
};
} // namespace checker
