#include "prover/problem/notation.h"

#include <bit>
#include <iomanip>
#include <optional>
#include <sstream>

namespace plprove {

namespace {

constexpr int max_views = 3;

/// A reader of `text` that knows its column, for errors that point at what is wrong.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    bool at_end() const { return position_ == text_.size(); }
    char peek() const { return at_end() ? '\0' : text_[position_]; }
    bool take(char c) {
        if (peek() != c || at_end()) return false;
        ++position_;
        return true;
    }
    void skip_blanks() {
        while (take(' ')) {
        }
    }
    [[noreturn]] void fail(const std::string& expected) const {
        const std::string found = at_end() ? "the end" : describe(text_.substr(position_));
        throw NotationError("column " + std::to_string(position_ + 1) + ": found " + found +
                            ", expected " + expected);
    }

private:
    /// What the text begins with.
    static std::string describe(std::string_view text) {
        const auto code = static_cast<unsigned char>(text.front());
        if (code > 0x20 && code < 0x7f) return std::string("'") + text.front() + "'";
        if (code == 0x20) return "a blank";
        if (const std::optional<std::uint32_t> code_point = code_point_beyond_ascii(text)) {
            std::ostringstream name;
            name << "U+" << std::hex << std::uppercase << std::setw(4) << std::setfill('0')
                 << *code_point << " (no ASCII)";
            return name.str();
        }
        return "the byte " + std::to_string(code);
    }

    /// The code point with which the text begins, if that is UTF-8 of two bytes or more.
    static std::optional<std::uint32_t> code_point_beyond_ascii(std::string_view text) {
        const auto first = static_cast<unsigned char>(text.front());
        const auto length = static_cast<std::size_t>(std::countl_one(first));
        if (length < 2 || length > 4 || text.size() < length) return std::nullopt;
        std::uint32_t code = first & (0x7fU >> length);
        for (const char c : text.substr(1, length - 1)) {
            const auto byte = static_cast<unsigned char>(c);
            if ((byte & 0xc0U) != 0x80U) return std::nullopt;
            code = code << 6U | (byte & 0x3fU);
        }
        return code;
    }

    std::string_view text_;
    std::size_t position_ = 0;
};

Sight read_sight(Cursor& cursor) {
    Sight sight;
    if (cursor.take('-')) return sight;
    sight.point = cursor.take('P');
    while (cursor.peek() >= 'a' && cursor.peek() <= 'z') {
        const std::uint32_t pin = 1U << (cursor.peek() - 'a');
        if (sight.pins >= pin) cursor.fail("the pins of a view in alphabetical order, each once");
        if (!sight.point && sight.pins != 0)
            cursor.fail("'P' before two pins: a view that sees two lines of a point sees the point "
                        "(Definition 1 of the paper)");
        sight.pins |= pin;
        cursor.take(cursor.peek());
    }
    if (!sight.point && sight.pins == 0)
        cursor.fail("what a view sees: 'P' for a point, the letters a to z of pins, or '-' for "
                    "nothing");
    return sight;
}

/// What no view sees, in parentheses: `(P)`, `(b)`, `(Pb)`; nothing where there is no parenthesis.
Sight read_unseen(Cursor& cursor) {
    if (!cursor.take('(')) return {};
    Sight unseen;
    unseen.point = cursor.take('P');
    while (cursor.peek() >= 'a' && cursor.peek() <= 'z') {
        const std::uint32_t pin = 1U << (cursor.peek() - 'a');
        if (unseen.pins >= pin) cursor.fail("the unseen lines in alphabetical order, each once");
        unseen.pins |= pin;
        cursor.take(cursor.peek());
    }
    if (unseen == Sight{} && cursor.peek() == ')')
        cursor.fail("what no view sees: 'P', or the letters of lines");
    if (!cursor.take(')')) cursor.fail("')' after what no view sees");
    return unseen;
}

Feature read_feature(Cursor& cursor) {
    Feature feature;
    do
        feature.sights.push_back(read_sight(cursor));
    while (feature.views() < max_views && cursor.take('/'));
    if (feature.views() < 2) cursor.fail("'/' and what the next view sees");
    Sight somewhere = read_unseen(cursor);
    const Sight unseen = somewhere;
    for (const Sight& sight : feature.sights) {
        if ((sight.point && unseen.point) || (sight.pins & unseen.pins) != 0)
            cursor.fail("in parentheses only what no view sees, in the feature that ends here");
        somewhere.point = somewhere.point || sight.point;
        somewhere.pins |= sight.pins;
    }
    if (!std::has_single_bit(somewhere.pins + 1)) {
        constexpr std::uint32_t pin_p = 1U << ('p' - 'a');
        const bool meant_points = (somewhere.pins & pin_p) != 0;
        cursor.fail(meant_points
                        ? "a capital P for a point in the feature that ends here"
                        : "pins named a, b, ... without gaps in the feature that ends here");
    }
    feature.lines = std::popcount(somewhere.pins);
    if (!somewhere.point && feature.lines == 0)
        cursor.fail("'(P)' for a point that no view sees, or '(a)' for a line");
    // Two lines of a feature meet in its point, seen or not; one line without a point is a free
    // line.
    feature.has_point = somewhere.point || feature.lines > 1;
    return feature;
}

std::optional<std::size_t> read_multiplicity(Cursor& cursor) {
    if (cursor.peek() < '0' || cursor.peek() > '9') return std::nullopt;
    std::size_t count = 0;
    while (cursor.peek() >= '0' && cursor.peek() <= '9') {
        count = 10 * count + static_cast<std::size_t>(cursor.peek() - '0');
        if (count > max_features)
            cursor.fail("a multiplicity of at most " + std::to_string(max_features));
        cursor.take(cursor.peek());
    }
    if (count == 0) cursor.fail("a multiplicity of at least 1 before this");
    cursor.skip_blanks();
    if (!cursor.take('*')) cursor.fail("'*' after a multiplicity");
    cursor.skip_blanks();
    return count;
}

} // namespace

Feature parse_feature(std::string_view text) {
    Cursor cursor(text);
    Feature feature = read_feature(cursor);
    if (!cursor.at_end()) cursor.fail("the end of the feature");
    return feature;
}

Problem parse_problem(std::string_view text) {
    Cursor cursor(text);
    Problem problem;
    do {
        cursor.skip_blanks();
        const std::size_t count = read_multiplicity(cursor).value_or(1);
        const Feature feature = read_feature(cursor);
        if (!problem.empty() && feature.views() != problem.front().views())
            cursor.fail("the same number of views in every feature");
        if (problem.size() + count > max_features)
            cursor.fail("at most " + std::to_string(max_features) + " features");
        problem.insert(problem.end(), count, feature);
        cursor.skip_blanks();
    } while (cursor.take('+'));
    if (!cursor.at_end()) cursor.fail("'+' and another feature, or the end");
    return problem;
}

std::string notation(const Problem& problem) {
    std::string text;
    for (std::size_t i = 0; i < problem.size();) {
        std::size_t same = i + 1;
        while (same < problem.size() && problem[same] == problem[i])
            ++same;
        if (i > 0) text += " + ";
        if (same - i > 1) text += std::to_string(same - i) + "*";
        text += notation(problem[i]);
        i = same;
    }
    return text;
}

} // namespace plprove
