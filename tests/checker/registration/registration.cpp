// What is left of extensions of the five-point problem, and what the committed models bound.
#include "checker/registration/registration.h"

#include "checker/degrees/constraint_class.h"
#include "tests/checker/registration/committed.h"

#include <set>

using namespace checker;
using namespace registrations;

namespace {
/// The table by the committed models and the theorems.
const DegreeTable& committed_table() {
    static const DegreeTable table = table_of(committed());
    return table;
}
} // namespace

TEST_CASE("the committed models bound all extensions") {
    std::size_t extensions = 0, terminal = 0;
    std::set<Registration> types;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        if (!is_minimal_class(n)) continue;
        const auto found = bound_by_registration(s, committed());
        CHECK(found.has_value() == has_five_shared_points(s));
        if (!found) continue;
        ++extensions;
        terminal += all_classes().represents_swap_class(n);
        types.insert(found->type);
        const DegreeBounds& known = committed_table().at(constraint_class(s));
        CHECK(known.at_most->solutions <= found->bound);
    }
    CHECK(extensions == 6413);
    CHECK(terminal == 3615);
    CHECK(types.size() == 88); // and the relative pose: 89 models
}

TEST_CASE("upper bounds of extensions are multiples of 80, and the same for all of a swap class") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const std::size_t upper = bound_of(committed_table(), n);
        if (has_five_shared_points(all_classes().representatives[n]))
            CHECK(upper % 80 == 0); // 20 poses; cameras come in fours
        if (is_minimal_class(n))
            CHECK(upper == bound_of(committed_table(), all_classes().swap_class[n]));
    }
}

TEST_CASE("upper bounds of registration problems with known degrees") {
    // Those among the PL0Ps (section 6 of the paper): 160, and 80 with a line.
    CHECK(bound_of(committed_table(), "2*P/P/P + a/a/a + 3*-/P/P") == 80);
    CHECK(bound_of(committed_table(), "3*P/P/P + 2*-/P/P") == 160);
}

TEST_CASE("bounds are the numbers of solutions that Groebner bases modulo a prime have shown") {
    CHECK(committed().at({.stars = {3}}) == 8);
    CHECK(committed().at({.stars = {2}, .lines = 1}) == 4);
    CHECK(committed().at({.stars = {1}, .lines = 2}) == 8);
    CHECK(committed().at({.lines = 3}) == 8);
    CHECK(committed().at({.incidences = 6}) == 8);
    CHECK(committed().at({.stars = {2}, .incidences = 2}) == 8);
    CHECK(committed().at({.stars = {2}, .incidences = 1, .groups = {0, 1}}) == 12);
    CHECK(committed().at({.incidences = 5, .groups = {0, 1}}) == 16);
    CHECK(committed().at({.lines = 2, .groups = {0, 2}}) == 16);
    CHECK(committed().at({.stars = {2}, .groups = {0, 2}}) == 16);
    CHECK(committed().at({.incidences = 4, .groups = {0, 2}}) == 32);
    CHECK(committed().at({.stars = {1}, .groups = {0, 4}}) == 32);
    CHECK(committed().at({.incidences = 3, .groups = {0, 3}}) == 52);
    CHECK(committed().at({.groups = {0, 6}}) == 64);
    CHECK(committed().at(relative_pose) == 20); // ten essential matrices
}

TEST_CASE("without the relative pose, or without the type that is left, nothing is bounded") {
    const Signature& signature = all_classes().representatives[class_of("3*P/P/P + 2*-/P/P")];
    RegistrationBounds bounds = committed();
    const auto found = bound_by_registration(signature, bounds);
    REQUIRE(found.has_value());
    CHECK(found->bound == 160);
    CHECK(found->type == Registration{.stars = {3}});
    bounds.erase(found->type);
    CHECK_FALSE(bound_by_registration(signature, bounds).has_value());
    bounds = committed();
    bounds.erase(relative_pose);
    CHECK_FALSE(bound_by_registration(signature, bounds).has_value());
}

