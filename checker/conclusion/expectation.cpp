#include "checker/conclusion/expectation.h"

namespace checker {
static std::string in_words(const ExpectedDegree& degree, std::string_view solutions) {
    return say("has ", degree.exactly ? "exactly " : "at least ", degree.solutions, ' ', solutions);
}

std::string group_in_words(const std::string& group) {
    if (group.starts_with(">=")) return " has a group that contains " + group.substr(2);
    if (group.starts_with('<')) return " has a group of index 2 in " + group.substr(1);
    return " has the group " + group;
}

static std::string in_words(const ExpectedModel& expected) {
    std::string text = expected.file;
    if (expected.degree) text += ' ' + in_words(*expected.degree, "solutions");
    if (!expected.group.empty())
        text += (expected.degree ? ", and" : "") + group_in_words(expected.group);
    return expected.degree || !expected.group.empty() ? text : text + " is minimal";
}

std::string in_words(const ExpectedProblem& expected) {
    std::string text = expected.notation;
    if (!expected.verdict.empty()) text += " is " + expected.verdict;
    if (!expected.verdict.empty() && expected.degree) text += ", and";
    if (expected.degree) text += ' ' + in_words(*expected.degree, "camera solutions");
    if (expected.group.empty()) return text;
    if (!expected.verdict.empty() || expected.degree) text += ", and";
    return text + group_in_words(expected.group);
}

std::string in_words(const Expectation& expectation) {
    if (const auto* problem = std::get_if<ExpectedProblem>(&expectation)) return in_words(*problem);
    if (const auto* model = std::get_if<ExpectedModel>(&expectation)) return in_words(*model);
    if (const auto* family = std::get_if<WholeFamily>(&expectation))
        return "the family " + family->name;
    if (const auto* list = std::get_if<WholeList>(&expectation)) return "the list " + list->file;
    const bool whole = std::holds_alternative<WholeClassification>(expectation);
    return whole ? "the whole table" : "";
}
} // namespace checker
