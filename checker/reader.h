// Reads a certificate file by lines and words, strictly as FORMAT.md, section 5, spells them, and
// knows nothing of what they mean.
#pragma once

#include <cstdint>
#include <sstream>
#include <string_view>
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

/// Text of unknown origin made fit for a terminal: all but printable ASCII is written \xNN, and
/// what is longer than `limit` is cut.
std::string printable(std::string_view text, std::size_t limit);

using Numbers = std::vector<std::int64_t>;

/// A place in a file. Members throw a Complaint if the file is not as they expect.
class Reader {
public:
    explicit Reader(std::string_view bytes); // at the first line

    std::size_t line() const { return line_; }
    /// Whether the line has no more words; right after end_line(), whether there are no more lines.
    bool at_end() const { return rest_.empty(); }
    bool comes(std::string_view word) const { return rest_.substr(0, rest_.find(' ')) == word; }

    std::string_view word();                // empty if there is none
    Numbers take(std::string_view pattern); // words, where @ stands for a coordinate, # a count
    std::int64_t integer(std::int64_t low, std::int64_t high);
    std::string big_integer(); // of at most 1000 digits
    void end_line();           // and the comments after it
    [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

private:
    std::string_view bytes_, rest_; // the lines after this one; the words not taken
    std::size_t line_ = 0;
};

} // namespace checker
