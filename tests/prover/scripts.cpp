// Scripts for Macaulay2 and Julia: what they state and declare, and what Macaulay2 says to them.
#include "prover/scripts/scripts.h"
#include "prover/minimal/block.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <sstream>

using namespace plprove;

namespace {

const std::vector<std::string> samples{
    "2*Pa/Pa/Pa + P/P/P",
    "Pabcdefg/Pabcdefg/Pabcdefg + P/a/a",
    "Pab/b/a + a/P/Pa + 3*P/P/P",
    "11*P/P/-",
    "5*P/P",
    "P/P/P + 4*a/a/a",
    "2*Pa/Pa/Pa + Pab/Pa/P + -/-/a + a/b/c + P/P/P(a) + -/-/-(P)",
    "Pabcdefghijklmnopqrstuvwxyz/Pabcdefghijklmnopqrstuvwxyz + 20*a/a",
};

struct Counts {
    int equations = 0;
    int feature_unknowns = 0;
    int camera_unknowns = 0;
    int unknowns() const { return feature_unknowns + camera_unknowns; }
};

Counts count(const Features& problem) {
    Counts counts;
    for (const Feature& feature : problem) {
        counts.equations += weight(feature) + dimension_in_space(feature);
        counts.feature_unknowns += dimension_in_space(feature);
    }
    counts.camera_unknowns = calibrated_cameras.dimension(problem.front().views());
    return counts;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    REQUIRE(from != std::string::npos);
    const std::size_t to = text.find(end, from + begin.size());
    REQUIRE(to != std::string::npos);
    return text.substr(from + begin.size(), to - from - begin.size());
}

/// The text without comments that begin with `sign`.
std::string without_comments(const std::string& text, const std::string& sign) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);)
        result += line.substr(0, line.find(sign)) + "\n";
    return result;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> result;
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        result.push_back((*i)[i->size() - 1]);
    return result;
}

std::set<std::string> as_set(const std::vector<std::string>& list) {
    return {list.begin(), list.end()};
}

void check_brackets(const std::string& text) {
    std::string open;
    for (const char c : text) {
        if (std::string("([{").find(c) != std::string::npos) open += c;
        if (const std::size_t kind = std::string(")]}").find(c); kind != std::string::npos) {
            REQUIRE(!open.empty());
            CHECK(open.back() == "([{"[kind]);
            open.pop_back();
        }
    }
    CHECK(open.empty());
}

/// The generic rank of J, and of its columns of the features, by plprove's own Jacobian at a random
/// point.
std::array<slong, 2> ranks(const Features& problem) {
    std::mt19937 random(1);
    const auto coordinate = [&] { return static_cast<std::int64_t>(random() % 199) - 99; };
    const auto vector = [&] { return Vector3{coordinate(), coordinate(), coordinate()}; };
    Cameras cameras(problem.front().sights.size() - 1);
    do
        for (Camera& camera : cameras)
            camera = {{coordinate(), coordinate(), coordinate(), coordinate()}, vector()};
    while (defect(cameras));
    std::vector<FeatureBlock> blocks;
    for (const Feature& feature : problem) {
        PlacedFeature placed{feature, {}, {}};
        do {
            placed.point = vector();
            placed.directions.clear();
            for (int line = 0; line < feature.lines; ++line)
                placed.directions.push_back(vector());
        } while (defect(placed, cameras));
        blocks.push_back(feature_block(placed, cameras));
    }
    const ResidueMatrix j = jacobian(pointers(blocks));
    ResidueMatrix own(j.rows(), count(problem).feature_unknowns);
    for (int row = 0; row < own.rows(); ++row)
        for (int column = 0; column < own.columns(); ++column)
            own.at(row, column) = j.at(row, column);
    return {nmod_mat_rank(j.get()), nmod_mat_rank(own.get())};
}

} // namespace

TEST_CASE(
    "the Macaulay2 script has the equations and unknowns of the dimension counts, all declared") {
    for (const std::string& text : samples) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Counts counts = count(problem);
        const std::string script = macaulay2_script(problem);
        CHECK(script == macaulay2_script(problem));
        CHECK(script.starts_with("-- The point-line problem "));
        const std::string code = without_comments(script, "--");
        check_brackets(code);

        const auto unknowns = matches(between(code, "R = FF[", "]"), "[a-z0-9]+");
        CHECK(unknowns.size() == static_cast<std::size_t>(counts.unknowns()));
        CHECK(as_set(unknowns).size() == unknowns.size());
        const std::string stated =
            "featureUnknowns = " + std::to_string(counts.feature_unknowns) + ";";
        CHECK(code.find(stated) != std::string::npos);

        const std::string equations = between(code, "equations = flatten {", "};");
        const auto points = matches(equations, "seesPoint\\(").size();
        const auto pins = matches(equations, "seesPin\\(").size();
        const auto lines = matches(equations, "seesLine\\(").size();
        CHECK(2 * points + pins + 2 * lines == static_cast<std::size_t>(counts.equations));

        // Each unknown stands in one of the vectors and cameras, and the equations use what is
        // defined.
        const auto used = matches(code, "\\b([abcefguvxyz][0-9]+[a-z]?)\\b");
        for (const std::string& unknown : unknowns) {
            CAPTURE(unknown);
            CHECK(std::ranges::count(used, unknown) == 2);
        }
        const auto defined = as_set(matches(code, "\\b([XDP][0-9]+[a-z]?) = "));
        for (const std::string& name : matches(equations, "\\b[XDP][0-9]+[a-z]?\\b"))
            CHECK(defined.contains(name));
    }
}

