#include "checker/plcheck.h"

#include "checker/report/report.h"
#include "checker/version.h"

namespace plcheck {
Report check(std::span<const File> files) {
    const checker::Classification classes = checker::classify();
    std::vector<checker::ReplayedFile> replayed;
    for (const File& file : files)
        replayed.push_back(checker::replay(classes, file.name, file.bytes));
    std::string text;
    std::string complaints;
    for (const checker::ReplayedFile& file : replayed) {
        text += checker::finding(file);
        complaints += checker::complaints(file);
    }
    const checker::Report report = checker::summarize(classes, std::move(replayed));
    return {.status = report.status,
            .text = text + checker::summary(report) + checker::conclusion(report),
            .json = checker::json(report),
            .complaints = complaints + checker::objections(report)};
}

std::string_view version() {
    return checker::software_version;
}
} // namespace plcheck
