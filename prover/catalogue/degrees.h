// The degrees on file (certs/degrees.csv), embedded in the program at build time, each with its
// status. What is certified, what is evidence and what is only claimed are never mixed, nor is a
// degree with a lower bound.
#pragma once

#include "prover/problem/signature.h"

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

/// at_least: there are at least so many solutions; exact: there are so many.
enum class DegreeBound { at_least, exact };

std::string_view name(DegreeBound bound);

/// One line of certs/degrees.csv: the degree of a label class, or a lower bound on it, as the
/// source has it.
struct DegreeRecord {
    std::size_t number = 0;
    int degree = 0;
    DegreeBound bound = DegreeBound::exact;
    DegreeStatus status = DegreeStatus::claimed;
    std::string source;
};

/// `at least 300`, or `312`.
std::string in_words(const DegreeRecord& record);

/// The lines of certs/degrees.csv as it was when the program was built.
std::span<const std::string_view> degree_lines();

/// Reads the lines of such a file: comments (#), the line of column names, one record a line.
/// Throws std::runtime_error with the number of the line that is wrong, which includes a number and
/// status given twice.
std::vector<DegreeRecord> parse_degrees(std::span<const std::string_view> lines);

/// The inverse of parse_degrees, but for comments: `remark` is written as comments, in lines.
std::string write_degrees(std::span<const DegreeRecord> records, std::string_view remark);

/// The records by constraint class: its classes share their camera equations and so their
/// camera-degree, which for a minimal problem is its degree.
class DegreeTable {
public:
    /// Assumes that each record's number is one of `classes` (label_classes()).
    DegreeTable(std::vector<DegreeRecord> records, const std::vector<Signature>& classes);

    /// The records for a minimal class of that constraint class, the most telling first. What
    /// others claim comes last; a degree before a lower bound, certified before evidence; among
    /// equals the class's own, then the one with the smallest number.
    std::vector<DegreeRecord> find(std::size_t number, std::size_t constraint_class) const;

    const std::vector<DegreeRecord>& records() const { return records_; }

private:
    struct Key {
        std::size_t constraint_class = 0;
        std::size_t index = 0; ///< of records_
    };

    std::vector<DegreeRecord> records_;
    std::vector<Key> keys_; ///< ascending
};

/// A table that finds the same as DegreeTable(records, classes) for these constraint classes, and
/// is quicker to make for a few.
DegreeTable degrees_of_classes(std::vector<DegreeRecord> records,
                               const std::vector<Signature>& classes,
                               std::span<const std::size_t> constraint_classes);

/// The degree of the minimal problems in two views, all of which reduce to the five-point problem,
/// from that of its extension by a third camera (five_points.h); nothing if the latter is not on
/// file, certified exactly.
std::vector<DegreeRecord> degrees_in_two_views(const std::vector<DegreeRecord>& records);

} // namespace plprove
