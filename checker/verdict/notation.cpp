#include "checker/verdict/notation.h"

namespace checker {
/// The symbol of a view.
static std::string spell_view(const Feature& feature, unsigned view) {
    std::string seen;
    if (has_view(feature.point, view)) seen += 'P';
    for (unsigned i = 0; i < feature.pins; ++i)
        if (has_view(feature.pin[i], view)) seen += static_cast<char>('a' + i);
    return seen.empty() ? "-" : seen;
}

std::string spell(const Feature& feature, unsigned views) {
    std::string text;
    for (unsigned view = 0; view < views; ++view) {
        if (view > 0) text += '/';
        text += spell_view(feature, view);
    }
    std::string unseen;
    const bool has_point = !feature.free_line;
    if (has_point && feature.point == 0 && feature.pins < 2) unseen += 'P';
    for (unsigned i = 0; i < feature.pins; ++i)
        if (feature.pin[i] == 0) unseen += static_cast<char>('a' + i);
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

static unsigned slashes_in(std::string_view word) {
    return static_cast<unsigned>(std::count(word.begin(), word.end(), '/'));
}

Feature read_feature(const Reader& reader, std::string_view word, unsigned views) {
    const bool right_views = slashes_in(word) + 1 == views;
    const Feature feature = right_views ? observe(word) : Feature{};
    // Observing reads more than section 1 allows; there is one spelling for each feature.
    if (!right_views || spell(feature, views) != word)
        reader.fail(word, say("a feature as section 1 spells it, in ", views, " views"));
    if (hides_meeting_point(feature, views))
        reader.fail(word, "a view that sees two lines to see their point (Definition 1)");
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

Problem read_problem(Reader& reader) {
    Problem problem;
    std::string_view before; // the feature before
    do {
        if (!problem.features.empty()) {
            reader.take("+");
            problem.notation += " + ";
        }
        const std::string_view summand = reader.word();
        problem.notation += summand;
        std::string_view word = summand;
        const std::size_t count = cut_multiplicity(reader, word);
        if (problem.views == 0) problem.views = slashes_in(word) == 1 ? 2 : 3;
        const Feature feature = read_feature(reader, word, problem.views);
        if (word == before) reader.fail(word, "equal neighbours with a multiplicity");
        before = word;
        problem.features.insert(problem.features.end(), count, feature);
        if (problem.features.size() > 1000) reader.fail(word, "at most 1000 features");
    } while (!reader.at_end());
    reader.end_line();
    return problem;
}
} // namespace checker
