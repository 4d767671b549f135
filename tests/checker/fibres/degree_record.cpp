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

TEST_CASE("two fibres of a class say what permutations they show") {
    const DegreeFile file = replayed(records_of("degrees-fibre.plc"));
    REQUIRE(file.bounds.size() == 1);
    CHECK(file.bounds[0].number == chicago);
    CHECK(file.bounds[0].solutions == 3);
    CHECK(file.bounds[0].cycle_types.empty());
    const DegreeFile two = replayed(records_of("degrees-two-fibres.plc"));
    REQUIRE(two.bounds.size() == 2);
    CHECK(two.bounds[0].cycle_types.empty());
    CHECK(two.bounds[1].cycle_types == std::vector<CycleType>{{3}, {3}});
}

TEST_CASE("a fibre needs no Arb, and its lines are read to the letter") {
    const std::string good = records_of("degrees-fibre.plc");
    CHECK(violation(with(good, "fibre 3", "fibre 0")).starts_with("6: found `0`"));
    CHECK(violation(with(good, "fibre 3", "fibre 10001")).starts_with("6: found `10001`"));
    CHECK(violation(with(good, "polynomial", "unknown")).starts_with("7: found `unknown`"));
    CHECK(violation(with(good, "separated by 3", "separated by")).starts_with("19: found nothing"));
    CHECK(violation(good + "factor 1 0\n").starts_with("20: found `factor`"));
}

TEST_CASE("what is refused of images and fibres, and why") {
    CHECK(refusal(with(records_of("degrees-fibre.plc"), "2394", "2395"))
              .starts_with("2: class 2395: the images must be"));
    const std::vector<std::array<std::string, 2>> reasons{
        {"equation", "equation 1 is not 0"},
        {"separated", "the sum of `separated by` is not t"},
        {"multiple-root", "the polynomial has a multiple root"}};
    for (const auto& [name, reason] : reasons)
        CHECK(refusal(records_of("degrees-fibre-" + name + ".plc")) == "2: class 2394: " + reason);
}

TEST_CASE("a group needs the degree, and permutations of all solutions") {
    const std::vector<CycleType> cycle_types{{8}, {3, 5}};
    DegreeBounds bounds{.at_least = 8, .cycle_types = cycle_types};
    CHECK(group_of(bounds).empty());
    bounds.at_most = UpperBound{9, {}};
    CHECK(group_of(bounds).empty());
    bounds.at_most = UpperBound{8, {}};
    CHECK(group_of(bounds) == "S8");
    bounds.cycle_types.pop_back();
    CHECK(group_of(bounds).empty());
    bounds = {.at_least = 9, .at_most = UpperBound{9, {}}, .cycle_types = cycle_types};
    CHECK(group_of(bounds).empty());
    CHECK(group_of(DegreeBounds{}).empty());
}

TEST_CASE("a group may be more than is expected") {
    CHECK(implies_group("S8", "S8"));
    CHECK(implies_group("S8", ">=A8"));
    CHECK(implies_group(">=A8", ">=A8"));
    CHECK_FALSE(implies_group(">=A8", "S8"));
    CHECK_FALSE(implies_group("S80", ">=A8"));
    CHECK_FALSE(implies_group("", "S8"));
}
