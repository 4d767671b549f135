#include "checker/conclusion/expectation.h"

namespace checker {
/// The notation without blanks.
static std::string without_blanks(std::string_view notation) {
    std::string text;
    for (const char c : notation)
        if (c != ' ' && c != '\t' && c != '\n') text += c;
    return text;
}

CanonicalProblem parse_problem(std::string_view notation) {
    const std::string text = without_blanks(notation);
    unsigned views = 0;
    Features list;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('+', start), text.size());
        const std::string line = text.substr(start, end - start) + '\n';
        start = end + 1;
        if (line == "\n") throw Malformed{{0, "expected a feature before and after each `+`"}};
        Reader reader(line);
        const Written summand = read_notation(reader, section_1);
        const auto its_views = static_cast<unsigned>(summand.problem.view_count());
        if (views == 0) views = its_views;
        if (its_views != views)
            throw Malformed{{0, "expected all features in the same number of views"}};
        list.insert(list.end(), summand.features.begin(), summand.features.end());
        if (list.size() > 1000) throw Malformed{{0, "expected at most 1000 features"}};
    }
    return canonical(views, list);
}

static std::string in_words(const ExpectedDegree& degree) {
    return say("has ", degree.exactly ? "exactly " : "at least ", degree.solutions,
               " camera solutions");
}

std::string in_words(const ExpectedProblem& expected) {
    std::string text = expected.notation;
    if (!expected.verdict.empty()) text += " is " + expected.verdict;
    if (!expected.verdict.empty() && expected.degree) text += ", and";
    if (expected.degree) text += ' ' + in_words(*expected.degree);
    return text;
}

std::string in_words(const Expectation& expectation) {
    if (const auto* problem = std::get_if<ExpectedProblem>(&expectation)) return in_words(*problem);
    if (const auto* family = std::get_if<WholeFamily>(&expectation))
        return "the family " + family->name;
    const bool whole = std::holds_alternative<WholeClassification>(expectation);
    return whole ? "the whole table" : "";
}
} // namespace checker
