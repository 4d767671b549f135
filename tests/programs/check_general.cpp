// plcheck asked about problems in general: what its statuses and its last line say of files that
// hold, that are altered, and that are something else.
#include "tests/support/programs.h"

#include <doctest/doctest.h>

TEST_CASE("the two families are replayed, and their numbers confirm those of the papers") {
    const Outcome both = run(plcheck + " " + certs + "plmp.plc " + certs + "projective.plc");
    CHECK(both.status == 0);
    CHECK(last_line(both.out).starts_with(
        "VERIFIED: all 39 problems of the family plmp, 30 minimal"));
    CHECK(!contains(both.out, "differs:"));
    CHECK(contains(both.out, "\n1021_1  > 450000  <= 186368    186368  differs, certified\n"));
    for (const std::string family : {"plmp", "projective"}) {
        const std::string command = plcheck + " --family " + family + " " + certs;
        CHECK(run(command + family + ".plc").status == 0);
        CHECK(run(command + "models/p3p.plc").status == 1);
    }
    CHECK(run(plcheck + " --family pl1p " + certs + "plmp.plc").status == 3);
}

TEST_CASE("what the prover writes of a problem in general, the checker verifies") {
    const TemporaryFolder folder;
    const std::string file = (folder / "one.plc").string();
    for (const auto& [problem, verdict] : {std::pair{"projective: 7*P/P", "minimal"},
                                           {"projective: 4*PL/PL + 3*P/P", "not-minimal"},
                                           {"projective: 8*P/P", "not-minimal"},
                                           {"PL/PL/PL + 2*PL/PL/P(a)", ""}}) {
        CAPTURE(problem);
        const std::string quoted = std::string(" '") + problem + "' ";
        const Outcome written = run(plprove + " certify" + quoted + "> " + file);
        if (std::string(verdict).empty()) {
            CHECK(written.status != 0);
            continue;
        }
        REQUIRE(written.status == 0);
        const std::string expect = plcheck + " --quiet --expect" + quoted + "--verdict ";
        CHECK(run(expect + verdict + " " + file).status == 0);
        CHECK(run(expect + "obstructed " + file).status == 1);
        CHECK(run(plcheck + " --expect 'projective: 6*P/P/P' --verdict minimal " + file).status ==
              1);
    }
}

TEST_CASE("an altered record is refused with status 1, an altered grammar with status 2") {
    const TemporaryFolder folder;
    const std::string archive = read_file(certs + "plmp.plc");
    const std::string file = (folder / "altered.plc").string();
    write_file(file, with(archive, "\nminimal 2", "\nminimal 1"));
    const Outcome refused = run(plcheck + " " + file);
    CHECK(refused.status == 1);
    CHECK(contains(refused.err, "altered.plc:4: refused: 5*P/P: the minor is 2"));
    CHECK(last_line(refused.out).starts_with("NOT VERIFIED: "));
    write_file(file, with(archive, "\nminimal 2", "\nmaximal 2"));
    CHECK(run(plcheck + " " + file).status == 2);
}
