// A report as plcheck prints it with all details.
#pragma once

#include "checker/report/report.h"

inline std::string detailed(const checker::Report& report) {
    return text(report) + table(report) + why(report);
}
