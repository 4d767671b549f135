// What refuses a fibre: a system of two equations for two unknowns takes the place of cameras.
#include "checker/fibres/prove_fibre.h"

#include "checker/degrees/cameras_at.h"
#include "tests/support/text.h"

using namespace checker;

namespace {
/// x + y = 0 and x y = c, with the condition that x is not 0. So x² = -c. Or the first equation
/// twice, which any fibre solves whose x is -y.
struct Toy {
    int c = 0;
    bool twice = false;
};

template <class T>
class ToyAt {
public:
    explicit ToyAt(const Toy& toy) : toy_(toy) {}

    void move_to(const std::vector<T>& z) { z_ = z; }

    T equation(std::size_t e, std::vector<T>& row) const {
        const T& x = z_[0];
        const T& y = z_[1];
        const bool first = e == 0 || toy_.twice;
        row = first ? std::vector<T>{T(1), T(1)} : std::vector<T>{y, x};
        return first ? x + y : x * y - T(toy_.c);
    }

    std::string_view degeneracy() const { return nonzero(z_[0]) ? "" : "x is 0"; }

private:
    Toy toy_;
    std::vector<T> z_;
};

Residue of(int number) {
    return in_ring<Residue>(number);
}

/// x = t and y = -t, with t² = 4: the solutions of x y = -4.
Fibre two_and_minus_two() {
    return {.lower = {of(-4), of(0)},
            .unknowns = {{of(0), of(1)}, {of(0), of(-1)}},
            .separated_by = {1, 0}};
}

std::string refusal_of(const Fibre& fibre, int c, bool twice = false) {
    try {
        prove_fibre<ToyAt>(Toy{c, twice}, fibre);
        return "";
    } catch (const Refused& refused) {
        return refused.reason;
    }
}
} // namespace

TEST_CASE("a fibre is refused for each of its flaws") {
    CHECK(refusal_of(two_and_minus_two(), -4).empty());
    CHECK(refusal_of(two_and_minus_two(), -5) == "equation 2 is not 0");

    Fibre other = two_and_minus_two();
    other.unknowns[1][0] = of(1);
    CHECK(refusal_of(other, -4) == "equation 1 is not 0");

    other = two_and_minus_two();
    other.separated_by = {1, 1};
    CHECK(refusal_of(other, -4) == "the sum of `separated by` is not t");
    // The sum of both unknowns is 0: so are the roots.
    other.lower = {of(0), of(0)};
    CHECK(refusal_of(other, -4) == "the polynomial has a multiple root");

    // x = 0 is a solution of x y = 0, and a singular one; the condition is tried first.
    const Fibre zero{.lower = {of(0)}, .unknowns = {{of(0)}, {of(0)}}, .separated_by = {1, 0}};
    CHECK(refusal_of(zero, 0) == "x is 0");
    CHECK(refusal_of(two_and_minus_two(), -4, true) == "the Jacobian has no inverse");
}

TEST_CASE("a condition has to hold at each root, not at one") {
    // x is t - 2 and y is 2 - t: at the root 2 of t² - 4 x is 0, at -2 it is -4.
    const Extension extension({of(-4), of(0)});
    const FibreNumber t(extension.variable(), extension), two(2);
    CHECK(nonzero(t));
    CHECK_FALSE(nonzero(t - two));
    CHECK_FALSE((t - two).is_zero());
    CHECK(((t - two) * (t + two)).is_zero());
    CHECK(nonzero(two - FibreNumber(1)));
    CHECK_FALSE(nonzero(two - FibreNumber(2)));
    CHECK_FALSE(nonzero(FibreNumber()));
}

TEST_CASE("a Jacobian that is singular at one root is refused") {
    const Extension extension({of(-4), of(0)});
    const Polynomial t = extension.variable(), zero = extension.constant({}),
                     one = extension.constant({1});
    const Polynomial vanishes_at_two = {of(-2), of(1)};
    CHECK(is_regular(extension, {{one, t}, {zero, t}}));
    CHECK_FALSE(is_regular(extension, {{one, t}, {one, t}}));
    CHECK_THROWS_AS(is_regular(extension, {{one, zero}, {zero, vanishes_at_two}}), Refused);
    // Another row has a pivot.
    CHECK(is_regular(extension, {{vanishes_at_two, one}, {one, zero}}));
}

TEST_CASE("a quaternion of norm 0 is no rotation") {
    // 1 + x² + 0 + 0 = 0 for x² = -1; at the other quaternion, 0 0 0, the norm is 1.
    const Extension extension({of(1), of(0)});
    CameraCoordinates<FibreNumber> cameras;
    cameras[0] = FibreNumber(extension.variable(), extension);
    const CameraSystem system;
    BackProjections<FibreNumber> space;
    back_project(system, cameras, space);
    CHECK(degeneracy(system, cameras, space) == "the norm of a quaternion is zero");
    cameras[0] = FibreNumber(2);
    back_project(system, cameras, space);
    CHECK(degeneracy(system, cameras, space).empty());
}
