// The package for Debian: what it needs, what it has, and that it is the same each time. That it
// installs on a bare system, tests/packages tries.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>

namespace {

namespace fs = std::filesystem;

/// Makes the package of this build in a folder; the result is its path.
fs::path make_package(const TemporaryFolder& folder) {
    const Outcome outcome =
        run("cd " BUILD_DIR " && SOURCE_DATE_EPOCH=1767225600 cpack -B " + folder.path().string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().extension() == ".deb") return entry.path();
    FAIL("cpack has made no package");
    return {};
}

std::string field(const fs::path& package, const std::string& name) {
    return run("dpkg-deb --field " + package.string() + ' ' + name).out;
}

} // namespace

TEST_CASE("the package names the libraries it needs, runs, and is the same each time") {
    if (!has_program("dpkg-shlibdeps")) {
        MESSAGE("left out: dpkg-shlibdeps is not installed");
        return;
    }
    const TemporaryFolder first;
    const fs::path package = make_package(first);
    CHECK(package.filename().string().starts_with("point-line-certificates_" PROJECT_VERSION "_"));
    CHECK(field(package, "Version") == PROJECT_VERSION "\n");
    for (const char* library : {"libc6", "libgmp10", "libflint", "libsqlite3-0"}) {
        CAPTURE(library);
        CHECK(field(package, "Depends").find(library) != std::string::npos);
    }

    const TemporaryFolder root;
    const std::string at = root.path().string();
    REQUIRE(run("dpkg-deb --extract " + package.string() + ' ' + at).status == 0);
    CHECK(run(at + "/usr/bin/plprove certify 2394 -o " + at + "/chicago.plc").status == 0);
    CHECK(run(at + "/usr/bin/plcheck " + at + "/chicago.plc").status == 0);
    for (const char* file :
         {"copyright", "changelog.gz", "README.md", "docs/install.md", "certs/FORMAT.md"}) {
        CAPTURE(file);
        CHECK(fs::exists(root / "usr/share/doc/point-line-certificates" / file));
    }

    const TemporaryFolder second;
    const bool same = read_file(make_package(second)) == read_file(package);
    CHECK(same);
}
