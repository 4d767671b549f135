// The program of proved verdicts, proofs/coq/plcoq, beside the checker and the prover: what Coq has
// proved of a problem, what the replayed certificates say, and what the prover decides.
// ./reproduce test runs this when plcoq is built.
#include "checker/replay.h"
#include "prover/minimal/problem_file.h"
#include "tests/support/all_classes.h"
#include "tests/support/program.h"
#include "tests/support/random_problems.h"

#include <chrono>
#include <iostream>

using namespace plprove;

namespace {

/// The answers of plcoq to these problems, without the problems.
std::vector<std::string> answers(const std::vector<std::string>& problems) {
    const TemporaryFolder folder;
    std::string input;
    for (const std::string& problem : problems)
        input += problem + "\n";
    write_file(folder / "problems", input);
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run(PLCOQ " <" + (folder / "problems").string());
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << "plcoq: " << problems.size() << " problems in " << time.count() << " s\n";
    REQUIRE(outcome.status <= 1);
    std::vector<std::string> lines = lines_of(outcome.out);
    REQUIRE(lines.size() == problems.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string::size_type colon = lines[i].find(": ");
        REQUIRE(lines[i].substr(colon + 2) == problems[i]);
        lines[i].resize(colon);
    }
    return lines;
}

/// Has the checker replay a certificate of the verdict. Returns the verdict's first word.
std::string replayed_verdict(const Features& problem) {
    const checker::ReplayedFile replayed =
        checker::replay(all_classes(), "test", write(certify_problem(problem)));
    const auto& file = std::get<checker::ProblemFile>(replayed.content);
    return file.verdict.substr(0, file.verdict.find(' '));
}

/// Adds to points, and beside them, what two views determine: problems that are not reduced, and
/// minimal if the others are.
void add_determined(Features& problem, RandomProblems& random) {
    for (Feature& feature : problem) {
        if (!feature.has_point || random.below(3) > 0) continue;
        std::vector<Sight*> seeing;
        for (Sight& sight : feature.sights)
            if (sight.point) seeing.push_back(&sight);
        if (seeing.size() < 2) continue;
        random.shuffle(seeing);
        for (std::size_t i = 0; i < 2; ++i)
            seeing[i]->pins |= 1U << feature.lines;
        ++feature.lines;
    }
    for (int more = random.below(3); more > 0; --more) {
        // a/a/-, Pa/a/- and Pa/a/a, in any order of the views
        Feature extra = random.below(2) == 0
                            ? Feature{false, 1, {{false, 1}, {false, 1}, {}}}
                            : Feature{true, 1, {{true, 1}, {false, 1}, {false, 0}}};
        if (extra.has_point && random.below(2) == 0) extra.sights[2].pins = 1;
        random.shuffle(extra.sights);
        problem.push_back(extra);
    }
}

Features any_problem(RandomProblems& random) {
    Features problem;
    switch (random.below(3)) {
    case 0:
        for (int size = 1 + random.below(9); size > 0; --size)
            problem.push_back(random.feature(3, 9));
        break;
    case 1:
        problem = random.around_a_class(random.below(4));
        break;
    default:
        problem = random.around_a_class(0);
        add_determined(problem, random);
    }
    return random.disguised(problem);
}

} // namespace

TEST_CASE("plcoq and the replayed certificates agree on all label classes") {
    const std::string file = read_file(CERTS_DIR "/classification.plc");
    const checker::ReplayedFile replayed = checker::replay(all_classes(), "test", file);
    const auto& proved = std::get<checker::ClassificationFile>(replayed.content).verdicts;
    REQUIRE(proved.size() == 143494);
    std::vector<std::string> problems;
    for (const checker::ClassVerdict& verdict : proved)
        problems.push_back(checker::notation(all_classes().representatives[verdict.number]));
    const std::vector<std::string> said = answers(problems);
    for (std::size_t i = 0; i < said.size(); ++i) {
        const bool minimal = proved[i].obstruction.minimal();
        if (said[i] != (minimal ? "minimal" : "not minimal (obstructed)")) FAIL(problems[i]);
    }
}

