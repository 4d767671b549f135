// What plprove degrees and plprove collect say where a file of a sweep is damaged, or is none.
#include "tests/support/program.h"

#include <doctest/doctest.h>

TEST_CASE("a damaged file is named and left out, and --retry mends it; a pipe is refused") {
    const TemporaryFolder folder;
    const std::string plprove = PLPROVE_FAKE_ENGINE, in = " -o " + folder.path().string();
    const std::string sweep = plprove + " degrees --exact --classes 2394,6723" + in;
    CHECK(run(sweep).status == 0);
    const std::string whole = read_file(folder / "degrees.plc");
    const std::filesystem::path file = folder / "seed-0" / "002" / "2394.plc";
    std::string text = read_file(file);
    write_file(file, text.replace(text.find("\nimage "), 7, "\nimags "));
    const std::string collect = plprove + " collect" + in;
    for (const std::string& command : {sweep, collect}) {
        const Outcome damaged = run(command);
        CHECK(damaged.status == 1);
        CHECK(damaged.err == "plprove: 1 file is damaged and was left out: #2394\n"
                             "  a sweep with --retry computes its class again\n");
        CHECK(read_file(folder / "degrees.plc").find("degree 2394") == std::string::npos);
    }
    const Outcome retried = run(sweep + " --retry");
    CHECK(retried.status == 0);
    CHECK(retried.err.empty());
    CHECK(read_file(folder / "degrees.plc") == whole);

    REQUIRE(run("rm " + file.string() + " && mkfifo " + file.string()).status == 0);
    CHECK(run("timeout 600 " + collect).status == 1);
    const Outcome pipe = run("timeout 600 " + sweep);
    CHECK(pipe.status == 2);
    CHECK(pipe.err == "plprove: " + file.string() + " is no regular file: remove it\n");
}
