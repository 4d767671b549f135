// The text of a certificate file: words in lines, within the limits that certs/FORMAT.md, section
// 5, sets. What would go beyond them is an error here, and no file is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace plprove {

/// The most bytes of a line, without its line feed, and of a file.
inline constexpr std::size_t longest_line = 16384;
inline constexpr std::size_t largest_file = std::size_t{64} << 20U;

/// A certificate does not fit the format. The message says which limit, and what to do.
class FormatLimit : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The first line of a file of this kind: `plcert 2 KIND`, with its line feed.
std::string first_line(std::string_view kind);

/// Adds a line of words, and a line feed. A line that is too long goes on in the next ones: it is
/// broken as late as possible, at a space, and each part but the last ends in ` \`. Throws
/// FormatLimit if a word is too long for any line.
void append_line(std::string& text, std::string_view line);

/// The file of this kind with these lines. Throws FormatLimit if it is larger than the format
/// allows; `advice` ends the message with what the user may do.
std::string certificate_file(std::string_view kind, std::string_view lines,
                             std::string_view advice);

/// How the integer is written. Throws FormatLimit if it has more than `digits` digits; `what` names
/// it in the message.
std::string with_digits(std::int64_t value, std::size_t most, std::string_view what);
/// The same for an integer that is written already.
std::string with_digits(std::string value, std::size_t most, std::string_view what);

/// Integers of at most `digits` digits; points, directions, cameras and most images have 6.
std::string coordinates(std::span<const std::int64_t> values, std::size_t digits = 6);
std::string coordinates(std::span<const int> values, std::size_t digits = 6);

/// Lines of a file, or of a part of one.
class CertificateText {
public:
    /// One line: the words, separated by spaces. A word is a text, an integer or a range of words;
    /// a text may have several words.
    template <class... Words>
    void line(const Words&... words) {
        line_.clear();
        (append(words), ...);
        line_.pop_back();
        append_line(text_, line_);
    }

    /// What was written so far, which is given away.
    std::string take() { return std::move(text_); }

private:
    void append(std::string_view words) { (line_ += words) += ' '; }
    void append(const char* words) { append(std::string_view(words)); }
    template <class Integer>
    requires std::is_integral_v<Integer>
    void append(Integer number) { append(std::to_string(number)); }
    template <class Range>
    requires(!std::is_convertible_v<Range, std::string_view> &&
             requires(const Range& range) { range.begin(); }) void append(const Range& range) {
        for (const auto& word : range)
            append(word);
    }

    std::string line_;
    std::string text_;
};

} // namespace plprove
