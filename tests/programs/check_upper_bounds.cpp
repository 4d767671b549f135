// Upper bounds on degrees for projective cameras: what plprove writes, plcheck replays; and what
// plcheck says of files that hold, that are altered, and together with files of solutions.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <sstream>

namespace {

const std::string bounds = certs + "solutions/projective-at-most.plc";

/// The file that FORMAT.md, section 15, shows.
std::string example_of_fixed_forms() {
    const std::string format = read_file(certs + "FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 at-most\n") + 1;
    return format.substr(start, format.find("```", start) - start);
}

/// The degrees that certs/family-degrees.csv calls certified by certificates.
std::map<std::string, int> degrees_by_certificates() {
    std::map<std::string, int> degrees;
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        if (line.starts_with("#") || !contains(line, "certificates; ")) continue;
        std::istringstream columns(line);
        std::string family, problem, degree;
        std::getline(columns, family, ',');
        std::getline(columns, problem, ',');
        std::getline(columns, degree, ',');
        degrees[problem] = std::stoi(degree);
    }
    return degrees;
}

/// The upper bounds of a file, as plcheck finds them.
std::map<std::string, int> bounds_of(const std::string& file) {
    const Outcome outcome = run(plcheck + " --json " + file);
    REQUIRE(outcome.status == 0);
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    std::map<std::string, int> found;
    for (const auto& record : report["files"][0]["upper_bounds"])
        found[record["problem"]] = record["certified_at_most"];
    return found;
}

} // namespace

TEST_CASE("the file of upper bounds in FORMAT.md holds, and is what plprove writes") {
    const TemporaryFolder folder;
    const std::string file = (folder / "six.plc").string();
    REQUIRE(run(plprove + " degree 'projective: 6*P/P/P' --at-most 1,2 -o " + file).status == 0);
    CHECK(read_file(file) == example_of_fixed_forms());
    const Outcome outcome = run("cd " + folder.path().string() + " && " + plcheck + " six.plc");
    CHECK(outcome.status == 0);
    CHECK(outcome.out ==
          "six.plc: 1 upper bound holds, 0 refused\n"
          "- projective: 6*P/P/P: certified at most 3 solutions, if it is minimal\n"
          "VERIFIED: at most 3 solutions of projective: 6*P/P/P, if it is minimal (six.plc)\n");
    CHECK(outcome.err.empty());
}

TEST_CASE("the committed upper bounds are the degrees on file that certificates make exact") {
    const std::map<std::string, int> expected = degrees_by_certificates();
    const std::map<std::string, int> found = bounds_of(bounds);
    CHECK(found.size() > 40);
    for (const auto& [problem, at_most] : found) {
        CAPTURE(problem);
        REQUIRE(expected.contains(problem));
        CHECK(at_most == expected.at(problem));
    }
    std::size_t of_large_files = 0;
    for (const std::string& line :
         lines_of(read_file(certs + "solutions/large/projective-at-most-large.plc")))
        of_large_files += line.starts_with("problem ");
    CHECK(found.size() + of_large_files == expected.size());
}

TEST_CASE("with a lower bound, an upper bound makes a degree exact, and --why names both") {
    const std::string expect =
        plcheck + " --why --quiet --expect 'projective: 3*PLab/PLab/PLab + Pa/Pa/Pa' --degree ";
    const std::string files =
        certs + "projective.plc " + certs + "solutions/projective.plc " + bounds;
    const Outcome six = run(expect + "6 " + files);
    CHECK(six.status == 0);
    CHECK(contains(six.out, "at most 6, by forms that vanish at all solutions: "
                            "proofs/fixed_forms.md"));
    CHECK(contains(six.out, "projective-at-most.plc"));
    const Outcome seven = run(expect + "7 " + files);
    CHECK(seven.status == 1);
    CHECK(contains(seven.out, "exactly 6 solutions are certified"));
    // Without the upper bound, six are certified at least.
    const Outcome without =
        run(expect + "6 " + certs + "projective.plc " + certs + "solutions/projective.plc");
    CHECK(without.status == 1);
    CHECK(contains(without.out, "at least 6 solutions are certified"));
}

TEST_CASE("--at-most is for projective cameras that all see everything") {
    const auto refusal = [](const std::string& problem) {
        const Outcome outcome = run(plprove + " degree '" + problem + "' --at-most 1,1");
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        return outcome.err;
    };
    CHECK(contains(refusal("3*P/P/P + a/a/a"), "write `projective:` in front"));
    CHECK(contains(refusal("5*P/P/P/P"), "only minimal"));
    CHECK(contains(refusal("5*P/P"), "write `projective:` in front"));
    CHECK(run(plprove + " degree 'projective: 6*P/P/P' --at-most 0,1").status == 3);
    CHECK(run(plprove + " degree 'projective: 6*P/P/P' --at-most 1").status == 3);
}

TEST_CASE("an altered file of upper bounds is refused with status 1 or 2") {
    const TemporaryFolder folder;
    const std::string file = (folder / "six.plc").string();
    const auto status_of = [&](const std::string& text) {
        write_file(file, text);
        return run(plcheck + " " + file).status;
    };
    CHECK(status_of(example_of_fixed_forms()) == 0);
    CHECK(status_of(with(example_of_fixed_forms(), "powers 1 2", "powers 1 1")) == 1);
    CHECK(status_of(with(example_of_fixed_forms(), "powers 1 2", "powers 1")) == 2);
    CHECK(status_of(with(example_of_fixed_forms(), "6*P/P/P", "7*P/P/P")) == 2);
    CHECK(status_of("plcert 2 at-most\n") == 1); // it conforms, and proves nothing
}
