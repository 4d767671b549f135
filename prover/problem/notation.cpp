#include "prover/problem/notation.h"

#include <bit>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>

namespace plprove {

namespace {

/// Reads `text`, and knows its column for errors that point at what is wrong.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    bool at_end() const { return position_ == text_.size(); }
    char peek() const { return at_end() ? '\0' : text_[position_]; }
    std::size_t column() const { return position_ + 1; }
    char next() { return text_[position_++]; }
    bool take(char c) {
        if (at_end() || peek() != c) return false;
        ++position_;
        return true;
    }
    bool take(std::string_view word) {
        if (!text_.substr(position_).starts_with(word)) return false;
        position_ += word.size();
        return true;
    }
    void skip_blanks() {
        while (take(' ')) {
        }
    }
    /// What is written here is no feature at all if it has letters, and no '/'.
    void refuse_word_without_views() const {
        const std::string_view word =
            text_.substr(position_).substr(0, text_.find_first_of(" +", position_) - position_);
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        if (word.size() < 2 || !std::ranges::all_of(word, is_letter)) return;
        fail_at(column(),
                "'" + std::string(word.substr(0, longest_word)) +
                    "' is no feature: write what each view sees, with '/' between, as in P/P/P");
    }
    [[noreturn]] void fail(const std::string& expected) const {
        const std::string found = at_end() ? "the end" : describe(text_.substr(position_));
        fail_at(column(), "found " + found + ", expected " + expected);
    }
    [[noreturn]] static void fail_at(std::size_t column, const std::string& message) {
        throw NotationError("column " + std::to_string(column) + ": " + message);
    }

private:
    static constexpr std::size_t longest_word = 40; ///< in messages

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

bool is_capital(char c) {
    return c >= 'A' && c <= 'Z' && c != 'P';
}

bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}

/// What one view sees of a feature, or what no view sees: `P`, and letters of lines.
struct Symbol {
    bool point = false;
    std::string letters;
};

/// A feature as written, and where.
struct Written {
    std::size_t column = 1;
    std::vector<Symbol> views;
    Symbol unseen;
};

/// Reads features as section 1 spells them, or section 13 (`in_general`).
class FeatureReader {
public:
    FeatureReader(Cursor& cursor, bool in_general) : cursor_(cursor), in_general_(in_general) {}

    Feature feature() { return feature_of(written()); }

    /// Reads a feature, and appends the copies that its multiplicity asks for.
    void append_term(Features& features) {
        const std::size_t copies = multiplicity();
        const Written text = written();
        const Feature feature = feature_of(text);
        if (!features.empty() && feature.views() != features.front().views())
            fail(text,
                 "found " + std::to_string(feature.views()) + " views, expected " +
                     std::to_string(features.front().views()) +
                     " as in the first feature: write the same number of views in every feature");
        if (features.size() + copies > max_features)
            fail(text, "found more than " + std::to_string(max_features) +
                           " features: write at most this number");
        for (std::size_t i = 0; i < feature.shared.size(); ++i)
            share(text, feature.shared[i], views_of(feature, static_cast<int>(i)), copies);
        features.insert(features.end(), copies, feature);
    }

    /// Refuses letters that only one point has, when all features were read.
    void refuse_unshared() const {
        for (const auto& [letter, line] : shared_)
            if (line.points < 2)
                throw NotationError(std::string("the line ") + letter +
                                    " has only one point: write a small letter for it, or " +
                                    letter + " at another point, too");
    }

private:
    struct SharedLine {
        ViewSet seen = 0;
        std::size_t points = 0;
    };

    [[noreturn]] static void fail(const Written& text, const std::string& message) {
        throw NotationError("column " + std::to_string(text.column) + ": " + message);
    }

    std::size_t multiplicity() {
        const auto digit_follows = [&] { return cursor_.peek() >= '0' && cursor_.peek() <= '9'; };
        if (!digit_follows()) return 1;
        std::size_t count = 0;
        while (digit_follows() && count <= max_features)
            count = 10 * count + static_cast<std::size_t>(cursor_.next() - '0');
        if (count < 1 || count > max_features)
            cursor_.fail("a multiplicity from 1 to " + std::to_string(max_features) +
                         " before this");
        cursor_.skip_blanks();
        if (!cursor_.take('*')) cursor_.fail("'*' after a multiplicity");
        cursor_.skip_blanks();
        return count;
    }

    Written written() {
        Written text{cursor_.column(), {}, {}};
        cursor_.refuse_word_without_views();
        const std::size_t most = in_general_ ? most_views : 3;
        do
            text.views.push_back(symbol());
        while (text.views.size() < most && cursor_.take('/'));
        if (text.views.size() < 2) cursor_.fail("'/' and what the next view sees");
        if (cursor_.peek() == '/') cursor_.fail("at most " + std::to_string(most) + " views");
        if (!cursor_.take('(')) return text;
        text.unseen.point = cursor_.take('P');
        text.unseen.letters = letters(true);
        const bool empty = !text.unseen.point && text.unseen.letters.empty();
        if (empty || !cursor_.take(')'))
            cursor_.fail("what no view sees, 'P' or letters of lines, and ')'");
        return text;
    }

    Symbol symbol() {
        Symbol seen;
        if (cursor_.take('-')) return seen;
        seen.point = cursor_.take('P');
        seen.letters = letters(seen.point);
        if (!seen.point && seen.letters.empty())
            cursor_.fail("what a view sees: 'P' for a point, letters for lines, or '-' for "
                         "nothing");
        return seen;
    }

