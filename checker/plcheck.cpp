#include "checker/plcheck.h"

#include "checker/command/expected.h"
#include "checker/report/report.h"
#include "checker/version.h"

#include <stdexcept>

namespace plcheck {
/// An empty word stands for none.
static std::optional<std::string_view> given(std::string_view word) {
    if (word.empty()) return std::nullopt;
    return word;
}

static checker::Expectation parse(const Expectation& expectation) {
    try {
        return checker::expectation_of({.problem = given(expectation.expect),
                                        .verdict = given(expectation.verdict),
                                        .degree = given(expectation.degree),
                                        .family = given(expectation.family),
                                        .classification = expectation.classification});
    } catch (const checker::WrongUsage& usage) {
        throw std::invalid_argument(usage.reason);
    }
}

Report check(std::span<const File> files, const Expectation& expectation) {
    const checker::Expectation expected = parse(expectation);
    const checker::Classification classes = checker::classify();
    std::vector<checker::ReplayedFile> replayed;
    Report report;
    for (const File& file : files) {
        replayed.push_back(checker::replay(classes, file.name, file.bytes));
        report.text += checker::finding(replayed.back());
        report.complaints += checker::complaints(replayed.back());
    }
    const checker::Report all = checker::summarize(classes, std::move(replayed), expected);
    report.status = all.status;
    report.conclusion = checker::conclusion(all);
    report.text += checker::summary(all) + report.conclusion;
    report.json = checker::json(all);
    report.complaints += checker::objections(all);
    return report;
}

std::string_view version() {
    return checker::software_version;
}
} // namespace plcheck
