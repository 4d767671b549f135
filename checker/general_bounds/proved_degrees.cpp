#include "checker/general_bounds/proved_degrees.h"

#include "checker/family/by_problem.h"
#include "checker/problem/notation.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace checker {
/// A row of a theorem's table: a problem as one view sees it.
struct ProvedRow {
    unsigned views = 0;
    std::string_view view{};
    std::size_t at_most = 0;
    std::string_view theorem{};
};

static constexpr ProvedRow proved_rows[] = {
    // proofs/calibrated_collinear_points.md
    {2, "5*P", 20, "A"},
    {2, "3*PL + 2*P", 16, "A"},
    {2, "PLM + 2*PL + 2*PM", 12, "A"},
    {3, "2*PL + PLabc", 144, "A"},
    {3, "PL + PLa + PLab", 144, "A"},
    {3, "3*PLa", 144, "A"},
    {3, "2*PL + PLa + a", 40, "A"},
    {3, "3*PL + P", 64, "A"},
    {4, "2*PL + PLab", 544, "A"},
    {4, "PL + 2*PLa", 544, "A"},
    {4, "3*PL + a", 32, "A"},
    // proofs/calibrated_three_points.md
    {4, "2*P + Pa", 1728, "B"},
    // proofs/calibrated_six_views.md
    {6, "Pa + 2*a", 186368, "E"},
    // proofs/upright_focal_views.md
    {3, "3*PL + a", 7, "J"},
    {3, "2*PL + PLab", 34, "J"},
    {3, "PL + 2*PLa", 34, "J"},
    {4, "2*PL + PLa", 93, "J"},
    {3, "5*a", 62, "J"},
    {3, "Pabc + 2*a", 62, "J"},
    {3, "2*Pab", 62, "J"},
    {3, "P + Pabcd", 22, "J"},
    {3, "Pa + Pabc", 52, "J"},
    // proofs/upright_focal_depths.md
    {3, "Pa + 3*a", 60, "X"},
    {3, "P + Pab + a", 52, "X"},
    {3, "2*Pa + a", 59, "X"},
    {3, "2*P + Pa", 51, "X"},
    {3, "2*P + 2*a", 42, "X"},
    {4, "3*P", 235, "X"},
    // proofs/one_focal_length.md
    {3, "P + Pabcdef", 48, "O"},
    {5, "3*PL + a", 256, "O"},
    {3, "3*PL + 2*a", 80, "O"},
    {3, "2*PL + PLab + a", 260, "O"},
    {3, "PL + 2*PLa + a", 260, "O"},
    // proofs/focal_stars.md
    {3, "Pabcdefg + 2*a", 108, "R"},
    {3, "Pab + Pabcdef", 108, "R"},
    {3, "P + Pabcdef + a", 48, "R"},
    {3, "2*P + Pabcde", 60, "R"},
    {3, "2*PL + PLabcdef", 60, "R"},
    {3, "3*PL + Pabc", 30, "R"},
    // proofs/focal_planes.md
    {4, "PLM + 2*PL + 2*PM", 168, "Y"},
    {3, "PLMa + 2*PL + 2*PM", 66, "Y"},
    {3, "PLM + 2*PL + PM + PMa", 66, "Y"},
    // proofs/focal_collinear_points.md
    {3, "3*PL + 3*a", 42, "Z"},
    {3, "2*PL + PLab + 2*a", 140, "Z"},
    {3, "PL + 2*PLa + 2*a", 140, "Z"},
    {3, "3*PL + Pa + a", 98, "Z"},
    {3, "2*PL + PLa + Pab", 128, "Z"},
    // proofs/three_collinear_points.md
    {3, "PL + PLabcd + PLabcdef", 4, "L"},
    {3, "PL + 2*PLabcde", 4, "L"},
    {3, "PLa + PLabc + PLabcdef", 4, "L"},
    {3, "2*PLab + PLabcdef", 4, "L"},
    {3, "PLa + PLabcd + PLabcde", 10, "L"},
    {3, "PLab + PLabc + PLabcde", 10, "L"},
    {3, "PLab + 2*PLabcd", 10, "L"},
    {3, "2*PLabc + PLabcd", 10, "L"},
    {3, "PL + PLab + PLabcdef + a", 2, "L"},
    {3, "2*PLa + PLabcdef + a", 2, "L"},
    {3, "2*PL + PLabcdef + 2*a", 2, "L"},
    {3, "2*PL + PLabcde + Pab", 2, "L"},
    {3, "PL + PLa + PLabcde + Pa", 2, "L"},
    {3, "PL + PLab + PLabcde + P", 2, "L"},
    {3, "2*PLa + PLabcde + P", 2, "L"},
    {3, "2*PL + PLabcd + 2*P", 2, "L"},
    {3, "PL + PLabc + PLabcde + a", 7, "L"},
    {3, "PLa + PLab + PLabcde + a", 7, "L"},
    {3, "PL + 2*PLabcd + a", 10, "L"},
    {3, "PLa + PLabc + PLabcd + a", 10, "L"},
    {3, "2*PLab + PLabcd + a", 10, "L"},
    {3, "PLab + 2*PLabc + a", 11, "L"},
    // proofs/five_pins.md
    {3, "Pabcdefg + 4*a", 6, "N"},
    {3, "Pabcde + 5*a", 23, "N"},
    {3, "Pabcd + Pabcdef + a", 6, "N"},
    {3, "Pab + Pabcdef + 2*a", 4, "N"},
    {3, "P + Pabcdef + 3*a", 2, "N"},
    {3, "2*Pabcde + a", 16, "N"},
    {3, "Pabc + Pabcde + 2*a", 12, "N"},
    {3, "Pa + Pabcde + 3*a", 9, "N"},
    {3, "P + Pabcd + Pabcde", 4, "N"},
    {3, "Pa + Pabc + Pabcde", 4, "N"},
    {3, "2*Pab + Pabcde", 4, "N"},
    {3, "P + Pab + Pabcde + a", 2, "N"},
    {3, "2*Pa + Pabcde + a", 2, "N"},
    {3, "2*P + Pabcde + 2*a", 2, "N"},
    {3, "2*Pabcdef", 4, "N"},
    // proofs/collinear_points_more_views.md
    {4, "PL + PLabc + PLabcde", 2, "M"},
    {4, "PLa + PLab + PLabcde", 2, "M"},
    {4, "PLa + PLabc + PLabcd", 9, "M"},
    {4, "PLab + 2*PLabc", 10, "M"},
    {4, "PL + PLab + PLabcd + a", 5, "M"},
    {4, "2*PLa + PLabcd + a", 5, "M"},
    {4, "PL + 2*PLabc + a", 10, "M"},
    {5, "PL + PLa + PLabc + Pa", 4, "M"},
    {6, "PL + PLabc + PLabcd", 5, "M"},
    {6, "PLa + PLab + PLabcd", 5, "M"},
    {6, "PLa + 2*PLabc", 10, "M"},
    {6, "2*PLab + PLabc", 10, "M"},
    {6, "PL + PLab + PLabc + a", 7, "M"},
    {6, "2*PLa + PLabc + a", 7, "M"},
    // proofs/four_and_five_views.md
    {4, "P + 6*a", 12, "V"},
    {4, "Pab + 5*a", 30, "V"},
    {4, "2*P + Pabc + 2*a", 4, "V"},
    {4, "Pabcd + 4*a", 25, "V"},
    {4, "Pabcdef + 3*a", 2, "V"},
    {5, "Pa + 5*a", 20, "V"},
    {5, "Pabc + 4*a", 35, "V"},
    {5, "Pabcde + 3*a", 6, "V"},
};

