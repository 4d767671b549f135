// The minimal problems for projective cameras, and images of them.
#pragma once

#include "checker/file/reader.h"
#include "tests/checker/minimal/image_rank.h"

#include <string>
#include <vector>

/// A line of certs/family-degrees.csv.
struct DegreeOnFile {
    std::string notation{};
    std::size_t degree = 0;
};

/// Those in three views or more.
std::vector<DegreeOnFile> projective_degrees();

/// Random images of `views` views that meet the conditions of FORMAT.md, section 14.
std::vector<checker::Numbers> random_views(const checker::Problem& problem, std::size_t views,
                                           unsigned seed);
