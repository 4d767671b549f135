// What may be added to a minimal problem: each larger problem is decided, and all changes are
// tried.
#include "prover/minimal/extensions.h"

#include "prover/minimal/decision.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

std::vector<std::string> words(const std::string& problem) {
    std::vector<std::string> result;
    for (const Change& extension : extensions(parse_features(problem)))
        result.push_back(in_words(extension));
    std::ranges::sort(result);
    return result;
}

/// All symbols that a view may have of a point with `pins` pins.
std::vector<std::string> symbols(bool has_point, int pins) {
    std::vector<std::string> result{"-"};
    for (std::uint32_t set = 0; set < 1U << pins; ++set) {
        std::string letters;
        for (int pin = 0; pin < pins; ++pin)
            if ((set >> pin & 1U) != 0) letters += static_cast<char>('a' + pin);
        if (letters.size() == 1) result.push_back(letters);
        if (has_point) result.push_back("P" + letters);
    }
    return result;
}

} // namespace

TEST_CASE("extensions are minimal, and of the same class") {
    for (const char* text : {"2*Pa/Pa/Pa + P/P/P", "3*P/P/P + a/a/a", "P/P/P + 4*a/a/a", "5*P/P",
                             "3*P/P/P + 2*P/a/a", "P/P/P + Pabcde/Pabcde/Pabcde"}) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Decision before = decide(problem);
        REQUIRE(before.verdict == Verdict::minimal);
        for (const Change& extension : extensions(problem)) {
            CAPTURE(in_words(extension));
            const Features larger = changed(problem, extension);
            CHECK(larger.size() == problem.size() + (extension.dropped ? 0 : 1));
            const Decision after = decide(larger);
            CHECK(after.verdict == Verdict::minimal);
            CHECK(after.space_dimension > before.space_dimension);
            CHECK(notation(after.terminal) == notation(before.terminal));
        }
    }
}

TEST_CASE("of all free lines, points, and points with a pin, these may be added") {
    std::vector<std::string> minimal;
    for (const auto& [has_point, pins] : {std::pair{false, 1}, {true, 0}, {true, 1}}) {
        const std::vector<std::string> all = symbols(has_point, pins);
        for (const std::string& first : all)
            for (const std::string& second : all)
                for (const std::string& third : all) {
                    const std::string feature = first + "/" + second + "/" + third;
                    if (feature == "-/-/-") continue;
                    const Decision decision =
                        decide(parse_features("2*Pa/Pa/Pa + P/P/P + " + feature));
                    if (decision.verdict == Verdict::minimal) minimal.push_back("add " + feature);
                }
    }
    std::ranges::sort(minimal);
    minimal.erase(std::ranges::unique(minimal).begin(), minimal.end());
    std::vector<std::string> added = words("2*Pa/Pa/Pa + P/P/P");
    std::erase_if(added, [](const std::string& word) { return word.starts_with("put"); });
    CHECK(added == minimal);
}

TEST_CASE("a point gets a pin that two views see, a free line a point that one view sees") {
    const std::vector<std::string> found = words("3*P/P/P + a/a/a");
    for (const char* expected :
         {"put P/Pa/Pa for P/P/P", "put Pa/P/Pa for P/P/P", "put Pa/Pa/P for P/P/P",
          "put Pa/a/a for a/a/a", "put a/Pa/a for a/a/a", "put a/a/Pa for a/a/a"})
        CHECK(std::ranges::count(found, expected) == 1);
    CHECK(std::ranges::count_if(
              found, [](const std::string& word) { return word.starts_with("put"); }) == 6);
}
