// The rows of theorems that treat problems one by one: what monodromy found, and what they are not.
#include "checker/general_bounds/proved_degrees.h"

#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>
#include <map>
#include <string_view>

using namespace checker;

namespace {

std::optional<std::size_t> bound_of(const std::string& notation) {
    const auto proved = proved_degree(parse_problem(notation));
    if (!proved) return std::nullopt;
    return proved->at_most;
}

} // namespace

TEST_CASE("each row of a theorem has the degree that monodromy found") {
    std::map<std::string_view, std::size_t> rows;
    for (const OnFile& on_file : family_degrees_on_file()) {
        const auto proved = proved_degree(parse_problem(on_file.problem));
        if (!proved) continue;
        CAPTURE(on_file.problem);
        static const std::map<std::string_view, std::string_view> families{
            {"A", "plmp"},          {"B", "plmp"},          {"E", "plmp"},
            {"J", "upright-focal"}, {"X", "upright-focal"}, {"O", "shared-focal"},
            {"R", "focal"},         {"Y", "focal"},         {"Z", "focal"},
        };
        const auto family = families.find(proved->theorem);
        CHECK(on_file.family == (family == families.end() ? "projective" : family->second));
        CHECK(proved->at_most == std::stoul(on_file.degree));
        CHECK(on_file.status == "certified");
        ++rows[proved->theorem];
    }
    CHECK(rows == std::map<std::string_view, std::size_t>{{"A", 11},
                                                          {"B", 1},
                                                          {"E", 1},
                                                          {"J", 9},
                                                          {"L", 22},
                                                          {"M", 14},
                                                          {"N", 15},
                                                          {"O", 5},
                                                          {"R", 6},
                                                          {"V", 8},
                                                          {"X", 6},
                                                          {"Y", 3},
                                                          {"Z", 5}});
}

TEST_CASE("a row is found in whatever order its problem is written") {
    CHECK(bound_of("projective: 2*PLabcde/PLabcde/PLabcde + PL/PL/PL") == 4U);
    CHECK(bound_of("projective: a/a/a + 2*Pabcde/Pabcde/Pabcde") == 16U);
}

TEST_CASE("other views and other cameras have no row") {
    CHECK(bound_of("projective: 2*Pabcdef/Pabcdef/Pabcdef") == 4U);
    CHECK(bound_of("projective: 2*Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("projective: 2*Pabcdef/Pabcdef/Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("projective: 2*Pabcdef/Pabcdef/Pabcde") == std::nullopt);
    CHECK(bound_of("2*Pabcdef/Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("PM/PM + PLM/PLM + 2*PL/PL + PM/PM") == 12U);
    CHECK(bound_of("projective: PLM/PLM + 2*PL/PL + 2*PM/PM") == std::nullopt);
    CHECK(bound_of("upright-focal: 2*PLa/PLa/PLa + PL/PL/PL") == 34U);
    CHECK(bound_of("upright-shared-focal: 2*PLa/PLa/PLa + PL/PL/PL") == std::nullopt);
    CHECK(bound_of("upright-focal: Pabcd/Pabcd/Pabcd + P/P/P") == 22U);
    CHECK(bound_of("upright-focal: Pa/Pa/Pa + Pabc/Pabc/Pabc") == 52U);
    CHECK(bound_of("upright-focal: Pa/Pa/Pa + 3*a/a/a") == 60U);
    CHECK(bound_of("upright-focal: 3*P/P/P/P") == 235U);
    CHECK(bound_of("upright-focal: 3*P/P/P") == std::nullopt);
    CHECK(bound_of("upright-focal: Pa/Pa/Pa/Pa + 2*a/a/a/a") == std::nullopt);
    CHECK(bound_of("shared-focal: 5*P/P") == std::nullopt);
    CHECK(bound_of("focal: Pabcdef/Pabcdef/Pabcdef + Pab/Pab/Pab") == 108U);
    CHECK(bound_of("shared-focal: Pab/Pab/Pab + Pabcdef/Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("focal: 2*a/a/a + PL/PL/PL + 2*PLa/PLa/PLa") == 140U);
    CHECK(bound_of("focal: Pa/Pa/Pa + a/a/a + 3*PL/PL/PL") == 98U);
    CHECK(bound_of("focal: 2*PL/PL/PL + PLa/PLa/PLa + P/P/P + a/a/a") == std::nullopt);
    CHECK(bound_of("focal: 3*PL/PL/PL/PL + 2*a/a/a/a") == std::nullopt);
    CHECK(bound_of("focal: PLM/PLM/PLM + PLa/PLa/PLa + PL/PL/PL + 2*PM/PM/PM") == 66U);
    CHECK(bound_of("PLM/PLM/PLM + PLa/PLa/PLa + PL/PL/PL + 2*PM/PM/PM") == std::nullopt);
    CHECK(bound_of("3*PL/PL/PL + P/P/P") == 64U);
    CHECK(bound_of("3*PL/PL/PL + P/P/-") == std::nullopt);
    CHECK(bound_of("3*PL/PL + P/P") == std::nullopt);
    CHECK(bound_of("2*P/P/P/P + Pa/Pa/Pa/Pa") == 1728U);
    CHECK(bound_of("2*P/P/P/P + Pa/Pa/Pa/a") == std::nullopt);
    CHECK(bound_of("projective: 2*P/P/P/P + Pa/Pa/Pa/Pa") == std::nullopt);
}
