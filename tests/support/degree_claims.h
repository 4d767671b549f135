// Lines on degrees in a report.
#pragma once

#include "tests/support/results.h"

/// The first line on degrees that begins so. Fails if there is none.
inline checker::paper::DegreeClaim claim_on(const checker::Report& report,
                                            const std::string& start) {
    for (const checker::paper::DegreeClaim& claim : report.degrees)
        if (claim.claim.starts_with(start)) return claim;
    FAIL(start);
    return {};
}
