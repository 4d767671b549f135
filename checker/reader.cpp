#include "checker/reader.h"

#include <algorithm>
#include <charconv>

namespace checker {

/// Takes the first word off words that are separated by one space each.
static std::string_view cut(std::string_view& words) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    return word;
}

/// Whether this is the spelling of an integer of at most so many digits: there is one for each.
static bool canonical(std::string_view word, std::size_t digits) {
    if (word.starts_with('-') && word != "-0") word.remove_prefix(1);
    return !word.empty() && word.size() <= digits && (word[0] != '0' || word == "0") &&
           word.find_first_not_of("0123456789") == word.npos;
}

std::string printable(std::string_view text, std::size_t limit) {
    std::string safe;
    for (const char c : text.substr(0, limit)) {
        const auto digit = [&](int shift) { return "0123456789abcdef"[c >> shift & 15]; };
        const bool plain = c >= ' ' && c <= '~' && c != '\\';
        safe += plain ? std::string{c} : std::string{'\\', 'x', digit(4), digit(0)};
    }
    return text.size() > limit ? safe + "..." : safe;
}

Reader::Reader(std::string_view bytes) : bytes_(bytes) {
    if (bytes.size() > largest_file) throw Complaint{0, "the file is larger than 64 MiB"};
    end_line();
}

std::string_view Reader::word() {
    return cut(rest_);
}

Numbers Reader::take(std::string_view pattern) {
    Numbers numbers;
    while (!pattern.empty()) {
        const std::string_view expected = cut(pattern);
        if (expected == "@")
            numbers.push_back(integer(-999'999, 999'999));
        else if (expected == "#")
            numbers.push_back(integer(0, 999'999));
        else if (const auto found = word(); found != expected)
            fail(found, say('`', expected, '`'));
    }
    return numbers;
}

std::int64_t Reader::integer(std::int64_t low, std::int64_t high) {
    const std::string_view found = word();
    std::int64_t value = 0;
    const auto error = std::from_chars(found.data(), found.data() + found.size(), value).ec;
    if (!canonical(found, 19) || error != std::errc{} || value < low || value > high)
        fail(found, say("an integer from ", low, " to ", high));
    return value;
}

std::string Reader::big_integer() {
    const std::string_view found = word();
    if (!canonical(found, 1000)) fail(found, "an integer of at most 1000 digits");
    return std::string(found);
}

void Reader::end_line() {
    if (!at_end()) fail(rest_, "the end of the line");
    do {
        rest_ = {};
        if (bytes_.empty()) return;
        ++line_;
        const std::string_view start = bytes_.substr(0, 16384 + 1);
        rest_ = start.substr(0, start.find('\n'));
        if (rest_.size() == start.size()) fail(rest_, "a line feed within 16384 bytes");
        bytes_.remove_prefix(rest_.size() + 1);
        for (const char& c : rest_)
            if (c < ' ' || c > '~') fail({&c, 1}, "printable ASCII, and a line feed at the end");
    } while (line_ > 1 && rest_.starts_with('#'));
    if (at_end() || rest_[0] == ' ' || rest_.back() == ' ' || rest_.find("  ") != rest_.npos)
        fail(rest_, "words separated by one space");
}

void Reader::fail(std::string_view found, std::string_view expected) const {
    const std::string what = found.empty() ? "nothing" : '`' + printable(found, 40) + '`';
    throw Complaint{line_, say("found ", what, ", expected ", expected)};
}

} // namespace checker
