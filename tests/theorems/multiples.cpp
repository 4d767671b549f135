// Theorem G of proofs/multiples.md: the combinatorics of Lemma G4, by trying all subspaces, and the
// degrees on file.
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <ranges>
#include <set>
#include <string>
#include <vector>

namespace {

/// A vector of F_2^2m: the two bits from 2v on are its part in the plane of view v.
using Vector = unsigned;
/// All elements of a subspace, in order.
using Subspace = std::vector<Vector>;

bool contains(const Subspace& subspace, Vector vector) {
    return std::ranges::binary_search(subspace, vector);
}

/// The subspaces that contain one of the given ones and have one dimension more.
std::set<Subspace> extensions(const std::set<Subspace>& subspaces, unsigned views) {
    std::set<Subspace> all;
    for (const Subspace& subspace : subspaces)
        for (Vector vector = 1; vector < 1U << (2 * views); ++vector) {
            if (contains(subspace, vector)) continue;
            Subspace larger = subspace;
            for (const Vector element : subspace)
                larger.push_back(element ^ vector);
            std::ranges::sort(larger);
            all.insert(std::move(larger));
        }
    return all;
}

/// The three nonzero vectors of the plane of a view.
auto plane(unsigned view) {
    return std::views::iota(1U, 4U) |
           std::views::transform([view](Vector bits) { return bits << (2 * view); });
}

bool meets_plane(const Subspace& subspace, unsigned view) {
    return std::ranges::any_of(plane(view), [&](Vector v) { return contains(subspace, v); });
}

/// Whether modulo the subspace the planes of two views are the same.
bool identifies_planes(const Subspace& subspace, unsigned u, unsigned v) {
    return std::ranges::all_of(plane(u), [&](Vector a) {
        return std::ranges::any_of(plane(v), [&](Vector b) { return contains(subspace, a ^ b); });
    });
}

/// Whether modulo the subspace all norm forms may be the same: all have zeros, or none has any and
/// all have the same values.
bool makes_forms_equal(const Subspace& subspace, unsigned views) {
    const auto all = std::views::iota(0U, views);
    const auto meets = [&](unsigned view) { return meets_plane(subspace, view); };
    if (std::ranges::all_of(all, meets)) return true;
    return std::ranges::none_of(all, meets) && std::ranges::all_of(all, [&](unsigned view) {
               return identifies_planes(subspace, view, 0);
           });
}

/// The span of one vector of each plane.
Subspace roots(unsigned views) {
    Subspace span{0};
    for (unsigned view = 0; view < views; ++view)
        for (std::size_t i = 0, end = span.size(); i < end; ++i)
            span.push_back(span[i] ^ (1U << (2 * view)));
    std::ranges::sort(span);
    return span;
}

TEST_CASE("calibrations of m views come together over fields of degree 2^m, and no smaller power") {
    for (const unsigned views : {2U, 3U, 4U}) {
        std::set<Subspace> subspaces{{0}};
        for (unsigned dimension = 0; dimension < views; ++dimension) {
            if (dimension > 0) subspaces = extensions(subspaces, views);
            CHECK(std::ranges::none_of(
                subspaces, [&](const Subspace& s) { return makes_forms_equal(s, views); }));
        }
        CHECK(makes_forms_equal(roots(views), views));
    }
}

TEST_CASE("the degrees of PLMP on file are multiples of two to the number of views") {
    std::set<unsigned> sharp; // numbers of views with a degree that is no multiple of more
    std::size_t degrees = 0;
    for (const OnFile& row : family_degrees_on_file()) {
        if (row.family != "plmp") continue;
        const auto first = row.problem.substr(0, row.problem.find(' '));
        const auto views = 1 + static_cast<unsigned>(std::ranges::count(first, '/'));
        const unsigned long degree = std::stoul(row.degree);
        INFO(row.problem);
        CHECK(degree % (1UL << views) == 0);
        if (degree % (2UL << views) != 0) sharp.insert(views);
        ++degrees;
    }
    CHECK(degrees == 30);
    CHECK(sharp == std::set<unsigned>{2, 3, 5});
}
} // namespace
