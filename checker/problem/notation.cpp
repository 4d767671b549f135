#include "checker/problem/notation.h"

namespace checker {
/// The symbol of a view.
static std::string spell_view(const Feature& feature, unsigned view) {
    std::string seen;
    if (has_view(feature.point, view)) seen += 'P';
    for (unsigned i = 0; i < feature.pins; ++i)
        if (has_view(feature.pin[i], view)) seen += feature.letter[i];
    return seen.empty() ? "-" : seen;
}

std::string spell(const Feature& feature, unsigned views) {
    std::string text;
    for (unsigned view = 0; view < views; ++view) {
        if (view > 0) text += '/';
        text += spell_view(feature, view);
    }
    std::string unseen;
    if (!feature.free_line && feature.point == 0 && feature.pins < 2) unseen += 'P';
    for (unsigned i = 0; i < feature.pins; ++i)
        if (feature.pin[i] == 0) unseen += feature.letter[i];
    return unseen.empty() ? text : text + "(" + unseen + ")";
}

/// Whether some view sees two lines, but not the point in which they meet.
static bool hides_meeting_point(const Feature& feature, unsigned views) {
    for (unsigned view = 0; view < views; ++view) {
        const auto seen = std::count_if(feature.pin.begin(), feature.pin.end(),
                                        [&](Views pin) { return has_view(pin, view); });
        if (seen > 1 && !has_view(feature.point, view)) return true;
    }
    return false;
}

/// Whether the pins are a, b, ... without gaps.
static bool names_pins_in_order(const Feature& feature) {
    for (unsigned i = 0; i < feature.pins; ++i)
        if (feature.letter[i] != static_cast<char>('a' + i)) return false;
    return true;
}

static unsigned views_of(std::string_view word) {
    return static_cast<unsigned>(std::ranges::count(word, '/')) + 1;
}

Feature read_feature(const Reader& reader, std::string_view word, unsigned views,
                     const Grammar& grammar) {
    const bool right_views = views_of(word) == views && views >= 2 && views <= grammar.most_views;
    const Feature feature = right_views ? observe(word) : Feature{};
    // Observing reads more than the grammar allows; there is one spelling for each feature.
    if (!right_views || spell(feature, views) != word ||
        (!grammar.in_general && !names_pins_in_order(feature)))
        reader.fail(word, say("a feature as section ", grammar.section, " spells it, in 2 to ",
                              grammar.most_views, " views, the same number in all features"));
    if (hides_meeting_point(feature, views))
        reader.fail(word, "a view that sees two lines to see their point (Definition 1)");
    if (feature.free_line && is_capital(feature.letter[0]))
        reader.fail(word, "a point, or a line with one small letter");
    return feature;
}

/// Takes the multiplicity off the word, with its star; 1 if it has none.
static std::size_t cut_multiplicity(const Reader& reader, std::string_view& word) {
    const std::size_t star = word.find('*');
    if (star == word.npos) return 1;
    const std::string_view digits = word.substr(0, star);
    std::size_t count = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (count < 2 || count > 1000 || say(count) != digits)
        reader.fail(word, "a multiplicity from 2 to 1000 before `*`");
    word.remove_prefix(star + 1);
    return count;
}

/// The kind of cameras that the notation begins with.
static const CameraModel* read_cameras(Reader& reader, std::string& notation) {
    for (const CameraModel* model : camera_models())
        if (!model->prefix.empty() && reader.comes(model->prefix)) {
            notation = say(reader.word(), ' ');
            return model;
        }
    return &calibrated_cameras;
}

/// The lines that capital letters name.
using Shared = std::map<char, std::size_t>;

/// Whether each capital letter of the feature stands in the same views as before.
static bool keeps_views(const Problem& problem, const Shared& shared, const Feature& feature) {
    for (unsigned i = 0; i < feature.pins; ++i) {
        const auto place = shared.find(feature.letter[i]);
        if (place != shared.end() && problem.lines[place->second].seen_by != feature.pin[i])
            return false;
    }
    return true;
}

/// Adds the copies of a feature.
static void add_copies(const Reader& reader, Written& written, Shared& shared,
                       const Feature& feature, std::size_t count, const Grammar& grammar) {
    if (!keeps_views(written.problem, shared, feature))
        reader.fail(feature.notation, "a capital letter in the same views as before");
    for (; count > 0; --count) {
        written.features.push_back(feature);
        add_feature(written.problem, feature, shared);
        if (written.features.size() > grammar.most_features)
            reader.fail(feature.notation, say("at most ", grammar.most_features, " features"));
        if (written.problem.points.size() > grammar.most_points ||
            written.problem.lines.size() > grammar.most_lines)
            reader.fail(feature.notation, say("at most ", grammar.most_points, " points and ",
                                              grammar.most_lines, " lines"));
    }
}

Written read_notation(Reader& reader, const Grammar& grammar) {
    Written written;
    auto& [notation, list, problem] = written;
    if (grammar.in_general) problem.cameras = read_cameras(reader, notation);
    Shared shared;
    do {
        if (!list.empty()) {
            reader.take("+");
            notation += " + ";
        }
        const std::string_view term = reader.word();
        notation += term;
        std::string_view word = term;
        const std::size_t count = cut_multiplicity(reader, word);
        if (!grammar.equal_neighbours && !list.empty() && word == list.back().notation)
            reader.fail(word, "equal neighbours with a multiplicity");
        const unsigned views =
            list.empty() ? views_of(word) : static_cast<unsigned>(problem.view_count());
        const Feature feature = read_feature(reader, word, views, grammar);
        problem.views = (1U << views) - 1;
        add_copies(reader, written, shared, feature, count, grammar);
    } while (!reader.at_end());
    for (const auto& [letter, line] : shared)
        if (problem.lines[line].points.size() < 2)
            reader.fail({&letter, 1}, "a capital letter in two features or more");
    const std::string expected = violation(problem);
    if (!expected.empty()) reader.fail(notation, expected);
    reader.end_line();
    return written;
}

Problem parse_problem(std::string_view text, Grammar grammar) {
    std::string line;
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '\n') continue;
        if (c == '+')
            line += " + ";
        else
            line += c;
        if (c == ':') line += ' ';
    }
    line += '\n';
    Reader reader(line);
    grammar.equal_neighbours = true;
    return read_notation(reader, grammar).problem;
}
} // namespace checker
