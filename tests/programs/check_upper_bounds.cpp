// Upper bounds on degrees for projective cameras: what plprove writes, plcheck replays; and what
// plcheck says of files that hold, that are altered, and together with files of solutions.
#include "tests/support/programs.h"

#include <doctest/doctest.h>

namespace {

/// The file that FORMAT.md, section 15, shows.
std::string example_of_fixed_forms() {
    const std::string format = read_file(certs + "FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 at-most\n") + 1;
    return format.substr(start, format.find("```", start) - start);
}

/// Of a file in certs/ the record of one problem, as a file of its own.
std::string record_of(const std::string& problem, const std::string& file) {
    const std::string text = read_file(certs + file);
    const std::size_t start = text.find("\nproblem " + problem + "\n") + 1;
    REQUIRE(start > 0);
    const std::size_t end = text.find("\nproblem ", start);
    return text.substr(0, text.find('\n') + 1) + text.substr(start, end + 1 - start);
}

/// What plcheck says of a degree that someone expects.
Outcome expect_degree(const std::string& problem, const std::string& degree,
                      const std::string& files) {
    return run(plcheck + " --why --quiet --expect '" + problem + "' --degree '" + degree + "' " +
               files);
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

TEST_CASE("with a lower bound, an upper bound makes a degree exact, and --why names both") {
    const std::string problem = "projective: 3*PLab/PLab/PLab + Pa/Pa/Pa";
    const TemporaryFolder folder;
    for (const std::string name : {"projective.plc", "projective-at-most.plc"})
        write_file(folder / name, record_of(problem, "solutions/" + name));
    const std::string expect = "cd " + folder.path().string() + " && " + plcheck +
                               " --why --quiet --expect '" + problem + "' --degree ";
    const std::string files = certs + "projective.plc projective.plc ";
    const Outcome six = run(expect + "6 " + files + "projective-at-most.plc");
    CHECK(six.status == 0);
    CHECK(contains(six.out, "at most 6, by forms that vanish at all solutions: "
                            "proofs/fixed_forms.md"));
    CHECK(contains(six.out, "projective-at-most.plc"));
    const Outcome seven = run(expect + "7 " + files + "projective-at-most.plc");
    CHECK(seven.status == 1);
    CHECK(contains(seven.out, "exactly 6 solutions are certified"));
    // Without the upper bound, six are certified at least.
    const Outcome without = run(expect + "6 " + files);
    CHECK(without.status == 1);
    CHECK(contains(without.out, "at least 6 solutions are certified"));
}

TEST_CASE("six points that two views share make the degree exact, of a problem proved minimal") {
    const std::string problem = "shared-focal: P/P/P + 2*a/P/Pa + 5*P/-/P";
    const TemporaryFolder folder;
    const std::string file = (folder / "mine.plc").string();
    REQUIRE(run(plprove + " problem '" + problem + "' --certificate " + file).status == 0);
    const auto expect = [&](const std::string& degree, const std::string& files) {
        return expect_degree(problem, degree, files);
    };
    for (const char* right : {"240", ">=240", ">=239"}) {
        CAPTURE(right);
        CHECK(expect(right, file).status == 0);
    }
    CHECK(contains(expect("240", file).out, "exactly 240, by Theorem W"));
    for (const char* wrong : {"239", "241", ">=241"}) {
        CAPTURE(wrong);
        const Outcome refused = expect(wrong, file);
        CHECK(refused.status == 1);
        CHECK(contains(refused.out, "exactly 240 solutions are certified"));
    }
    // Other files do not prove that the problem is minimal.
    const Outcome unproved = expect("240", certs + "classification.plc");
    CHECK(unproved.status == 1);
    CHECK(!contains(unproved.out, "Theorem W"));
}

TEST_CASE("valuations make the degree exact of three views whose verticals are known") {
    const std::string problem = "upright: 3*-/P/P + 3*P/-/P + P/P/-";
    const TemporaryFolder folder;
    const std::string file = (folder / "mine.plc").string();
    const Outcome made = run(plprove + " problem '" + problem + "' --certificate " + file);
    CHECK(contains(made.out, "16 certified: by Theorem D"));
    const auto expect = [&](const std::string& degree) {
        return expect_degree(problem, degree, file);
    };
    CHECK(expect("16").status == 0);
    CHECK(contains(expect("16").out, "exactly 16, by Theorem D of proofs/upright_views.md"));
    for (const char* wrong : {"15", "17", ">=17"}) {
        CAPTURE(wrong);
        CHECK(expect(wrong).status == 1);
    }
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
