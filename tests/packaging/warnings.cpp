// Where warnings are errors: not where users build, but in ./reproduce test, however much of it was
// compiled before.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <set>
#include <yaml-cpp/yaml.h>

namespace {

namespace fs = std::filesystem;

/// Runs functions of ./reproduce in a folder.
Outcome in_reproduce(const TemporaryFolder& folder, const std::string& calls) {
    const std::string functions =
        "eval \"$(sed -n "
        "'/^\\(warned_sources\\|compile_warned_again\\|fail_for_warnings\\|build\\)()/,/^}/"
        "p' " SOURCE_DIR "/reproduce)\"; set -euo pipefail; ";
    write_file(folder / "script", functions + calls);
    return run("cd " + folder.path().string() + " && PATH=" + (folder / "bin").string() +
               ":$PATH bash script");
}

/// Whether a file was written today.
bool is_new(const fs::path& file) {
    return fs::last_write_time(file) > fs::file_time_type::clock::now() - std::chrono::hours(24);
}

void make_old(const fs::path& file) {
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1000));
}

} // namespace

TEST_CASE("warnings are errors in the presets for developers, and not in the others") {
    const YAML::Node presets = YAML::LoadFile(SOURCE_DIR "/CMakePresets.json")["configurePresets"];
    std::set<std::string> strict;
    for (const YAML::Node& preset : presets)
        if (preset["cacheVariables"] && preset["cacheVariables"]["PLC_WERROR"])
            strict.insert(preset["name"].as<std::string>());
    CHECK(strict == std::set<std::string>{"clang", "fuzz", "sanitize", "tsan"});
}

TEST_CASE("./reproduce test fails for a warning of an earlier build, until it is gone") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "bin");
    // A stand-in for CMake: compiles a.cpp, and so warns of it, if it is new.
    write_file(folder / "bin/cmake",
               "#!/bin/sh\n"
               "[ \"$1\" = --build ] || exit 0\n"
               "if [ ! -e object ] || [ a.cpp -nt object ]; then grep 'warning: ' a.cpp; fi\n"
               "touch -d 'last week' object\n");
    fs::permissions(folder / "bin/cmake", fs::perms::owner_all);
    write_file(folder / "a.cpp", "a.cpp:1:2: warning: unused\n");
    write_file(folder / "b.cpp", "");
    make_old(folder / "b.cpp");
    const std::string test = "compile_warned_again; build release; fail_for_warnings";

    CHECK(in_reproduce(folder, "build release installable").status == 0);
    CHECK(read_file(folder / "build.log") == "a.cpp:1:2: warning: unused\n");
    make_old(folder / "a.cpp");
    CHECK(in_reproduce(folder, "build release installable").status == 0);
    CHECK(read_file(folder / "build.log") == "");
    for (int i = 0; i < 2; ++i) {
        const Outcome outcome = in_reproduce(folder, test);
        CHECK(outcome.status == 1);
        CHECK(outcome.err.find("a.cpp:1:2: warning: unused") != std::string::npos);
        make_old(folder / "a.cpp");
    }
    CHECK(!is_new(folder / "b.cpp"));

    write_file(folder / "a.cpp", "");
    CHECK(in_reproduce(folder, test).status == 0);
    make_old(folder / "a.cpp");
    CHECK(in_reproduce(folder, test).status == 0);
    CHECK(!is_new(folder / "a.cpp")); // nothing is compiled again
}

TEST_CASE("./reproduce and ./reproduce test compile the same way") {
    const std::string script = read_file(SOURCE_DIR "/reproduce");
    CHECK(script.find("    build release installable\n") != std::string::npos);
    CHECK(script.find("    compile_warned_again\n    build release\n    fail_for_warnings\n") !=
          std::string::npos);
}
