#include "checker/general/notation.h"

#include <map>

namespace checker::general {
/// What a feature says: the views that see its point and, by its letter, each of its lines.
struct Spelled {
    bool has_point = false;
    Views point = 0;
    std::map<char, Views> lines{}; // as they ascend: capital letters first
};

static bool is_capital(char c) {
    return c >= 'A' && c <= 'Z';
}

static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (is_capital(c) && c != 'P');
}

/// Takes what stands before the separator off the text, and the separator.
static std::string_view cut(std::string_view& text, char separator) {
    const std::string_view head = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(head.size() + 1, text.size()));
    return head;
}

/// Adds what the views see of the feature, or with no view what none sees. False if it is misspelt.
static bool add_symbol(Spelled& feature, std::string_view symbol, Views view) {
    const bool has_point = symbol.starts_with('P');
    const std::string_view letters = symbol.substr(has_point ? 1 : 0);
    if (symbol.empty() || !std::ranges::all_of(letters, is_letter)) return false;
    for (std::size_t i = 1; i < letters.size(); ++i)
        if (letters[i - 1] >= letters[i]) return false;
    if (view != 0 && !has_point && letters.size() > 1) return false;
    for (const char letter : letters) {
        if (view == 0 && feature.lines.contains(letter)) return false;
        feature.lines[letter] |= view;
    }
    if (has_point) feature.point |= view;
    feature.has_point |= has_point || feature.lines.size() > 1;
    const bool unseen_point = view == 0 && has_point;
    return !unseen_point || (feature.point == 0 && feature.lines.size() <= 1);
}

/// Reads SYMBOL/SYMBOL/... (UNSEEN). The first feature decides how many views there are.
static Spelled read_feature(const Reader& reader, const std::string_view word, Views& views) {
    const auto expect = [&](bool holds, const char* what) {
        if (!holds) reader.fail(word, what);
    };
    Spelled feature;
    std::string_view unseen = word;
    std::string_view seen = cut(unseen, '(');
    const auto count = static_cast<unsigned>(std::ranges::count(seen, '/')) + 1;
    expect(count >= 2 && count <= most_views, "a feature in 2 to 12 views");
    if (views == 0) views = (1U << count) - 1;
    expect(views == (1U << count) - 1, "all features in the same number of views");
    for (unsigned view = 0; view < count; ++view) {
        const std::string_view symbol = cut(seen, '/');
        if (symbol == "-") continue;
        expect(add_symbol(feature, symbol, 1U << view), "`P` or letters as section 13 spells them");
    }
    if (word.find('(') != word.npos) {
        const bool closed = unseen.ends_with(')');
        expect(closed && add_symbol(feature, unseen.substr(0, unseen.size() - 1), 0),
               "in parentheses what no view sees, as section 13 spells it");
    }
    const bool is_line = feature.lines.size() == 1 && !is_capital(feature.lines.begin()->first);
    expect(feature.has_point || is_line, "a point, or a line with one small letter");
    return feature;
}

/// Takes the multiplicity off the word, with its star; 1 if it has none.
static std::size_t cut_count(const Reader& reader, std::string_view& word) {
    if (word.find('*') == word.npos) return 1;
    const std::string_view digits = cut(word, '*');
    std::size_t count = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (count < 2 || count > 1000 || say(count) != digits)
        reader.fail(digits, "a multiplicity from 2 to 1000 before `*`");
    return count;
}

/// The lines that capital letters name.
using Shared = std::map<char, std::size_t>;

/// Adds a point or a free line to the problem.
static void add_feature(Problem& problem, Shared& shared, const Spelled& feature) {
    const std::size_t point = problem.points.size();
    if (feature.has_point) problem.points.push_back({.seen_by = feature.point});
    for (const auto& [letter, views] : feature.lines) {
        std::size_t line = problem.lines.size();
        if (is_capital(letter)) line = shared.try_emplace(letter, line).first->second;
        if (line == problem.lines.size()) problem.lines.push_back({.seen_by = views});
        if (!feature.has_point) continue;
        problem.lines[line].points.push_back(point);
        problem.points[point].lines.push_back(line);
    }
}

/// Whether each capital letter of the feature stands in the same views as before.
static bool keeps_views(const Problem& problem, const Shared& shared, const Spelled& feature) {
    for (const auto& [letter, line] : shared) {
        const auto place = feature.lines.find(letter);
        if (place != feature.lines.end() && place->second != problem.lines[line].seen_by)
            return false;
    }
    return true;
}

Written read_notation(Reader& reader) {
    Written written;
    auto& [notation, problem] = written;
    problem.projective = reader.comes("projective:");
    if (problem.projective) notation = say(reader.word(), ' ');
    Shared shared;
    std::string_view before; // the feature before
    do {
        if (!before.empty()) {
            reader.take("+");
            notation += " + ";
        }
        const std::string_view term = reader.word();
        notation += term;
        std::string_view word = term;
        const std::size_t count = cut_count(reader, word);
        if (word == before) reader.fail(word, "equal neighbours with a multiplicity");
        before = word;
        const Spelled feature = read_feature(reader, word, problem.views);
        if (!keeps_views(problem, shared, feature))
            reader.fail(word, "a capital letter in the same views as before");
        for (std::size_t copy = 0; copy < count; ++copy) {
            add_feature(problem, shared, feature);
            if (problem.points.size() > 100 || problem.lines.size() > 100)
                reader.fail(term, "at most 100 points and 100 lines");
        }
    } while (!reader.at_end());
    for (const auto& [letter, line] : shared)
        if (problem.lines[line].points.size() < 2)
            reader.fail({&letter, 1}, "a capital letter in two features or more");
    const std::string expected = violation(problem);
    if (!expected.empty()) reader.fail(notation, expected);
    reader.end_line();
    return written;
}
} // namespace checker::general
