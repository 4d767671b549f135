#include "checker/plcheck.h"

#include "checker/command/options.h"
#include "checker/report/report.h"
#include "checker/version.h"

#include <stdexcept>

namespace plcheck {
/// The command line that expects the same.
static std::vector<std::string> arguments_for(const Expectation& expectation) {
    std::vector<std::string> arguments;
    const auto add = [&](const char* option, const std::string& value) {
        if (value.empty()) return;
        arguments.push_back(option);
        arguments.push_back(value);
    };
    add("--expect", expectation.expect);
    add("--verdict", expectation.verdict);
    add("--degree", expectation.degree);
    if (expectation.classification) arguments.push_back("--classification");
    arguments.push_back("--");
    arguments.push_back("a file"); // a command line has one
    return arguments;
}

static checker::Expectation parse(const Expectation& expectation) {
    std::vector<std::string> arguments = arguments_for(expectation);
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    try {
        return checker::parse_options(pointers).expectation;
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
