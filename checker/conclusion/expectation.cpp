#include "checker/conclusion/expectation.h"

namespace checker {
static std::string in_words(const ExpectedDegree& degree, std::string_view solutions) {
    return say("has ", degree.exactly ? "exactly " : "at least ", degree.solutions, ' ', solutions);
}

std::string in_words(const ExpectedProblem& expected) {
    std::string text = expected.notation;
    if (!expected.verdict.empty()) text += " is " + expected.verdict;
    if (!expected.verdict.empty() && expected.degree) text += ", and";
    if (expected.degree) text += ' ' + in_words(*expected.degree, "camera solutions");
    if (expected.group.empty()) return text;
    if (!expected.verdict.empty() || expected.degree) text += ", and";
    const bool is_bound = expected.group.starts_with(">=");
    text += is_bound ? " has a group that contains " + expected.group.substr(2)
                     : " has the group " + expected.group;
    return text;
}

std::string in_words(const Expectation& expectation) {
    if (const auto* problem = std::get_if<ExpectedProblem>(&expectation)) return in_words(*problem);
    if (const auto* model = std::get_if<ExpectedModel>(&expectation))
        return model->degree ? say(model->file, ' ', in_words(*model->degree, "solutions"))
                             : say(model->file, " is minimal");
    if (const auto* family = std::get_if<WholeFamily>(&expectation))
        return "the family " + family->name;
    if (const auto* list = std::get_if<WholeList>(&expectation)) return "the list " + list->file;
    const bool whole = std::holds_alternative<WholeClassification>(expectation);
    return whole ? "the whole table" : "";
}
} // namespace checker
