#include "prover/catalogue/columns.h"

#include "prover/catalogue/spelling.h"

namespace plprove {

namespace {

constexpr ColumnKind integer = ColumnKind::integer;
constexpr ColumnKind flag = ColumnKind::flag;
constexpr ColumnKind text = ColumnKind::text;

Value number_value(std::size_t number) {
    return static_cast<int>(number);
}
Value flag_value(bool holds) {
    return holds ? 1 : 0;
}

Value known_value(const std::optional<int>& number) {
    if (!number) return std::monostate{};
    return *number;
}

Value text_value(const std::optional<GroupOnFile>& group, std::string_view GroupOnFile::*member) {
    if (!group) return std::monostate{};
    return std::string((*group).*member);
}

std::string signature_text(const Signature& signature) {
    std::string result;
    for (const auto multiplicity : signature)
        (result += std::to_string(multiplicity)) += ' ';
    result.pop_back();
    return result;
}

const Column table[] = {
    {"number", integer, false, "the authors' number of the label class, 0 to 143493",
     [](const Entry& e) { return number_value(e.number); }},
    {"signature", text, false,
     "the multiplicities of the 27 features in the representative, separated by blanks",
     [](const Entry& e) -> Value { return signature_text(e.signature); }},
    {"notation", text, false, "the representative as a sum of features",
     [](const Entry& e) -> Value { return notation(e.signature); }},
    {"minimal", flag, false, "whether the class is minimal",
     [](const Entry& e) { return flag_value(e.minimal()); }},
    {"rank", integer, false, "the generic rank of the camera part of the Jacobian, 11 - deficiency",
     [](const Entry& e) -> Value { return e.rank(); }},
    {"deficiency", integer, false, "max(E, S); E is the sum of the three excesses",
     [](const Entry& e) -> Value { return e.obstruction.deficiency(); }},
    {"excess_12", integer, false, "points beyond five that views 1 and 2 share",
     [](const Entry& e) -> Value { return e.obstruction.excess[0]; }},
    {"excess_13", integer, false, "points beyond five that views 1 and 3 share",
     [](const Entry& e) -> Value { return e.obstruction.excess[1]; }},
    {"excess_23", integer, false, "points beyond five that views 2 and 3 share",
     [](const Entry& e) -> Value { return e.obstruction.excess[2]; }},
    {"star", flag, false, "S: whether a point with three or more pins lets a camera slide",
     [](const Entry& e) -> Value { return e.obstruction.star; }},
    {"obstruction", text, false, "none, epipolar (E > 0), star (S > 0) or epipolar and star",
     [](const Entry& e) -> Value { return std::string(obstruction_name(e.obstruction)); }},
    {"certificate", text, false,
     "the file whose record of this number certifies the verdict and the rank; plcheck replays it",
     [](const Entry&) -> Value { return "certs/classification.plc"; }},
    {"swap_class", integer, false, "the smallest number in the swap&label class",
     [](const Entry& e) { return number_value(e.swap_class); }},
    {"constraint_class", integer, false,
     "the smallest number among the classes with the same camera equations",
     [](const Entry& e) { return number_value(e.constraint_class); }},
    {"terminal", flag, false,
     "whether the class stands for its terminal problem: minimal, the first of its swap class",
     [](const Entry& e) { return flag_value(e.terminal()); }},
    {"terminal_problem", text, true,
     "the terminal problem that a minimal class becomes, the same for its whole swap class",
     [](const Entry& e) -> Value {
         if (!e.minimal()) return std::monostate{};
         return terminal_notation(swap_representative(e.signature));
     }},
    {"points", integer, false, "points", [](const Entry& e) -> Value { return e.counts.points; }},
    {"lines", integer, false, "lines in all: pins and free lines",
     [](const Entry& e) -> Value { return e.counts.lines(); }},
    {"pins", integer, false, "lines through a point",
     [](const Entry& e) -> Value { return e.counts.pins; }},
    {"free_lines", integer, false, "lines through no point",
     [](const Entry& e) -> Value { return e.counts.free_lines; }},
    {"most_pins", integer, false, "the largest number of pins of a point",
     [](const Entry& e) -> Value { return e.counts.most_pins; }},
    {"points_in_1", integer, false, "points that view 1 sees",
     [](const Entry& e) -> Value { return e.counts.points_in_view[0]; }},
    {"points_in_2", integer, false, "points that view 2 sees",
     [](const Entry& e) -> Value { return e.counts.points_in_view[1]; }},
    {"points_in_3", integer, false, "points that view 3 sees",
     [](const Entry& e) -> Value { return e.counts.points_in_view[2]; }},
    {"lines_in_1", integer, false, "lines that view 1 sees",
     [](const Entry& e) -> Value { return e.counts.lines_in_view[0]; }},
    {"lines_in_2", integer, false, "lines that view 2 sees",
     [](const Entry& e) -> Value { return e.counts.lines_in_view[1]; }},
    {"lines_in_3", integer, false, "lines that view 3 sees",
     [](const Entry& e) -> Value { return e.counts.lines_in_view[2]; }},
    {"shared_12", integer, false, "points that views 1 and 2 share",
     [](const Entry& e) -> Value { return e.counts.shared_points[0]; }},
    {"shared_13", integer, false, "points that views 1 and 3 share",
     [](const Entry& e) -> Value { return e.counts.shared_points[1]; }},
    {"shared_23", integer, false, "points that views 2 and 3 share",
     [](const Entry& e) -> Value { return e.counts.shared_points[2]; }},
    {"complete_views", integer, false, "how many views see every point and every line",
     [](const Entry& e) -> Value { return e.counts.complete_views; }},
    {"pl0p", flag, false, "whether there are free points and free lines only",
     [](const Entry& e) { return flag_value(e.families.pl0p); }},
    {"one_pin", flag, false, "whether no point has two or more pins",
     [](const Entry& e) { return flag_value(e.families.at_most_one_pin); }},
    {"complete_visibility", flag, false, "whether all three views see everything",
     [](const Entry& e) { return flag_value(e.counts.complete_views == 3); }},
    {"plmp", text, true, "minimal with complete visibility: the name in PLMP, Table 1",
     [](const Entry& e) -> Value {
         if (!e.families.plmp) return std::monostate{};
         return *e.families.plmp;
     }},
    {"five_point", flag, false, "minimal, and some two views share exactly five points",
     [](const Entry& e) { return flag_value(e.families.five_point_extension); }},
    {"registration", flag, false,
     "a five-point extension in which such two views fix all that they see",
     [](const Entry& e) { return flag_value(e.families.registration); }},
    {"trifocal", flag, false,
     "minimal, and its terminal problem is one of the 66 linear in the trifocal tensor",
     [](const Entry& e) { return flag_value(e.families.trifocal_linear); }},
    {"degree", integer, true, "the number of solutions for the cameras, of a minimal class",
     [](const Entry& e) { return known_value(e.degree); }},
    {"group", text, true,
     "how loops of photos permute the solutions, where it is known: S312 for all permutations, <S8 "
     "wr S2 wr S10 for a subgroup of those that keep 10 blocks of 2 blocks of 8 together",
     [](const Entry& e) { return text_value(e.group, &GroupOnFile::name); }},
    {"group_order", text, true, "how many permutations these are, as a product",
     [](const Entry& e) { return text_value(e.group, &GroupOnFile::order); }},
    {"width", integer, true,
     "how many solutions the hardest step of the problem has, by its group (Galois width)",
     [](const Entry& e) { return known_value(e.width()); }},
    {"group_status", text, true,
     "certified: plcheck certifies the group, by a theorem or by certs/groups; evidence: loops "
     "that plprove followed",
     [](const Entry& e) { return text_value(e.group, &GroupOnFile::status); }},
};

constexpr Remark about[] = {
    {"title", "Balanced point-line problems in three calibrated views, at most one point per line"},
    {"numbers", "The authors' numbers of the 143,494 label classes (certs/FORMAT.md, section 1)"},
    {"representative", "Views 1, 2, 3 are those of the representative; a class is closed under "
                       "relabeling them"},
    {"verdicts", "minimal, rank and obstruction are computed by the prover from the signature. "
                 "certs/classification.plc holds a certificate for each class: check it with "
                 "plcheck certs/classification.plc"},
    {"families", "plmp, five_point, registration and trifocal hold for minimal classes only"},
    {"degrees", "Each is certified exactly: plcheck --table certs/classification.plc computes it"},
};

} // namespace

std::span<const Column> columns() {
    return table;
}

std::span<const Remark> remarks() {
    return about;
}

} // namespace plprove
