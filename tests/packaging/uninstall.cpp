// `cmake --build build --target uninstall`: what was installed goes, and nothing else.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>

namespace {

namespace fs = std::filesystem;

/// Runs the script of the target for a build folder.
Outcome uninstall(const TemporaryFolder& build) {
    return run("cmake -DBUILD_DIR=" + build.path().string() +
               " -DPROJECT_NAME=point-line-certificates -P " SOURCE_DIR
               "/packaging/uninstall.cmake");
}

} // namespace

TEST_CASE("uninstall removes the files of its lists and the folders that they leave empty") {
    const TemporaryFolder build, prefix;
    const fs::path ours = prefix / "lib/cmake/plcheck", shared = prefix / "bin";
    const fs::path documents = prefix / "share/doc/point-line-certificates";
    const fs::path of_package = prefix / "share/doc/point-line-certificates-doc";
    for (const fs::path& folder : {ours, shared, documents / "docs", of_package})
        fs::create_directories(folder);
    for (const fs::path& file : {ours / "plcheckConfig.cmake", shared / "plcheck",
                                 documents / "docs/ci.md", documents / "mine.txt"})
        write_file(file, "");
    const std::string at = prefix.path().string();
    write_file(build / "install_manifest.txt", at + "/lib/cmake/plcheck/plcheckConfig.cmake\n" +
                                                   at + "/bin/plcheck\n" + at + "/bin/gone");
    write_file(build / "install_manifest_library.txt",
               at + "/share/doc/point-line-certificates/docs/ci.md\n" + at +
                   "/share/doc/point-line-certificates-doc/copyright\n");

    CHECK(uninstall(build).status == 0);
    CHECK(fs::is_empty(shared));
    CHECK(fs::is_empty(prefix / "lib/cmake"));
    CHECK(!fs::exists(documents / "docs"));
    CHECK(!fs::exists(of_package));
    CHECK(fs::exists(documents / "mine.txt")); // not ours
    const Outcome again = uninstall(build);
    CHECK(again.status != 0);
    CHECK(again.err.find("Nothing was installed") != std::string::npos);
}

TEST_CASE("the build has a target that uninstalls") {
    CHECK(read_file(SOURCE_DIR "/packaging/CMakeLists.txt").find("add_custom_target(uninstall") !=
          std::string::npos);
    CHECK(read_file(SOURCE_DIR "/docs/install.md").find("--target uninstall") != std::string::npos);
}
