// The installed checker as a library: a program of ten lines is built against it, as
// docs/install.md shows, and says what the command plcheck says.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <map>

namespace {

/// The first block of the page that is fenced with this word.
std::string block_of(const std::string& page, const std::string& word) {
    const std::string fence = "```" + word + "\n";
    const std::size_t begin = page.find(fence);
    REQUIRE(begin != std::string::npos);
    const std::size_t start = begin + fence.size();
    return page.substr(start, page.find("```", start) - start);
}

/// Builds the program of docs/install.md in a folder; the program is the folder's build/check.
void build_program(const TemporaryFolder& folder) {
    const std::string page = read_file(SOURCE_DIR "/docs/install.md");
    write_file(folder / "check.cpp", block_of(page, "cpp"));
    write_file(folder / "CMakeLists.txt", block_of(page, "cmake"));
    const std::string at = folder.path().string();
    const Outcome build =
        run("env -u CXXFLAGS cmake -S " + at + " -B " + at +
            "/build -DCMAKE_PREFIX_PATH=" + installed().string() +
            " -DCMAKE_EXE_LINKER_FLAGS='" LINK_OPTIONS "' && cmake --build " + at + "/build");
    CAPTURE(build.out);
    CAPTURE(build.err);
    REQUIRE(build.status == 0);
}

} // namespace

TEST_CASE("a program built against the installed library says what plcheck says") {
    const TemporaryFolder folder;
    build_program(folder);
    const std::string inside = "cd " + folder.path().string() + " && ";
    const std::string plcheck = (installed() / "bin/plcheck ").string();
    const std::string plprove = (installed() / "bin/plprove ").string();
    REQUIRE(run(inside + plprove + "certify 2394 -o good.plc").status == 0);
    REQUIRE(run(inside + plprove + "degree 2394 --target 3 -o degrees.plc").status == 0);
    REQUIRE(run(inside + "sed '$ s/[0-9]*$/1/' good.plc > refused.plc").status == 0);
    REQUIRE(run(inside + "head -n 4 good.plc > malformed.plc").status == 0);
    REQUIRE(run(inside + plprove + "certify '3*P/P/P + a/a/a' -o other.plc").status == 0);
    const std::map<std::string, int> expected{{"good.plc", 0},
                                              {"degrees.plc", 1},
                                              {"other.plc", 1},
                                              {"refused.plc", 1},
                                              {"malformed.plc", 2}};
    for (const auto& [file, status] : expected) {
        CAPTURE(file);
        const Outcome library = run(inside + "build/check " + file);
        const Outcome command =
            run(inside + plcheck + "--expect '2*Pa/Pa/Pa + P/P/P' --verdict minimal " + file);
        CHECK(library.status == status);
        CHECK(command.status == status);
        CHECK(library.out == command.out);
    }
}

TEST_CASE("the package says its version, and refuses to stand for another major one") {
    const TemporaryFolder folder;
    const auto configure = [&](const std::string& version) {
        write_file(folder / "CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\n"
                                              "project(example CXX)\n"
                                              "find_package(plcheck " +
                                                  version + " REQUIRED)\n");
        return run("cmake -S " + folder.path().string() + " -B " + (folder / "build").string() +
                   " -DCMAKE_PREFIX_PATH=" + installed().string())
            .status;
    };
    CHECK(configure(PROJECT_VERSION) == 0);
    CHECK(configure("999.0") != 0);
}

TEST_CASE("pkg-config says how to build with either library, wherever it is installed") {
    if (!has_program("pkg-config")) {
        MESSAGE("left out: pkg-config is not installed");
        return;
    }
    const std::string find = "find " + installed().string() + " -name plcheck.pc -printf %h";
    const std::string folder = run(find).out;
    REQUIRE(folder.ends_with("/pkgconfig"));
    const std::string ask = "PKG_CONFIG_PATH=" + folder + " pkg-config ";
    CHECK(run(ask + "--modversion plcheck").out == PROJECT_VERSION "\n");
    const Outcome flags = run(ask + "--cflags --libs --static plcheck");
    CAPTURE(flags.err);
    CHECK(flags.out.find("-lplcheck") != std::string::npos);
    const TemporaryFolder work;
    write_file(work / "check.cpp", block_of(read_file(SOURCE_DIR "/docs/install.md"), "cpp"));
    const Outcome build =
        run("c++ -std=c++20 " LINK_OPTIONS " -o " + (work / "check").string() + ' ' +
            (work / "check.cpp").string() + " $(" + ask + "--cflags --libs --static plcheck)");
    CAPTURE(build.err);
    CHECK(build.status == 0);
    CHECK(run("PKG_CONFIG_PATH=" BUILD_DIR "/prover/library pkg-config --libs pointline")
              .out.find("-lpointline") != std::string::npos);
}
