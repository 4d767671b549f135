// Reads a certificate file by lines and words, strictly as FORMAT.md, section 5, spells them, and
// knows nothing of what they mean.
#pragma once

#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace checker {

inline constexpr std::size_t largest_file = std::size_t{64} << 20; // bytes

/// What is wrong with a line of a file.
struct Complaint {
    std::size_t line;
    std::string reason;
};

/// The parts, written one after the other.
template <class... Part>
std::string say(const Part&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

/// Text of unknown origin made fit for a terminal: other than printable ASCII is written \xNN, and
/// what is longer than `limit` is cut.
std::string printable(std::string_view text, std::size_t limit);

using Numbers = std::vector<std::int64_t>;

/// Every member throws a Complaint where the file is not as expected.
class Reader {
public:
    /// Begins with the first line. The bytes must outlive what is read.
    explicit Reader(std::string_view bytes);

    std::size_t line() const { return line_; }
    /// Whether there are no more words in the line; right after end_line(), no more lines.
    bool at_end() const { return rest_.empty(); }
    bool comes(std::string_view word) const { return rest_.substr(0, rest_.find(' ')) == word; }
    /// Takes the next word of the line; empty if there is none.
    std::string_view word();
    /// Takes all words that are left of the line.
    std::string_view rest() { return std::exchange(rest_, {}); }
    /// Takes the words of a pattern, in which @ stands for a coordinate, # for a count, % for a
    /// nonzero residue. Returns the numbers.
    Numbers take(std::string_view pattern);
    std::int64_t integer(std::int64_t low, std::int64_t high) { return integer(word(), low, high); }
    std::int64_t integer(std::string_view word, std::int64_t low, std::int64_t high) const;
    /// Takes an integer of at most 1000 digits.
    std::string big_integer();
    /// Takes the end of the line, and comments.
    void end_line();
    [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

private:
    std::string_view bytes_; // the lines after this one
    std::string_view rest_;  // of this line
    std::size_t line_ = 0;   // its number
};

} // namespace checker
