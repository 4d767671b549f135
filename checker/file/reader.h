// Reads a certificate file by lines and words, strictly as FORMAT.md, section 5, spells them. Knows
// nothing of what they mean.
#pragma once

#include "checker/file/complaint.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace checker {
inline constexpr std::size_t largest_file = std::size_t{64} << 20; // bytes
inline constexpr std::size_t longest_line = 16384;                 // bytes

/// Numbers of at most 6 digits.
using Numbers = std::vector<int>;

/// A place in a file. Members throw Malformed if the file is not as they expect.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {
        if (bytes.size() > largest_file) throw Malformed{{0, "the file is larger than 64 MiB"}};
        end_line();
    }

    std::size_t line() const { return line_; }

    /// Whether the line has no more words; after end_line(), whether there are no more lines.
    bool at_end() const { return rest_.empty(); }

    /// Whether this is the next word.
    bool comes(std::string_view word) const { return rest_.substr(0, rest_.find(' ')) == word; }

    /// Whether the next word begins with a digit.
    bool comes_digit() const { return !rest_.empty() && rest_[0] >= '0' && rest_[0] <= '9'; }

    /// Takes the next word; empty if the line has none.
    std::string_view word() {
        const std::string_view next = cut(rest_);
        if (rest_ == "\\") read_line(true);
        return next;
    }

    /// Takes what the pattern says: @ stands for a coordinate, # for a count, $ for the end of the
    /// line, any other word for itself.
    Numbers take(std::string_view pattern) {
        Numbers numbers;
        while (!pattern.empty()) {
            const std::string_view expected = cut(pattern);
            if (expected == "@")
                numbers.push_back(small_integer(-999'999, 999'999));
            else if (expected == "#")
                numbers.push_back(small_integer(0, 999'999));
            else if (expected == "$")
                end_line();
            else if (const std::string_view found = word(); found != expected)
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

    int small_integer(int low, int high) { return static_cast<int>(integer(low, high)); }

    std::string big_integer(std::size_t most_digits) {
        const std::string found(word());
        const std::size_t digits = found.size() - found.starts_with('-');
        if (!canonical(found) || digits > most_digits)
            fail(found, say("an integer of at most ", most_digits, " digits"));
        return found;
    }

    /// Goes to the next line that is no comment.
    void end_line() {
        if (!at_end()) fail(rest_, "the end of the line");
        do {
            rest_ = {};
            if (bytes_.empty()) return;
            read_line(false);
        } while (line_ > 1 && rest_.starts_with('#'));
    }

    [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
        const std::string what = found.empty() ? "nothing" : '`' + printable(found, 40) + '`';
        throw Malformed{{line_, say("found ", what, ", expected ", expected)}};
    }

private:
    /// Takes the next line of the file, without its line feed. The line before it may go on in it.
    void read_line(bool goes_on) {
        ++line_;
        const std::string_view start = bytes_.substr(0, longest_line + 1);
        rest_ = start.substr(0, start.find('\n'));
        if (rest_.size() == start.size()) fail(rest_, "a line feed within 16384 bytes");
        bytes_.remove_prefix(rest_.size() + 1);
        for (const char& c : rest_)
            if (c < ' ' || c > '~') fail({&c, 1}, "printable ASCII, a line feed at the end");
        if (!goes_on && line_ > 1 && rest_.starts_with('#')) return;
        const bool spaced = (' ' + std::string(rest_) + ' ').find("  ") == std::string::npos;
        if (!spaced) fail(rest_, "words separated by one space");
        if (rest_ == "\\") fail(rest_, "a word before the backslash");
        if (goes_on && rest_[0] == '#') fail(rest_, "the rest of the line before, no comment");
    }

    static std::string_view cut(std::string_view& words) {
        const std::string_view word = words.substr(0, words.find(' '));
        words.remove_prefix(std::min(word.size() + 1, words.size()));
        return word;
    }

    /// Whether this is how an integer is spelled: there is one way for each.
    static bool canonical(std::string_view word) {
        if (word.starts_with('-') && word != "-0") word.remove_prefix(1);
        const bool leading_zero = word.starts_with('0') && word != "0";
        return !word.empty() && !leading_zero && word.find_first_not_of("0123456789") == word.npos;
    }

    std::string_view bytes_; // the lines after this one
    std::string_view rest_;  // the words not taken
    std::size_t line_ = 0;
};
} // namespace checker
