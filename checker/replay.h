// A certificate file goes in as bytes, what it proves comes out: one type for each kind of file.
#pragma once

#include "checker/degrees/degree_file.h"
#include "checker/family/problems_file.h"
#include "checker/general_bounds/at_most_file.h"
#include "checker/general_degrees/solutions_file.h"
#include "checker/minimal/classification_file.h"
#include "checker/minimal/problem_file.h"
#include "checker/model/model_file.h"

#include <variant>

namespace checker {
/// A file that cannot be read, and why.
struct Unreadable {
    std::string reason{};
};

/// What a file proves. Malformed: it does not conform to FORMAT.md, and proves nothing.
using FileContent = std::variant<Malformed, ClassificationFile, ProblemFile, DegreeFile,
                                 ProblemsFile, SolutionsFile, AtMostFile, ModelFile, Unreadable>;

struct ReplayedFile {
    std::string name{};   // printable
    std::string sha256{}; // the digest of its bytes: which ones a report is about
    FileContent content{};
};

/// Replays the bytes of a file.
ReplayedFile replay(const Classification& classes, std::string_view name, std::string_view bytes,
                    const Execution& execution = {});
} // namespace checker