    std::string letters(bool may_be_several) {
        std::string read;
        while (is_small(cursor_.peek()) || (in_general_ && is_capital(cursor_.peek()))) {
            if (!read.empty() && !may_be_several)
                cursor_.fail("'P' before two lines: a view that sees two lines of a point sees the "
                             "point (Definition 1 of the paper)");
            if (!read.empty() && read.back() >= cursor_.peek())
                cursor_.fail("the letters of lines in alphabetical order, capitals first, each "
                             "once");
            read += cursor_.next();
        }
        return read;
    }

    /// The views that see each line of a feature; capital letters come before small ones.
    static std::map<char, ViewSet> lines_of(const Written& text) {
        std::map<char, ViewSet> lines;
        for (std::size_t view = 0; view < text.views.size(); ++view)
            for (const char letter : text.views[view].letters)
                lines[letter] |= ViewSet{1} << view;
        for (const char letter : text.unseen.letters)
            if (!lines.emplace(letter, 0).second)
                fail(text, std::string("a view sees the line ") + letter +
                               ", which stands in parentheses: leave it out there");
        return lines;
    }

    Feature feature_of(const Written& text) const {
        const std::map<char, ViewSet> lines = lines_of(text);
        Feature feature{text.unseen.point || lines.size() > 1, static_cast<int>(lines.size()), {}};
        for (const Symbol& symbol : text.views) {
            if (symbol.point && text.unseen.point)
                fail(text, "'P' in parentheses is a point that no view sees, but a view sees it: "
                           "leave out '(P)'");
            feature.has_point = feature.has_point || symbol.point;
            feature.sights.push_back({symbol.point, 0});
        }
        int line = 0;
        for (const auto& [letter, views] : lines) {
            if (is_capital(letter)) feature.shared += letter;
            show_line(feature, line++, views);
        }
        if (!in_general_) refuse_gaps(text, lines);
        if (!feature.has_point && lines.empty())
            fail(text, "nothing is in this feature: leave it out, or write '(P)' for a point that "
                       "no view sees, or '(a)' for a line");
        if (!feature.has_point && !feature.shared.empty())
            fail(text, "no point of this feature is on the line " + feature.shared +
                           ": write a small letter for a line that meets no point");
        return feature;
    }

    static void refuse_gaps(const Written& text, const std::map<char, ViewSet>& lines) {
        char expected = 'a';
        for (const auto& [letter, views] : lines)
            if (letter != expected++)
                fail(text, lines.contains('p')
                               ? "found a small p: write a capital P for a point"
                               : "found pins with gaps: name them a, b, ... without gaps");
    }

    void share(const Written& text, char letter, ViewSet views, std::size_t points) {
        SharedLine& line = shared_.emplace(letter, SharedLine{views, 0}).first->second;
        if (line.seen != views)
            fail(text, std::string("other views see the line ") + letter +
                           " here than at an earlier point: write " + letter +
                           " in the same views at each of its points");
        line.points += points;
    }

    Cursor& cursor_;
    bool in_general_;
    std::map<char, SharedLine> shared_;
};

/// Reads a sum to the end of the text.
Features read_sum(Cursor& cursor, bool in_general) {
    FeatureReader reader(cursor, in_general);
    Features features;
    do {
        cursor.skip_blanks();
        reader.append_term(features);
        cursor.skip_blanks();
    } while (cursor.take('+'));
    if (!cursor.at_end()) cursor.fail("'+' and another feature, or the end");
    reader.refuse_unshared();
    return features;
}

/// `(Pb)`: the point, where it would not be understood, and the lines that no view sees.
std::string unseen_notation(const Feature& feature) {
    std::string unseen;
    if (feature.has_point && !point_is_seen(feature) && feature.lines < 2) unseen += 'P';
    for (int line = 0; line < feature.lines; ++line)
        if (!is_seen(feature, line)) unseen += letter_of(feature, line);
    return unseen.empty() ? unseen : "(" + unseen + ")";
}

} // namespace

Feature parse_feature(std::string_view text) {
    Cursor cursor(text);
    Feature feature = FeatureReader(cursor, false).feature();
    if (!cursor.at_end()) cursor.fail("the end of the feature");
    return feature;
}

Features parse_features(std::string_view text) {
    Cursor cursor(text);
    return read_sum(cursor, false);
}

const CameraModel& cameras_of(std::string_view text) {
    for (const CameraModel* model : camera_models())
        if (!model->prefix.empty() && text.starts_with(model->prefix)) return *model;
    return calibrated_cameras;
}

Problem parse_problem(std::string_view text) {
    Cursor cursor(text);
    cursor.skip_blanks();
    const CameraModel& cameras = cameras_of(text.substr(cursor.column() - 1));
    cursor.take(cameras.prefix);
    const Problem problem = problem_of(read_sum(cursor, true), cameras);
    refuse_invalid(problem);
    return *in_order_of_construction(problem);
}

std::string notation(const Feature& feature) {
    std::string text;
    for (int view = 0; view < feature.views(); ++view) {
        if (view > 0) text += '/';
        const std::size_t start = text.size();
        if (feature.sees_point(view)) text += 'P';
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line)) text += letter_of(feature, line);
        if (text.size() == start) text += '-';
    }
    return text + unseen_notation(feature);
}

std::string notation(const Features& features) {
    std::string text;
    for (std::size_t i = 0; i < features.size();) {
        std::size_t same = i + 1;
        while (same < features.size() && features[same] == features[i])
            ++same;
        if (i > 0) text += " + ";
        if (same - i > 1) text += std::to_string(same - i) + "*";
        text += notation(features[i]);
        i = same;
    }
    return text;
}

std::string notation(const Problem& problem) {
    const std::string prefix(problem.cameras->prefix);
    return prefix + (prefix.empty() ? "" : " ") + notation(features_of(problem));
}

} // namespace plprove