TEST_CASE("views that share four points are no pair, whatever is bounded") {
    const Signature& s = all_classes().representatives[class_of("P/P/P + 4*a/a/a")];
    Signature four{};
    four[index_of("P/P/P")] = 4;
    for (const Signature& signature : {s, four}) {
        const RegistrationBounds bounds{{relative_pose, 20}, {registration(signature, 0b110), 7}};
        CHECK_FALSE(bound_by_registration(signature, bounds).has_value());
    }
}

TEST_CASE("of two pairs of views that share five points the smaller bound counts") {
    std::size_t tried = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 5) {
        const Signature& s = all_classes().representatives[n];
        std::set<Registration> types;
        for (const Views pair : view_pairs)
            if (shared_points(s, pair) == 5) types.insert(registration(s, pair));
        if (types.size() < 2) continue;
        for (const Registration& best : types) {
            RegistrationBounds bounds{{relative_pose, 20}};
            for (const Registration& type : types)
                bounds[type] = type == best ? 7 : 10;
            const auto found = bound_by_registration(s, bounds);
            REQUIRE(found.has_value());
            CHECK(found->bound == 140);
            CHECK(found->type == best);
            ++tried;
        }
    }
    CHECK(tried > 0);
}

TEST_CASE("what a feature contributes to a registration is as in the table of section 10") {
    // View 1 is registered with the views 2 and 3.
    const auto left = [](std::initializer_list<std::string_view> names) {
        Signature signature{};
        for (const std::string_view name : names)
            ++signature[index_of(name)];
        return registration(signature, 0b110);
    };
    for (const std::string_view star : {"P/P/P", "P/Pa/a", "P/a/Pa", "Pa/P/a", "Pa/a/P"})
        CHECK(left({star}) == Registration{.stars = {1}});
    for (const std::string_view star : {"Pa/Pa/Pa", "Pa/Pa/a", "Pa/a/Pa"})
        CHECK(left({star}) == Registration{.stars = {0, 1}});
    CHECK(left({"Pabc/Pabc/Pabc"}) == Registration{.stars = {0, 0, 0, 1}});
    for (const std::string_view line : {"a/a/a", "a/Pa/Pa"})
        CHECK(left({line}) == Registration{.lines = 1});
    for (const std::string_view incidence : {"a/P/Pa", "a/Pa/P", "a/P/a", "a/a/P", "b/Pab/a"})
        CHECK(left({incidence}) == Registration{.incidences = 1});
    CHECK(left({"-/P/P"}) == Registration{});
    for (const std::string_view alone : {"P/a/a", "Pab/b/a"}) {
        CHECK(left({alone}) == Registration{.groups = {0, 1}});
        CHECK(left({alone, alone}) == Registration{.groups = {0, 2}});
    }
    CHECK(left({"P/P/-"}) == Registration{.groups = {0, 1}});
    CHECK(left({"P/P/-", "P/P/-"}) == Registration{.groups = {0, 0, 1}});
    CHECK(left({"P/P/-", "P/-/P"}) == Registration{.groups = {0, 2}});
    CHECK(left({"P/P/-", "P/a/a"}) == Registration{.groups = {0, 2}});
}

TEST_CASE("views that trade names leave the same registration") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 7) {
        const Signature& s = all_classes().representatives[n];
        if (!has_five_shared_points(s)) continue;
        std::multiset<Registration> types;
        for (const Views pair : view_pairs)
            if (shared_points(s, pair) == 5) types.insert(registration(s, pair));
        for (const FeatureMap& map : relabelings) {
            const Signature image = permuted(s, map);
            std::multiset<Registration> others;
            for (const Views pair : view_pairs)
                if (shared_points(image, pair) == 5) others.insert(registration(image, pair));
            CHECK(types == others);
        }
    }
}

TEST_CASE("every registration of a minimal problem has weight six") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        if (!is_minimal_class(n)) continue;
        const Signature& s = all_classes().representatives[n];
        for (const Views pair : view_pairs) {
            if (shared_points(s, pair) != 5) continue;
            const Registration type = registration(s, pair);
            unsigned weight = 2 * type.lines + type.incidences;
            for (unsigned pins = 0; pins < type.stars.size(); ++pins)
                weight += type.stars[pins] * (2 + pins);
            for (unsigned rays = 0; rays < type.groups.size(); ++rays)
                weight += type.groups[rays] * rays;
            CHECK(weight == 6);
        }
    }
}
