// Fibres in degree files (FORMAT.md, section 9): by the example there, and by known cameras.
#include "checker/conclusion/group.h"
#include "tests/checker/degrees/instances.h"
#include "tests/support/file.h"

using namespace checker;
using namespace instances;

namespace {
/// The records of a small file of certs/vectors.
std::string records_of(const std::string& name) {
    const std::string file = read(SOURCE_DIR "/certs/vectors/" + name);
    return file.substr(file.find('\n') + 1);
}

/// A fibre with the one solution of an instance: each coordinate is a residue.
std::string fibre_of(const RationalCameras& cameras) {
    std::string text = "fibre 1\n";
    const auto value = [](const Rational& x) {
        return residue(x.get_num()) * residue(x.get_den()).inverse();
    };
    text += say("polynomial ", (-value(cameras[0])).value, '\n');
    for (const Rational& x : cameras)
        text += say("unknown ", value(x).value, '\n');
    return text + "separated by 1 0 0 0 0 0 0 0 0 0 0\n";
}
} // namespace

TEST_CASE("the true cameras of scenes with each feature are fibres of one solution") {
    for (const std::size_t number : all_kinds()) {
        CAPTURE(number);
        const Instance instance = good_instance(number);
        const DegreeFile file = replayed(record(number, instance) + fibre_of(instance.cameras));
        REQUIRE(file.bounds.size() == 1);
        CHECK(file.bounds[0].solutions == 1);
        RationalCameras others = instance.cameras;
        for (std::size_t k = 1; k < others.size(); ++k) {
            others[k] += 1;
            const DegreeFile wrong = replayed(record(number, instance) + fibre_of(others));
            CHECK(wrong.bounds.empty());
            others[k] -= 1;
        }
    }
}

TEST_CASE("a fibre says what permutation it shows") {
    const DegreeFile file = replayed(records_of("degrees-fibre.plc"));
    REQUIRE(file.bounds.size() == 1);
    CHECK(file.bounds[0].number == chicago);
    REQUIRE(file.bounds[0].frobenius);
    CHECK(file.bounds[0].frobenius->solutions == 3);
    CHECK(file.bounds[0].frobenius->cycle == 3);
    CHECK(file.bounds[0].frobenius->even);
    const DegreeFile two = replayed(records_of("degrees-two-fibres.plc"));
    REQUIRE(two.bounds.size() == 2);
    CHECK(two.bounds[0].frobenius->cycle == 0);
    CHECK(two.bounds[1].frobenius->cycle == 3);
}

TEST_CASE("a fibre needs no Arb, and its lines are read to the letter") {
    const std::string good = records_of("degrees-fibre.plc");
    CHECK(violation(with(good, "fibre 3", "fibre 0")).starts_with("6: found `0`"));
    CHECK(violation(with(good, "fibre 3", "fibre 10001")).starts_with("6: found `10001`"));
    CHECK(violation(with(good, "polynomial", "unknown")).starts_with("7: found `unknown`"));
    CHECK(violation(with(good, "separated by 3", "separated by")).starts_with("19: found nothing"));
    CHECK(violation(with(good, "factor 3", "factor 4")).starts_with("20: found `4`"));
    CHECK(violation(with(good, "factor 3", "factor 2")).starts_with("20: found `"));
    CHECK(violation(good + "factor 1 0\n").starts_with("21: found `factor`"));
}

TEST_CASE("what is refused of images and fibres, and why") {
    CHECK(refusal(with(records_of("degrees-fibre.plc"), "2394", "2395"))
              .starts_with("2: class 2395: the images must be"));
    const std::vector<std::array<std::string, 2>> reasons{
        {"equation", "equation 1 is not 0"},
        {"separated", "the sum of `separated by` is not t"},
        {"multiple-root", "the polynomial has a multiple root"},
        {"no-factor", "the factor does not divide the polynomial"},
        {"reducible", "the factor is not irreducible, or its degree is no prime"},
        {"composite", "the factor is not irreducible, or its degree is no prime"}};
    for (const auto& [name, reason] : reasons)
        CHECK(refusal(records_of("degrees-fibre-" + name + ".plc")) == "2: class 2394: " + reason);
}

TEST_CASE("cycles and signs make groups") {
    const auto group = [](std::size_t degree, const std::vector<FrobeniusElement>& elements) {
        DegreeBounds bounds;
        bounds.theorem = exactly::Degree{};
        bounds.theorem->solutions = degree;
        bounds.frobenius = elements;
        return group_of(bounds);
    };
    const FrobeniusElement even{8, true, 0}, odd{8, false, 0}, cycle{5, true, 5};
    CHECK(group(8, {}).empty());
    CHECK(group(8, {even, odd}).empty());
    CHECK(group(8, {cycle}) == ">=A8");
    CHECK(group(8, {cycle, even}) == ">=A8");
    CHECK(group(8, {cycle, odd}) == ">=A8");
    CHECK(group(8, {odd, cycle, even}) == "S8");
    // Signs of some of the solutions say nothing, nor do cycles of less than half, or nearly all.
    CHECK(group(8, {cycle, even, {7, false, 0}}) == ">=A8");
    CHECK(group(10, {{10, true, 5}}).empty());
    CHECK(group(11, {{11, true, 7}}) == ">=A11");
    CHECK(group(9, {{9, true, 7}}).empty());
    CHECK(group_of(DegreeBounds{}).empty());
    CHECK(implies_group("S8", "S8"));
    CHECK(implies_group("S8", ">=A8"));
    CHECK(implies_group(">=A8", ">=A8"));
    CHECK_FALSE(implies_group(">=A8", "S8"));
    CHECK_FALSE(implies_group("S80", ">=A8"));
    CHECK_FALSE(implies_group("", "S8"));
}
