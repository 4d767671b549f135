// The numbers of a family (FORMAT.md, section 13), counted from what its records prove.
#pragma once

#include "checker/family/problems_file.h"

#include <string_view>

namespace checker {
struct FamilyRow {
    std::string name;
    std::size_t number = 0;
};

/// The rows of a complete family, in the order of the table; none of another file.
std::vector<FamilyRow> rows_of(const ProblemsFile& file);
} // namespace checker
