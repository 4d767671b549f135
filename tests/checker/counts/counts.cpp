// Counts of classes: sums that must agree, what is counted without certificates, and that the
// paper's numbers are about these counts.
#include "checker/counts/families.h"
#include "checker/paper/numbers.h"
#include "tests/support/all_classes.h"

#include <set>

using namespace checker;

namespace {

/// The counts by name, if all classes are certified.
const std::map<std::string_view, std::size_t>& counted() {
    static const std::map<std::string_view, std::size_t> counts = [] {
        std::map<std::string_view, std::size_t> all;
        for (const Count& count : count_classes(all_classes(), all_verdicts()))
            all[count.name] = count.certified.value();
        return all;
    }();
    return counts;
}

} // namespace

TEST_CASE("each count has a name of its own, and the paper's names are among them") {
    const std::vector<Count> counts = count_classes(all_classes(), all_verdicts());
    CHECK(counts.size() == counted().size());
    std::set<std::string_view> claimed;
    for (const paper::ClaimedCount& claim : paper::claimed_counts) {
        CAPTURE(claim.name);
        CHECK(counted().contains(claim.name));
        CHECK(claimed.insert(claim.name).second);
    }
}

TEST_CASE("counts agree with the paper, but for those that are explained, which are as explained") {
    for (const paper::ClaimedCount& claim : paper::claimed_counts) {
        CAPTURE(claim.name);
        const bool explained = claim.certified_instead > 0;
        CHECK(counted().at(claim.name) == (explained ? claim.certified_instead : claim.claimed));
        CHECK(explained == !claim.why.empty());
        CHECK(explained == !claim.counted.empty());
        CHECK(claim.certified_instead != claim.claimed);
    }
}

TEST_CASE("parts add up") {
    const auto count = [](std::string_view name) { return counted().at(name); };
    CHECK(count("balanced signatures") == 845161);
    CHECK(count("label classes, minimal") + count("label classes, not minimal") ==
          count("label classes"));
    CHECK(count("terminal camera-minimal") + count("swap&label classes, not minimal") ==
          count("swap&label classes"));
    CHECK(count("not minimal: epipolar excess, E > 0") +
              count("not minimal: a star alone, S = 1, E = 0") ==
          count("label classes, not minimal"));
    CHECK(count("not minimal: both, S = 1, E > 0") < count("not minimal: epipolar excess, E > 0"));
    const std::size_t linear = count("terminal, on Kileel's list (linear in the trifocal tensor)");
    const std::size_t linear_minimal = count("- of these, minimal");
    const std::size_t linear_complete = count("- - with complete visibility");
    CHECK(linear == 66);
    CHECK(linear_minimal == 16);
    CHECK(linear == linear_minimal + count("- of these, not minimal"));
    CHECK(linear_complete == 2);
    CHECK(linear_minimal == linear_complete + count("- - with partial visibility"));
    const std::size_t either = count("terminal, completely visible or on Kileel's list");
    CHECK(either == linear + count("minimal, complete visibility") - linear_complete);
    CHECK(either == 76);
    CHECK(either + count("terminal, neither") == count("terminal camera-minimal"));
}

TEST_CASE("without certificates only the enumeration is certified") {
    const Verdicts none(all_classes().representatives.size());
    for (const Count& count : count_classes(all_classes(), none)) {
        CAPTURE(count.name);
        const bool enumerated = count.name == "balanced signatures" ||
                                count.name == "label classes" || count.name == "swap&label classes";
        CHECK(count.certified.has_value() == enumerated);
        if (enumerated) CHECK(count.certified == counted().at(count.name));
    }
}

TEST_CASE("one class without a certificate leaves all counts open that need it") {
    for (const std::size_t number : {std::size_t{0}, std::size_t{70000}, std::size_t{143493}}) {
        Verdicts verdicts = all_verdicts();
        verdicts[number].reset();
        std::size_t certified = 0;
        for (const Count& count : count_classes(all_classes(), verdicts))
            certified += count.certified.has_value();
        CHECK(certified == 3);
        CHECK_FALSE(is_minimal(verdicts, number));
    }
}

TEST_CASE("a class is proved minimal by its verdict alone") {
    Verdicts verdicts(2);
    verdicts[0] = Obstruction{};
    CHECK(is_minimal(verdicts, 0));
    CHECK_FALSE(is_minimal(verdicts, 1));
    verdicts[0]->star = 1;
    CHECK_FALSE(is_minimal(verdicts, 0));
    verdicts[1] = Obstruction{.excess = {0, 1, 0}};
    CHECK_FALSE(is_minimal(verdicts, 1));
}

TEST_CASE("the paper's examples are minimal classes, by the notation of their representatives") {
    const auto is_example = [](const paper::ClaimedDegree& claim) {
        const std::size_t number = class_of(claim.problem);
        CAPTURE(claim.problem);
        CHECK(is_minimal(all_verdicts(), number));
        CHECK(all_classes().represents_swap_class(number));
        return all_classes().representatives[number];
    };
    is_example(paper::example);
    std::set<Signature> pl0ps, registrations;
    for (const paper::ClaimedDegree& claim : paper::pl0ps)
        CHECK(pl0ps.insert(is_example(claim)).second);
    for (const paper::ClaimedDegree& claim : paper::registrations)
        CHECK(registrations.insert(is_example(claim)).second);
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        const bool minimal = is_minimal(all_verdicts(), n);
        REQUIRE(pl0ps.contains(s) == (minimal && is_pl0p(s)));
        REQUIRE(registrations.contains(s) == (minimal && is_pl0p(s) && is_registration(s)));
    }
}

TEST_CASE("the problems with complete visibility have the names of PLMP") {
    std::set<std::string> found;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        if (is_minimal(all_verdicts(), n) && completely_visible(s))
            CHECK(found.insert(plmp_name(s)).second);
    }
    const auto& claimed = paper::complete_visibility;
    CHECK(found == std::set<std::string>(claimed.begin(), claimed.end()));
    CHECK(plmp_name(all_classes().representatives[2394]) == "3002_1");
    CHECK(plmp_name(all_classes().representatives[6722]) == "3010_0");
}
