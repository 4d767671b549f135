#include "prover/problem/notation_in_general.h"

#include "prover/problem/validity.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace plprove {

namespace {

constexpr int most_copies = 1000;

/// What one view sees of a feature, or what no view sees: `P`, and letters of lines.
struct Symbol {
    bool point = false;
    std::string letters;
};

struct WrittenFeature {
    std::vector<Symbol> views;
    Symbol unseen;
    std::size_t column = 1;
    int copies = 1;
};

/// Reads `text`, and knows the column for errors.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
    bool at_end() const { return position_ == text_.size(); }
    std::size_t column() const { return position_ + 1; }
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
    [[noreturn]] void fail(const std::string& expected) const {
        const auto code = static_cast<unsigned char>(peek());
        const std::string found = at_end()                     ? "the end"
                                  : code > 0x20 && code < 0x7f ? std::string("'") + peek() + "'"
                                                               : "the byte " + std::to_string(code);
        throw NotationError("column " + std::to_string(column()) + ": found " + found +
                            ", expected " + expected);
    }

private:
    std::string_view text_;
    std::size_t position_ = 0;
};

bool is_capital(char c) {
    return c >= 'A' && c <= 'Z' && c != 'P';
}

bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}

/// Letters of shared lines, then of pins, each in alphabetical order and once.
std::string read_letters(Cursor& cursor) {
    std::string letters;
    while (is_capital(cursor.peek()) || is_small(cursor.peek())) {
        if (!letters.empty() && letters.back() >= cursor.peek())
            cursor.fail("the letters of lines in alphabetical order, capitals first, each once");
        letters += cursor.peek();
        cursor.take(cursor.peek());
    }
    return letters;
}

Symbol read_symbol(Cursor& cursor) {
    Symbol symbol;
    if (cursor.take('-')) return symbol;
    symbol.point = cursor.take('P');
    symbol.letters = read_letters(cursor);
    if (!symbol.point && symbol.letters.size() > 1)
        cursor.fail("'P' before two lines: a view that sees two lines of a point sees the point");
    if (!symbol.point && symbol.letters.empty())
        cursor.fail("what a view sees: 'P' for a point, letters for lines, or '-' for nothing");
    return symbol;
}

WrittenFeature read_feature(Cursor& cursor) {
    WrittenFeature feature;
    feature.column = cursor.column();
    do
        feature.views.push_back(read_symbol(cursor));
    while (cursor.take('/'));
    if (feature.views.size() < 2) cursor.fail("'/' and what the next view sees");
    if (feature.views.size() > most_views)
        throw NotationError("column " + std::to_string(feature.column) + ": found " +
                            std::to_string(feature.views.size()) +
                            " views: write at most 12 views");
    if (cursor.take('(')) {
        feature.unseen.point = cursor.take('P');
        feature.unseen.letters = read_letters(cursor);
        const bool empty = !feature.unseen.point && feature.unseen.letters.empty();
        if (empty || !cursor.take(')'))
            cursor.fail("what no view sees, 'P' or letters of lines, and ')'");
    }
    return feature;
}

int read_copies(Cursor& cursor) {
    if (std::isdigit(static_cast<unsigned char>(cursor.peek())) == 0) return 1;
    int copies = 0;
    while (std::isdigit(static_cast<unsigned char>(cursor.peek())) != 0 && copies <= most_copies) {
        copies = 10 * copies + (cursor.peek() - '0');
        cursor.take(cursor.peek());
    }
    if (copies < 1 || copies > most_copies) cursor.fail("a multiplicity from 1 to 1000 before it");
    cursor.skip_blanks();
    if (!cursor.take('*')) cursor.fail("'*' after a multiplicity");
    cursor.skip_blanks();
    return copies;
}

/// The problem that grows feature by feature.
class Builder {
public:
    explicit Builder(Problem start) : problem_(std::move(start)) {}

