#include "tests/checker/bounds/templates.h"

#include <fstream>
#include <regex>

using namespace checker;

namespace templates {
const std::string two_points_and_a_line = R"(template line degree 1 3
star point 0 0 0 image 66 4 -66
star point 33 -62 79 image -88 -4 -92
line point 78 -86 -9 direction 1 0 0 image 0 0 1
basis 1 2 5 6
rows 1 1 2 5 8 9 12 15 16 19
rows 2 1 2 3 5
rows 3 1 2 3 5
minor 594677692319771619
)";

const std::string on_the_axis = R"(template points degree 4 2
star point 0 0 0 image 66 4 0
star point 33 0 0 image -88 -4 0 pin 78 -86 -9 toward 15 16 -47
transversals point -74 -58 32 direction -36 70 38 image -29 11 -94
basis 1 2 4 6 9 11 26 27 29 31 34 36
rows 1 1 2 4 6 7 9 11 12 14 16 17 19 26 27 29 31 32 34 36 37 39
rows 2 1 2 4 6 7 9 11 12 14 26 27 32
minor 1764528126404496281
)";

const std::string& committed_bytes() {
    static const std::string bytes = [] {
        std::ifstream in(CERTS_DIR "/bounds.plc", std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    }();
    return bytes;
}

const BoundsFile& committed() {
    static const FileContent content =
        replay(all_classes(), "bounds.plc", committed_bytes()).content;
    return std::get<BoundsFile>(content);
}

std::string template_of_the_relative_pose() {
    const std::regex group("^template[^\\n]*\\ntransversals point \\S+ \\S+ \\S+"
                           "( direction \\S+ \\S+ \\S+ image \\S+ \\S+ \\S+){5}\\nbasis");
    // Without the places where lines go on.
    const std::string all = std::regex_replace(committed_bytes(), std::regex(" \\\\\n"), " ");
    std::string found;
    for (std::size_t at = all.find("template"), end = 0; at < all.size(); at = end) {
        end = std::min(all.find("template", at + 1), all.size());
        const std::string one = all.substr(at, end - at);
        if (std::regex_search(one, group)) found = one;
    }
    REQUIRE(!found.empty());
    return found;
}

FileContent replayed(const std::string& templates) {
    return replay(Classification{}, "file",
                  "plcert 2 bounds\nmodulus 2305843009213693951\n" + templates)
        .content;
}

std::string outcome(const std::string& templates) {
    const FileContent content = replayed(templates);
    if (const auto* malformed = std::get_if<Malformed>(&content))
        return "syntax: " + malformed->complaint.reason;
    const Refusals& refusals = std::get<BoundsFile>(content).refusals;
    return refusals.count == 0 ? "holds" : refusals.first[0].reason;
}

DegreeTable table_of(const RegistrationBounds& upper, const std::vector<LowerBound>& lower) {
    static const std::vector<bool> minimal = [] {
        std::vector<bool> found;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
            found.push_back(is_minimal_class(n));
        return found;
    }();
    return bounds_by_files(all_classes(), minimal, lower, upper);
}

std::size_t bound_of(const DegreeTable& table, std::size_t number) {
    const auto found = table.find(constraint_class(all_classes().representatives[number]));
    if (found == table.end() || !found->second.at_most) return 0;
    return found->second.at_most->solutions;
}

std::size_t bound_of(const DegreeTable& table, std::string_view problem) {
    return bound_of(table, class_of(problem));
}
} // namespace templates