TEST_CASE("the Julia script has the equations and unknowns of the dimension counts, all declared") {
    for (const std::string& text : samples) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Counts counts = count(problem);
        const std::string script = julia_script(problem);
        CHECK(script == julia_script(problem));
        CHECK(script.starts_with("# The point-line problem "));
        const std::string equations_and_unknowns = std::to_string(counts.equations) +
                                                   " equations in " +
                                                   std::to_string(counts.unknowns()) + " unknowns";
        CHECK(std::regex_replace(script, std::regex("\n# "), " ").find(equations_and_unknowns) !=
              std::string::npos);
        const std::string code = without_comments(script, "#");
        check_brackets(code);
        CHECK(matches(code, "(^|\n)function ").size() == matches(code, "(^|\n)end\n").size());
        const std::string declared = "@var z[1:" + std::to_string(counts.unknowns()) +
                                     "] p[1:" + std::to_string(counts.equations) + "]";
        CHECK(code.find(declared) != std::string::npos);

        // Each unknown stands in one vector or camera.
        const std::string world = between(code, "function world(z)", "\nend");
        std::set<int> indices;
        const auto used = matches(world, "z\\[([0-9]+)\\]");
        for (const std::string& index : used)
            indices.insert(std::stoi(index));
        CHECK(used.size() == static_cast<std::size_t>(counts.unknowns()));
        CHECK(indices.size() == used.size());
        CHECK(*indices.begin() == 1);
        CHECK(*indices.rbegin() == counts.unknowns());

        // Images and equations go together; the last argument of an equation is its own parameters.
        const std::string images = between(code, "function images(z)", "\nend");
        const std::string equations = between(code, "function equations(z, p)", "\nend");
        CHECK(matches(images, "([a-z]+)_image\\(") == matches(equations, "([a-z]+)_equations\\("));
        int next = 1;
        for (const std::string& range : matches(equations, "p\\[([0-9:]+)\\]\\)")) {
            const std::size_t colon = range.find(':');
            CHECK(std::stoi(range) == next);
            next = 1 + std::stoi(colon == std::string::npos ? range : range.substr(colon + 1));
        }
        CHECK(next == counts.equations + 1);

        const auto defined = as_set(matches(world, "\\b([XDP][0-9]+[a-z]?) = "));
        for (const std::string& part : {images, equations}) {
            const auto unpacked =
                as_set(matches(between(part, "(\n", ") = world(z)"), "[A-Z][0-9a-z]+"));
            CHECK(unpacked == defined);
            for (const std::string& name : matches(part, "\\b[XDP][0-9]+[a-z]?\\b"))
                CHECK(unpacked.contains(name));
        }
    }
}

TEST_CASE("where no view sees anything the scripts are comments") {
    const Features problem = parse_features("2*-/-/-(Pa)");
    CHECK(matches(without_comments(macaulay2_script(problem), "--"), "\\S").empty());
    CHECK(matches(without_comments(julia_script(problem), "#"), "\\S").empty());
}

TEST_CASE("Macaulay2 finds the ranks that plprove's own Jacobian has, and the known verdicts") {
    if (run("command -v M2").status != 0) {
        MESSAGE("skipped: there is no program M2 on the PATH");
        return;
    }
    struct Verdict {
        bool minimal, camera_minimal;
    };
    const std::map<std::string, Verdict> problems{
        {"2*Pa/Pa/Pa + P/P/P", {true, true}},
        {"2*Pa/Pa/Pa + Pab/Pa/P", {false, true}}, // the pin dangles
        {"2*Pab/Pa/Pa + P/P/P + a/-/-", {false, true}},
        {"3*P/P/P + a/a/a", {true, true}},
        {"P/P/P + 4*a/a/a", {true, true}},
        {"Pabcdefg/Pabcdefg/Pabcdefg + P/a/a", {false, false}},
        {"11*P/P/-", {false, false}},
        {"5*P/P", {true, true}},
        {"6*P/P", {false, false}},
        {"5*P/P + 3*a/a", {true, true}},
        {"5*P/P + a/-", {false, true}},
        {"Pa/P/P + 2*-/a/a + P/P/P(a)", {false, false}},
    };
    const TemporaryFolder folder;
    const auto path = folder / "problem.m2";
    for (const auto& [text, verdict] : problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Counts counts = count(problem);
        const auto [rank, own] = ranks(problem);
        write_file(path, macaulay2_script(problem));
        const Outcome outcome = run("M2 --script " + path.string());
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        const auto yes = [](bool value) { return value ? "yes" : "no"; };
        std::ostringstream expected;
        expected << "equations        " << counts.equations << "\nunknowns         "
                 << counts.unknowns() << " (" << counts.feature_unknowns << " of features, "
                 << counts.camera_unknowns << " of cameras)\nrank             " << rank << " ("
                 << own << " of the feature columns)\nminimal          " << yes(verdict.minimal)
                 << "\ncamera-minimal   " << yes(verdict.camera_minimal) << "\n";
        CHECK(outcome.out == expected.str());
    }
}
