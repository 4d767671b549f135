// Families of problems: the paper's counts, and those that follow from the definitions.
#include "prover/minimal/families.h"

#include <doctest/doctest.h>
#include <map>
#include <set>

using namespace plprove;

TEST_CASE("families have the known sizes") {
    const std::vector<Signature>& classes = label_classes();
    std::map<std::string, int> label;
    std::map<std::string, int> swap;
    std::set<Signature> constraint;
    std::set<Signature> minimal_constraint;
    std::set<std::string> plmp;
    for (const Signature& signature : classes) {
        const bool minimal = obstruction(problem_of(signature)).deficiency() == 0;
        constraint.insert(constraint_representative(signature));
        if (!minimal) continue;
        minimal_constraint.insert(constraint_representative(signature));
        const bool first = swap_representative(signature) == signature;
        const Families member = families(signature);
        const std::pair<const char*, bool> memberships[] = {
            {"minimal", true},
            {"pl0p", member.pl0p},
            {"at most one pin", member.at_most_one_pin},
            {"five-point extension", member.five_point_extension},
            {"registration", member.registration},
            {"trifocal", member.trifocal_linear}};
        for (const auto& [name, holds] : memberships) {
            label[name] += holds;
            swap[name] += holds && first;
        }
        if (member.plmp) plmp.insert(*member.plmp);
    }
    CHECK(label["minimal"] == 140616);
    CHECK(swap["minimal"] == 74575);
    CHECK(label["pl0p"] == 51);
    CHECK(swap["pl0p"] == 51);
    CHECK(swap["at most one pin"] == 9533);
    CHECK(label["five-point extension"] == 6413);
    CHECK(swap["five-point extension"] == 3615);
    CHECK(label["registration"] == 61);
    CHECK(swap["trifocal"] == 66);
    CHECK(constraint.size() == 10693);
    CHECK(minimal_constraint.size() == 10073);
    CHECK(plmp == std::set<std::string>{"3002_1", "3002_2", "3010_0", "2005_3", "2005_4", "2005_5",
                                        "2013_2", "2013_3", "2021_1", "1024_4", "1032_2",
                                        "1040_0"});
}

TEST_CASE("representatives are fixed points, and numbers find them") {
    const std::vector<Signature>& classes = label_classes();
    for (std::size_t number = 0; number < classes.size(); number += 61) {
        const Signature swap = swap_representative(classes[number]);
        const Signature constraint = constraint_representative(classes[number]);
        CHECK(swap_representative(swap) == swap);
        CHECK(constraint_representative(swap) == constraint);
        CHECK(classes[class_number(classes, swap)] == swap);
        CHECK(classes[class_number(classes, constraint)] == constraint);
        CHECK(class_number(classes, classes[number]) == number);
    }
}
