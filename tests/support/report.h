// A report as plcheck prints it with all details, and what it writes to standard error.
#pragma once

#include "checker/report/report.h"

namespace checker {
inline std::string text(const Report& report) {
    std::string lines;
    for (const ReplayedFile& file : report.findings.files)
        lines += finding(file);
    return lines + summary(report) + table(report) + why(report) + conclusion(report);
}

inline std::string complaints(const Report& report) {
    std::string lines;
    for (const ReplayedFile& file : report.findings.files)
        lines += complaints(file);
    return lines + objections(report);
}
} // namespace checker
