// Minimal problems one feature away, by laws and by trying all changes.
#include "prover/minimal/hints.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>

using namespace plprove;

namespace {

std::set<std::size_t> labels(const std::vector<Hint>& list) {
    std::set<std::size_t> result;
    for (const Hint& hint : list) {
        REQUIRE(hint.decision.classes);
        CHECK(result.insert(hint.decision.classes->label).second);
    }
    return result;
}

bool is_minimal(const Signature& signature) {
    return obstruction(problem_of(signature)).deficiency() == 0;
}

std::size_t label_of(const Signature& signature) {
    return class_number(label_classes(), representative(signature));
}

int weight_of(const Signature& signature) {
    int sum = 0;
    for (const Feature& feature : problem_of(signature))
        sum += weight(feature);
    return sum;
}

/// The minimal classes among the signatures one exchange away.
std::set<std::size_t> minimal_after_an_exchange(const Signature& signature) {
    std::set<std::size_t> result;
    for (std::size_t from = 0; from < feature_count; ++from)
        for (std::size_t to = 0; to < feature_count; ++to) {
            if (signature[from] == 0 || from == to) continue;
            Signature other = signature;
            --other[from];
            ++other[to];
            if (weight_of(other) == camera_dimension && is_minimal(other))
                result.insert(label_of(other));
        }
    return result;
}

} // namespace

TEST_CASE("what a class lacks or has too much is named") {
    for (std::size_t number = 1; number < label_classes().size(); number += 1009) {
        const Signature& signature = label_classes()[number];
        if (!is_minimal(signature)) continue;
        CAPTURE(number);
        const Features whole = problem_of(signature);
        if (whole.size() < 2 || whole.size() >= most_features_with_hints) continue;
        const Features less(whole.begin() + 1, whole.end());
        CHECK(labels(hints(decide(less))).contains(number));
        for (const Feature& feature : {standard_features()[7], standard_features()[19]}) {
            Features more = whole;
            more.push_back(feature);
            CHECK(labels(hints(decide(more))).contains(number));
        }
    }
}

TEST_CASE("what obstructs is exchanged, and all exchanges that help are named") {
    int tried = 0;
    for (std::size_t number = 0; number < label_classes().size(); ++number) {
        const Signature& signature = label_classes()[number];
        if (is_minimal(signature) || ++tried % 50 != 0) continue;
        CAPTURE(number);
        CHECK(labels(hints(decide(problem_of(signature)))) == minimal_after_an_exchange(signature));
    }
    CHECK(tried == 2878);
}

TEST_CASE("a hint is one feature away, and its decision is that of the changed problem") {
    for (const char* text :
         {"3*P/P/P + P/P/a", "2*P/P/P + a/P/P + P/b/a", "3*P/P/P + a/a/a + a/-/-", "4*P/P", "6*P/P",
          "5*P/P + a/b", "Pabcdefgh/Pabcdefgh/Pabcdefgh + P/P/P", "6*P/P/- + 5*P/-/P"}) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const std::vector<Hint> list = hints(decide(problem));
        for (const Hint& hint : list) {
            CAPTURE(in_words(hint));
            Features before = problem;
            Features after = hint.decision.problem;
            if (hint.dropped) {
                CHECK(std::ranges::find(before, *hint.dropped) != before.end());
                after.push_back(*hint.dropped);
            }
            if (hint.added) before.push_back(*hint.added);
            std::ranges::sort(before);
            std::ranges::sort(after);
            CHECK(before == after);
            CHECK(decide(hint.decision.problem).verdict == hint.decision.verdict);
        }
    }
    const auto words = [](const char* text) {
        const std::vector<Hint> list = hints(decide(parse_features(text)));
        return list.empty() ? "none" : in_words(list.front());
    };
    CHECK(words("3*P/P/P + P/P/a") == "put Pa/P/a for P/P/a");
    CHECK(words("4*P/P") == "add P/P");
    CHECK(words("6*P/P") == "drop P/P");
    CHECK(words("3*P/P/P + a/a/a + a/-/-") == "drop a/-/-");
    CHECK(words("2*Pa/Pa/Pa + P/P/P") == "none"); // it is minimal
    CHECK(words("P/-/P") == "none");              // ten constraints are missing
}