    void add(const WrittenFeature& feature) {
        refuse_too_many(problem_);
        const std::map<char, ViewSet> letters = seen_letters(feature);
        const ViewSet seen = seen_point(feature);
        if (feature.unseen.point && seen != 0)
            fail(feature, "'P' in parentheses is a point that no view sees, but a view sees it: "
                          "leave out '(P)'");
        const bool has_point = seen != 0 || feature.unseen.point || letters.size() >= 2;
        if (!has_point) return add_free_line(feature, letters);
        const int point = static_cast<int>(problem_.points.size());
        problem_.points.push_back(seen);
        for (const auto& [letter, views] : letters)
            if (is_capital(letter))
                put_on_shared_line(feature, letter, views, point);
            else
                problem_.lines.push_back({{point}, views});
    }

    /// The problem, when all features were added.
    Problem take() {
        for (const auto& [letter, number] : shared_)
            if (problem_.lines[number].points.size() < 2)
                throw NotationError(std::string("the line ") + letter +
                                    " has only one point: write a small letter for it, or " +
                                    letter + " at another point, too");
        return std::move(problem_);
    }

private:
    [[noreturn]] static void fail(const WrittenFeature& feature, const std::string& message) {
        throw NotationError("column " + std::to_string(feature.column) + ": " + message);
    }

    /// The feature's lines, in the order of their numbers, and the views that see them.
    static std::map<char, ViewSet> seen_letters(const WrittenFeature& feature) {
        std::map<char, ViewSet> letters; // capitals come before small letters
        for (std::size_t view = 0; view < feature.views.size(); ++view)
            for (const char letter : feature.views[view].letters)
                letters[letter] |= ViewSet{1} << view;
        for (const char letter : feature.unseen.letters)
            if (!letters.emplace(letter, 0).second)
                fail(feature, std::string("a view sees the line ") + letter +
                                  ", which stands in parentheses: leave it out there");
        return letters;
    }

    static ViewSet seen_point(const WrittenFeature& feature) {
        ViewSet seen = 0;
        for (std::size_t view = 0; view < feature.views.size(); ++view)
            if (feature.views[view].point) seen |= ViewSet{1} << view;
        return seen;
    }

    void add_free_line(const WrittenFeature& feature, const std::map<char, ViewSet>& letters) {
        if (letters.empty()) fail(feature, "nothing is in this feature: leave it out");
        const auto [letter, views] = *letters.begin();
        if (is_capital(letter))
            fail(feature, std::string("no point of this feature is on the line ") + letter +
                              ": write a small letter for a line that meets no point");
        problem_.lines.push_back({{}, views});
    }

    void put_on_shared_line(const WrittenFeature& feature, char letter, ViewSet views, int point) {
        const auto [entry, is_new] = shared_.emplace(letter, problem_.lines.size());
        if (is_new) problem_.lines.push_back({{}, views});
        Line& line = problem_.lines[entry->second];
        if (line.seen != views)
            fail(feature, std::string("other views see the line ") + letter +
                              " here than at an earlier point: write " + letter +
                              " in the same views at each of its points");
        line.points.push_back(point);
    }

    Problem problem_;
    std::map<char, std::size_t> shared_;
};

} // namespace

Problem parse_problem(std::string_view text) {
    Cursor cursor(text);
    Problem start;
    cursor.skip_blanks();
    if (cursor.take("projective:")) start.model = CameraModel::projective;
    std::optional<Builder> builder;
    do {
        cursor.skip_blanks();
        const int copies = read_copies(cursor);
        const WrittenFeature feature = read_feature(cursor);
        if (!builder) {
            start.views = static_cast<int>(feature.views.size());
            builder.emplace(start);
        }
        if (static_cast<int>(feature.views.size()) != start.views)
            throw NotationError("column " + std::to_string(feature.column) + ": found " +
                                std::to_string(feature.views.size()) + " views, expected " +
                                std::to_string(start.views) + " as in the first feature");
        for (int i = 0; i < copies; ++i)
            builder->add(feature);
        cursor.skip_blanks();
    } while (cursor.take('+'));
    if (!cursor.at_end()) cursor.fail("'+' or the end");
    Problem problem = builder->take();
    refuse_invalid(problem);
    return *in_order_of_construction(problem);
}

} // namespace plprove
