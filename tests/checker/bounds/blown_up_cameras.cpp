// Theorem Z (proofs/blown_up_cameras.md): the checker's rows against the degrees that monodromy
// found.
#include "checker/bounds/theorems.h"
#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/checker/bounds/templates.h"

#include <set>

using namespace checker;
using namespace templates;

TEST_CASE("each row of Theorem Z has the degree on file, is certified, and a multiple of 8") {
    const auto on_file = degrees_on_file();
    const auto certified = certified_on_file();
    std::set<Signature> classes;
    for (const auto& [number, bound] : blown_up_camera_rows()) {
        CAPTURE(number);
        const Signature constraints = constraint_class(all_classes().representatives.at(number));
        CHECK(on_file.at(constraints) == bound);
        CHECK(certified.contains(constraints));
        CHECK(bound % 8 == 0);
        CHECK(classes.insert(constraints).second);
    }
    CHECK(classes.size() == 4211);
}

TEST_CASE("where a row of Theorem Z and one of another theorem speak, the smaller bound counts") {
    const DegreeTable table = table_of({});
    std::map<std::string_view, std::size_t> larger;
    std::map<Signature, std::size_t> rows;
    for (const auto& [number, bound] : blown_up_camera_rows())
        rows.emplace(constraint_class(all_classes().representatives.at(number)), bound);
    for (const auto& [theorem, problem, bound] : all_theorem_bounds()) {
        const auto row =
            rows.find(constraint_class(all_classes().representatives[class_of(problem)]));
        if (row == rows.end()) continue;
        CAPTURE(problem);
        CHECK(row->second < bound);
        CHECK(table.at(row->first).at_most->solutions == row->second);
        ++larger[theorem];
    }
    CHECK(larger == std::map<std::string_view, std::size_t>{{"R", 4}, {"S", 28}});
}
