// The degrees on file (certs/degrees.csv), embedded in the program at build time, each with its
// status. What is certified, what is evidence and what is only claimed are never mixed.
#pragma once

#include "prover/problem/signature.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plprove {

/// Ascending in strength. certified: follows from certificates that plcheck replays; evidence:
/// computed by this project, completeness not proved; claimed: stated by others.
enum class DegreeStatus { claimed, evidence, certified };

std::string_view name(DegreeStatus status);

/// One line of certs/degrees.csv: the degree of a label class, as the source has it.
struct DegreeRecord {
    std::size_t number = 0;
    int degree = 0;
    DegreeStatus status = DegreeStatus::claimed;
    std::string source;
};

/// The lines of certs/degrees.csv as it was when the program was built.
std::span<const std::string_view> degree_lines();

/// Reads the lines of such a file: comments (#), the line of column names, one record a line.
/// Throws std::runtime_error with the number of the line that is wrong, which includes a number and
/// status given twice.
std::vector<DegreeRecord> parse_degrees(std::span<const std::string_view> lines);

/// The records by constraint class: its classes share their camera equations and so their
/// camera-degree, which for a minimal problem is its degree.
class DegreeTable {
public:
    /// Assumes that each record's number is one of `classes` (label_classes()).
    DegreeTable(std::vector<DegreeRecord> records, const std::vector<Signature>& classes);

    /// The strongest record for a minimal class of that constraint class: among equals the class's
    /// own, then the one with the smallest number.
    std::optional<DegreeRecord> find(std::size_t number, std::size_t constraint_class) const;

    const std::vector<DegreeRecord>& records() const { return records_; }

private:
    std::vector<DegreeRecord> records_;
    std::multimap<std::size_t, std::size_t> by_constraint_class_; ///< to indices of records_
};

} // namespace plprove
