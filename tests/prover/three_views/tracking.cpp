// The tracker against exact arithmetic and against itself, with more digits and on other
// instruction sets.
#include "prover/tracking/multiple_doubles.h"
#include "tests/support/solved_class.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <gmpxx.h>

using namespace plprove;

TEST_CASE("what doubles lose arrives with two or three times the digits") {
    // Here many paths pass by cameras that are nearly degenerate.
    const Solved solved(257, 600, 0);
    const Images& from = solved.loops().images();
    Random random(13, 0);
    const TrackedImages images =
        solved.moving(from, rephased(random_neighbour(from, random), Phases::near_one, random));
    const std::vector<CameraPoint>& starts = solved.solutions();
    PathFollower follower(solved.tracked());
    const auto lost = [](const std::vector<CameraPoint>& of, const PathFollower::Ends& ends) {
        std::vector<CameraPoint> result;
        for (std::size_t i = 0; i < of.size(); ++i)
            if (!ends[i]) result.push_back(of[i]);
        return result;
    };
    const auto quickly = lost(starts, follower.follow_quickly(images, starts));
    const auto lost_again = lost(quickly, follower.follow_double_double(images, quickly));
    CHECK(quickly.size() > 10);
    CHECK(lost_again.size() == 1);
    CHECK(lost(lost_again, follower.follow_triple_double(images, lost_again)).empty());
}

namespace {

using plprove::PLC_LANES::DoubleDouble;
using plprove::PLC_LANES::Real;
using plprove::PLC_LANES::TripleDouble;

mpq_class exact(Real x) {
    return mpq_class(at(x, 0));
}
mpq_class exact(DoubleDouble x) {
    return exact(x.high) + exact(x.low);
}
mpq_class exact(TripleDouble x) {
    return exact(x.high) + exact(x.middle) + exact(x.low);
}

/// Checks that the operations on such numbers are right up to 2^-bits, of the terms of a sum or the
/// value of a product or quotient, against exact arithmetic.
template <class Number>
void check_operations(int bits) {
    Random random(6, 0);
    const mpq_class small = mpq_class(1) / (mpz_class(1) << static_cast<unsigned>(bits));
    const auto number = [&] { // of parts that do not overlap, and of any size
        const double size = std::ldexp(1.0, static_cast<int>(40 * random.complex().real()));
        Number sum = Number::of(0);
        for (const int part : {0, 54, 108})
            sum = sum + Number::of(std::ldexp(random.complex().real(), -part) * size);
        return sum;
    };
    for (int i = 0; i < 1000; ++i) {
        const Number a = number(), b = number(), c = i % 2 == 0 ? number() : a * b;
        const mpq_class x = exact(a), y = exact(b), z = exact(c);
        const auto near = [&](const Number& computed, const mpq_class& value,
                              const mpq_class& scale) {
            return abs(exact(computed) - value) <= small * abs(scale);
        };
        CHECK(near(a + b, x + y, abs(x) + abs(y)));
        CHECK(near(a - b, x - y, abs(x) + abs(y)));
        CHECK(near(a * b, x * y, x * y));
        CHECK(near(a / b, x / y, x / y));
        CHECK(near(fma(a, b, c), x * y + z, abs(x * y) + abs(z)));
        CHECK(near(fnma(a, b, c), z - x * y, abs(x * y) + abs(z))); // cancels where c = a * b
    }
}

} // namespace

TEST_CASE("sums of two and three doubles have 30 and 45 digits at least") {
    check_operations<DoubleDouble>(100);
    check_operations<TripleDouble>(150);
}

TEST_CASE("every instruction set tracks the same paths to the same bits, with any precision") {
    const Solved solved(number_of("3*P/P/P + a/a/a"));
    const Images& from = solved.loops().images();
    Random random(4, 0);
    const Images to = rephased(random_neighbour(from, random), Phases::near_one, random);
    const TrackedSystem system = solved.tracked();
    const TrackedImages images = solved.moving(from, to);
    std::vector<CameraPoint> starts = solved.solutions();
    starts.resize(21); // no multiple of a number of lanes
    const auto ends = [&](TrackFunction* track) {
        std::vector<CameraPoint> result(starts.size());
        std::vector<TrackOutcome> outcomes(starts.size());
        track(system, images, {}, starts.size(), starts.data(), result.data(), outcomes.data());
        CHECK(std::ranges::count(outcomes, TrackOutcome::arrived) >= 20);
        return result;
    };
    const std::vector<CameraPoint> expected = ends(portable::track);
    const std::vector<CameraPoint> expected_double_double = ends(portable::track_double_double);
    const std::vector<CameraPoint> expected_triple_double = ends(portable::track_triple_double);
    const TrackedImages at_rest = solved.moving(from, from), others = solved.moving(to, to);
    const auto values = [&](RefinedValuesFunction* refined_values) {
        std::vector<Complex> result(starts.size() * camera_dimension);
        refined_values(system, at_rest, others, starts.size(), starts.data(), result.data());
        return result;
    };
    const std::vector<Complex> expected_values = values(portable::refined_values);
    CHECK(ends(fastest_tracker()) == expected);
    CHECK(ends(fastest_double_double_tracker()) == expected_double_double);
    CHECK(ends(fastest_triple_double_tracker()) == expected_triple_double);
    CHECK(values(fastest_refined_values()) == expected_values);
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        CHECK(ends(avx2::track) == expected);
        CHECK(ends(avx2::track_double_double) == expected_double_double);
        CHECK(ends(avx2::track_triple_double) == expected_triple_double);
        CHECK(values(avx2::refined_values) == expected_values);
    }
#endif
}