/// The cameras that a theorem is about, as notation has them.
static std::string_view cameras_of(std::string_view theorem) {
    if (theorem == "A" || theorem == "B" || theorem == "E") return "";
    if (theorem == "J" || theorem == "X") return "upright-focal: ";
    if (theorem == "O") return "shared-focal: ";
    if (theorem == "R" || theorem == "Y" || theorem == "Z") return "focal: ";
    return "projective: ";
}

/// The row's problem: each view sees each feature in the same way.
static Problem problem_of(const ProvedRow& row) {
    std::string notation(cameras_of(row.theorem));
    std::string_view rest = row.view;
    while (!rest.empty()) {
        const std::string_view feature = rest.substr(0, rest.find(" + "));
        rest.remove_prefix(std::min(rest.size(), feature.size() + 3));
        const std::string_view one = feature.substr(feature.find('*') + 1);
        notation += feature;
        for (unsigned view = 1; view < row.views; ++view)
            notation.append("/").append(one);
        if (!rest.empty()) notation += " + ";
    }
    notation += '\n';
    Reader reader(notation);
    return read_notation(reader).problem;
}

std::optional<ProvedDegree> proved_degree(const Problem& problem) {
    static const ByProblem<ProvedDegree> all = [] {
        ByProblem<ProvedDegree> degrees;
        for (const ProvedRow& row : proved_rows) {
            ProvedDegree& degree = degrees[problem_of(row)];
            if (degree.at_most > 0) throw std::logic_error("two rows are about one problem");
            degree = {row.at_most, row.theorem};
        }
        return degrees;
    }();
    const ProvedDegree* found = all.find(problem);
    return found ? std::optional(*found) : std::nullopt;
}
} // namespace checker
