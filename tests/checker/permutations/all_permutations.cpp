// Theorem S: of which classes it says that their solutions are permuted in all ways.
#include "checker/permutations/all_permutations.h"

#include "checker/permutations/five_shared_points.h"
#include "checker/permutations/general_pairs.h"
#include "checker/problem/notation.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

bool says_so(std::initializer_list<std::pair<const char*, unsigned>> problem) {
    Signature signature{};
    for (const auto& [feature, times] : problem)
        signature[index_of(feature)] += times;
    return has_all_permutations(signature);
}

} // namespace

TEST_CASE("Theorem S says that most problems have all permutations") {
    CHECK(says_so({{"-/P/P", 4}, {"P/-/P", 4}, {"P/P/-", 3}}));
    CHECK(says_so({{"P/a/a", 11}}));
    CHECK(says_so({{"a/P/Pa", 3}, {"P/a/Pa", 2}, {"a/a/P", 1}}));
    CHECK(says_so({{"P/P/P", 3}, {"-/P/P", 1}, {"P/-/P", 1}}));
    CHECK(says_so({{"Pabcd/Pabcd/Pabcd", 1}, {"a/a/P", 4}}));
    CHECK(says_so({{"a/Pa/Pa", 1}, {"a/a/a", 2}, {"a/P/a", 4}}));
    // The order of the views does not matter, nor which of the two features puts its condition.
    CHECK(says_so({{"P/P/-", 4}, {"P/-/P", 3}, {"-/P/P", 4}}));
    CHECK(says_so({{"Pab/b/a", 5}, {"P/a/a", 6}}));
}

TEST_CASE("Theorem S says nothing of problems that decompose") {
    // Five points that two views share: the relative pose comes first.
    CHECK(!says_so({{"-/P/P", 5}, {"P/-/P", 3}, {"P/a/a", 3}}));
    CHECK(!says_so({{"P/P/P", 1}, {"-/P/P", 4}, {"P/-/P", 4}}));
    CHECK(!says_so({{"a/P/Pa", 5}, {"a/a/P", 1}}));
    // Six lines through a point fix the rotations.
    CHECK(!says_so({{"Pabcdef/Pabcdef/Pabcdef", 1}, {"P/-/P", 1}, {"P/P/-", 1}}));
    // A half turn: view 1 sees one point with lines, and one thing more.
    CHECK(!says_so({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 3}, {"P/-/P", 1}}));
}

TEST_CASE("general pairs of cameras are told from special ones") {
    Drawn drawn;
    const MovingViews views(drawn);
    const Echelon all;
    const Motion motion = all.motion(drawn);
    CHECK(epipolar_form_is_general(views, 0, 1, motion));
    CHECK(tensor_is_general(views, 0, motion, drawn));
    CHECK(tensor_is_general(views, 2, motion, drawn));
    // Nothing moves; or view 3 alone does. Then views 1 and 2 keep their form, and the tensors are
    // proportional for planes of view 2 that contain the baseline.
    CHECK(!epipolar_form_is_general(views, 0, 1, {}));
    CHECK(!tensor_is_general(views, 0, {}, drawn));
    Motion third = motion;
    for (const std::size_t i : {0, 1, 2, 6, 7, 8})
        third[i] = {};
    CHECK(!epipolar_form_is_general(views, 0, 1, third));
    CHECK(!tensor_is_general(views, 0, third, drawn));

    // Planes through the rays to a point. They are special if two views have the same ray.
    const ResidueVector point = drawn.vector();
    NormalsOfPin normals;
    for (std::size_t view = 0; view < 3; ++view)
        for (ResidueVector& normal : normals[view])
            normal = drawn.normal_to(views.from(view, point));
    CHECK(pin_is_general(normals, all, drawn));
    NormalsOfPin special = normals;
    for (ResidueVector& normal : special[1])
        normal = drawn.normal_to(views.from(0, point));
    CHECK(!pin_is_general(special, all, drawn));

    const auto form_of = [&](const NormalsOfPin& of, const ResidueVector& seen) {
        BilinearForm form;
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b)
                form[a][b] = MovingViews::pencil({of[0][a], of[1][b], seen});
        return form;
    };
    CHECK(line_is_general(form_of(normals, drawn.vector()), all, drawn));
    // The plane contains the ray of view 1: then the form is a product.
    CHECK(!line_is_general(form_of(normals, drawn.normal_to(views.from(0, point))), all, drawn));
}

TEST_CASE("Theorem P says how third cameras are permuted where two views share five points") {
    const auto says_so_of_third = [](std::initializer_list<std::pair<const char*, unsigned>> of) {
        Signature signature{};
        for (const auto& [feature, times] : of)
            signature[index_of(feature)] += times;
        return has_all_permutations_of_third_cameras(signature);
    };
    CHECK(says_so_of_third({{"Pa/Pa/Pa", 1}, {"a/P/Pa", 1}, {"P/-/P", 4}, {"a/a/P", 1}}));
    CHECK(says_so_of_third({{"-/P/P", 5}, {"P/-/P", 2}, {"P/P/-", 2}, {"P/a/a", 2}}));
    CHECK(says_so_of_third({{"P/P/-", 5}, {"a/a/P", 6}}));
    // Two pairs of views share five points, or none does.
    CHECK(!says_so_of_third({{"-/P/P", 5}, {"P/-/P", 5}, {"P/a/a", 1}}));
    CHECK(!says_so_of_third({{"-/P/P", 4}, {"P/-/P", 4}, {"P/a/a", 3}}));
    // Three known points, and a known point with three lines: by smaller steps.
    CHECK(!says_so_of_third({{"P/P/P", 3}, {"-/P/P", 2}}));
    CHECK(!says_so_of_third({{"Pabc/Pabc/Pabc", 1}, {"P/P/-", 4}, {"a/a/P", 1}}));
}
