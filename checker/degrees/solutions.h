// The solutions of a record: taken from the file, proved, and told apart (FORMAT.md, section 9).
#pragma once

#include "checker/degrees/krawczyk.h"
#include "checker/effort/execution.h"
#include "checker/file/reader.h"

#include <optional>

namespace checker {
/// How a record continues: the number of coordinates in each of its solutions, and the first word
/// of the next record.
struct SolutionLines {
    std::size_t coordinates = 0;
    std::string_view next_record{};
};

/// Takes the solutions of the records of a file, and proves them as they come, some at a time.
/// After one that is refused, the others of its record are only read.
class SolutionsReplay {
public:
    SolutionsReplay(Reader& reader, Records& records, std::size_t threads)
        : reader_(reader), threads_(threads), records_(records) {}

    /// How many solutions the record proves; none if it is refused. `line` is where it begins,
    /// `about` is what it is about, and `prepare` says how its solutions are proved, or throws
    /// Refused. Throws TooMuchEffort.
    std::optional<std::size_t> run(const SolutionLines& lines, std::size_t line,
                                   const std::string& about,
                                   const std::function<Certify()>& prepare);

private:
    bool has_more(const SolutionLines& lines) const;
    ApproximateSolution read_solution(const SolutionLines& lines);
    std::vector<ApproximateSolution> read_some(const SolutionLines& lines, std::size_t proved);
    void skip(const SolutionLines& lines, bool none_is_read);

    Reader& reader_;
    std::size_t threads_;
    Records& records_;
};
} // namespace checker
