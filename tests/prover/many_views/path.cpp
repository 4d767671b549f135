// Paths in any number of views: where they end, judged by the equations written a second way, and
// that it is the same with every instruction set.
#include "prover/many_views/path.h"

#include "prover/many_views/incidences.h"
#include "prover/many_views/way.h"
#include "prover/problem/notation.h"

#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

const char* const problems[] = {
    "2*Pa/Pa/Pa + P/P/P",
    "3*PL/PL/PL/PL + a/a/a/a",
    "PL/PL/PL + PLa/PLa/PLa + PLab/PLab/PLab",
    "projective: 7*P/P",
    "projective: PL/PL/PL + 2*PLabcde/PLabcde/PLabcde",
    "projective: 6*a/a/a/a/a/a/a/a/a",
    "Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a",
    "upright-shared-focal: 4*P/P",
};
/// One for each way to evaluate cameras; with twice the digits others take long.
const char* const small_problems[] = {"5*P/P", "projective: 7*P/P", "upright-shared-focal: 4*P/P"};

/// A way from images of a random scene to random images.
struct Journey {
    explicit Journey(const char* text, std::uint64_t seed = 7)
        : problem(parse_problem(text)), random(seed, 0), system(problem, random),
          scene(system.random_scene(random)), to(random_images(problem, random)) {}

    Problem problem;
    Random random;
    System system;
    SolvedImages scene;
    Images<Complex> to;
};

double residual(const System& system, const Images<Complex>& images, const Point& point) {
    Evaluation evaluation;
    system.evaluate(on_the_way(images, images, 0), point, evaluation);
    return evaluation.values.norm() / (1 + point.squaredNorm());
}

Complex value(const Polynomial& polynomial, double time) {
    Complex sum = 0, power = 1;
    for (const Complex& c : polynomial.coefficients()) {
        sum += c * power;
        power *= time;
    }
    return sum;
}

Complex derivative(const Polynomial& polynomial, double time) {
    Complex sum = 0, power = 1;
    for (std::size_t i = 1; i < polynomial.coefficients().size(); ++i) {
        sum += static_cast<double>(i) * polynomial.coefficients()[i] * power;
        power *= time;
    }
    return sum;
}

void check_path(const char* text, Care care) {
    CAPTURE(text);
    const Journey journey(text);
    const auto end =
        follow(journey.system, journey.scene.images, journey.to, journey.scene.solution, care);
    REQUIRE(end);
    CHECK(residual(journey.system, journey.to, *end) < 1e-13);
    const auto back = follow(journey.system, journey.to, journey.scene.images, *end, Care::careful);
    REQUIRE(back);
    CHECK(residual(journey.system, journey.scene.images, *back) < 1e-13);
}

} // namespace

TEST_CASE("paths end at solutions of the images they lead to") {
    for (const char* text : problems) {
        check_path(text, Care::usual);
        check_path(text, Care::careful);
    }
    for (const char* text : small_problems)
        check_path(text, Care::precise);
}

namespace {

/// What a tracker makes of some paths: of one start several times, and of others that are no
/// solutions, so that some paths get lost.
struct Tracks {
    static constexpr std::size_t paths = 11;

    Tracks(TrackFunction* track, const Journey& journey) {
        const Way way(journey.system, journey.scene.images, journey.to);
        std::vector<double> starts;
        for (std::size_t path = 0; path < paths; ++path)
            for (const Complex& x : journey.scene.solution) {
                starts.push_back(x.real() + static_cast<double>(path % 3 * path) * 1e-3);
                starts.push_back(x.imag());
            }
        std::vector<LaneNumber> workspace(workspace_size(way.tracked()));
        ends.resize(starts.size());
        outcomes.resize(paths);
        track(way.tracked(), usual_settings, paths, starts.data(), ends.data(), outcomes.data(),
              workspace.data());
    }

    std::vector<double> ends;
    std::vector<TrackOutcome> outcomes;
};

void check_agreement(const std::vector<TrackFunction*>& trackers, const char* text) {
    CAPTURE(text);
    const Journey journey(text);
    const Tracks first(trackers[0], journey);
    CHECK(first.outcomes[0] == TrackOutcome::arrived);
    CHECK(first.outcomes[9] == TrackOutcome::arrived);
    for (std::size_t i = 1; i < trackers.size(); ++i) {
        const Tracks other(trackers[i], journey);
        CHECK(other.ends == first.ends);
        CHECK(other.outcomes == first.outcomes);
    }
}

} // namespace

TEST_CASE("every instruction set follows the same paths to the same bits") {
    std::vector<TrackFunction*> doubles{portable::track};
    std::vector<TrackFunction*> double_doubles{portable::track_double_double};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        doubles.push_back(avx2::track);
        double_doubles.push_back(avx2::track_double_double);
    }
    if (__builtin_cpu_supports("avx512f")) {
        doubles.push_back(avx512::track);
        double_doubles.push_back(avx512::track_double_double);
    }
#endif
    for (const char* text : problems)
        check_agreement(doubles, text);
    for (const char* text : small_problems)
        check_agreement(double_doubles, text);
}

TEST_CASE("polynomials in time say what moving images are") {
    for (const char* text : problems) {
        CAPTURE(text);
        const Journey journey(text);
        const auto polynomials =
            incidences(journey.problem, straight_way(journey.scene.images, journey.to));
        const double time = 0.37;
        const auto moving =
            incidences(journey.problem, on_the_way(journey.scene.images, journey.to, time));
        REQUIRE(polynomials.size() == moving.size());
        const auto same = [&](const Polynomial& polynomial, const Moving& number) {
            CHECK(std::abs(value(polynomial, time) - number.value) < 1e-13);
            CHECK(std::abs(derivative(polynomial, time) - number.speed) < 1e-13);
        };
        for (std::size_t e = 0; e < moving.size(); ++e) {
            CHECK(polynomials[e].view == moving[e].view);
            for (std::size_t i = 0; i < 3; ++i) {
                same(polynomials[e].l[i], moving[e].l[i]);
                same(polynomials[e].x[i], moving[e].x[i]);
            }
            for (std::size_t k = 0; k < moving[e].depth.size(); ++k)
                same(polynomials[e].depth[k], moving[e].depth[k]);
        }
    }
}