TEST_CASE("plcoq, the prover and the checker agree on random problems") {
    const char* given = std::getenv("SEED");
    const unsigned seed = given ? static_cast<unsigned>(std::stoul(given)) : 2026;
    std::cout << "SEED=" << seed << '\n';
    RandomProblems random(seed);
    std::vector<std::string> problems;
    std::vector<Features> features;
    while (problems.size() < 10000) {
        features.push_back(any_problem(random));
        problems.push_back(notation(features.back()));
    }
    const std::vector<std::string> said = answers(problems);
    std::map<std::string, int> times;
    for (std::size_t i = 0; i < said.size(); ++i) {
        CAPTURE(problems[i]);
        ++times[said[i]];
        const Verdict verdict = decide(features[i]).verdict;
        if (said[i].starts_with("no verdict")) continue;
        CHECK((said[i] == "minimal") == (verdict == Verdict::minimal));
        if (i % 20 == 0) CHECK(replayed_verdict(features[i]) == name(verdict));
    }
    for (const auto& [answer, count] : times)
        std::cout << "  " << answer << ": " << count << '\n';
    for (const char* answer : {"minimal", "not minimal (unbalanced)", "not minimal (obstructed)"})
        CHECK(times[answer] > 20);
}

TEST_CASE("plcoq reads no more and no less than the notation") {
    for (const char* text : {"",
                             "P/P",
                             "P/P/P/P",
                             "-/-/-",
                             "P/P/p",
                             "P/Pb/P",
                             "Pba/P/P",
                             "Paa/P/P",
                             "ab/P/P",
                             "aP/P/P",
                             "P /P/P",
                             "P/P/P +",
                             "+ P/P/P",
                             "0*P/P/P",
                             "02*P/P/P",
                             "1001*P/P/P",
                             "99999999999999999999*P/P/P",
                             "-1*P/P/P",
                             "2**P/P/P",
                             "2P/P/P",
                             "PL/PL/PL",
                             "P/P/P()",
                             "P/P/P(P)",
                             "P/P/P(b)",
                             "P/P/P(a",
                             "P/P/P(a)(a)",
                             "a/b/-(P)",
                             "projective: 7*P/P/P"}) {
        CAPTURE(text);
        const Outcome outcome = run(PLCOQ " '" + std::string(text) + "'");
        CHECK(outcome.status == 2);
        CHECK(outcome.out.starts_with("not read"));
    }
    CHECK(run(PLCOQ " '2*P/P/P + a/Pa/Pa + a/a/a' ' 2 * P/P/P+Pa/a/Pa+a/a/a '").out ==
          "minimal: 2*P/P/P + a/Pa/Pa + a/a/a\nminimal:  2 * P/P/P+Pa/a/Pa+a/a/a \n");
    CHECK(run(PLCOQ " '1000*P/P/P(a)' '-/-/-(ab)' '-/-/-(P)' 'a/b/-' 'a/a/a(P)'").status == 0);
    CHECK(run(PLCOQ " --no-such-option").status == 3);

    std::string large = "1000*P/P/P";
    for (int i = 0; i < 1000; ++i)
        large += " + 1000*P/P/P";
    const TemporaryFolder folder;
    write_file(folder / "problem", large + "\n");
    CHECK(run(PLCOQ " <" + (folder / "problem").string()).status <= 1);
}

TEST_CASE("plcoq counts what the theorem says") {
    const Outcome outcome = run(PLCOQ " --counts");
    std::vector<std::string> numbers;
    for (const std::string& line : lines_of(outcome.out))
        numbers.push_back(line.substr(line.rfind(' ') + 1));
    CHECK(numbers == std::vector<std::string>{"143494", "76446", "140616", "2878", "74575", "1871",
                                              "51", "9533", "6413", "3615"});
}
