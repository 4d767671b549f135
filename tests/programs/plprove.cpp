// plprove as its users run it.
#include "tests/support/programs.h"

#include <doctest/doctest.h>

TEST_CASE("the committed archive is what plprove writes, byte for byte") {
    const TemporaryFolder folder;
    const auto path = folder / "all.plc";
    const Outcome outcome = run(plprove + " classification -o " + path.string());
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    const bool same = read_file(path) == read_file(certs + "classification.plc");
    CHECK(same);
    CHECK(std::filesystem::file_size(path) <= 8'000'000);
}

TEST_CASE("the digests are those of the committed archives") {
    CHECK(run("cd " SOURCE_DIR "/certs && sha256sum --check --strict SHA256SUMS").status == 0);
}

TEST_CASE("a problem certified by itself is accepted by the checker") {
    const TemporaryFolder folder;
    for (const char* id : {"0", "2394", "'#6722'", "143493", "19", "77"}) {
        CAPTURE(id);
        const auto path = (folder / "one.plc").string();
        CHECK(run(plprove + " certify " + id + " -o " + path).status == 0);
        CHECK(run(plcheck + " " + path).status == 0);
        CHECK(run(plprove + " certify " + id).out == read_file(path));
    }
}

TEST_CASE("the version is that of the project, the format that of the files") {
    CHECK(run(plprove + " --version").out == "plprove " PROJECT_VERSION
                                             ", certificate format " FORMAT_VERSION "\n");
    CHECK(run(plprove + " certify 0").out.starts_with("plcert " FORMAT_VERSION " problem\n"));
}

TEST_CASE("bad input is refused on standard error with its own exit status") {
    const Outcome number = run(plprove + " certify 143494");
    CHECK(number.status == 2);
    CHECK(number.out.empty());
    CHECK(number.err.find("0 to 143493") != std::string::npos);
    CHECK(run(plprove + " certify Boston").status == 2);
    CHECK(run(plprove).status == 3);
    CHECK(run(plprove + " certify").status == 3);
    CHECK(run(plprove + " certify 1 --unknown").status == 3);
    CHECK(run(plprove + " --help").status == 0);
    CHECK(run(plprove + " certify 1 -o /nowhere/at/all.plc").status == 1);
}

TEST_CASE("a failed write leaves the old file and nothing else") {
    const TemporaryFolder folder;
    const auto path = folder / "kept.plc";
    write_file(path, "old");
    const Outcome outcome = run_with_full_disk(plprove + " certify 2394 -o " + path.string());
    CHECK(outcome.status != 0);
    CHECK(read_file(path) == "old");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("the configuration of the Coq proof is that of the committed archive") {
    CHECK(run("cd " SOURCE_DIR "/proofs/coq && LC_ALL=C awk -f pool.awk " + certs +
              "classification.plc | cmp - Pool.v")
              .status == 0);
}
