// The packages for Debian: what they need, what they have, and that they are the same each time.
// That they install on a bare system, tests/packages tries.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <map>

namespace {

namespace fs = std::filesystem;

using Packages = std::map<std::string, fs::path>;

/// Makes the packages of this build in a folder: their paths by their names.
Packages make_packages(const TemporaryFolder& folder) {
    // Compressed fast: users get smaller ones.
    const Outcome outcome = run("cd " BUILD_DIR " && SOURCE_DATE_EPOCH=1767225600 cpack "
                                "-D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -B " +
                                folder.path().string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    Packages packages;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".deb")) packages[name.substr(0, name.find('_'))] = entry.path();
    }
    return packages;
}

std::string field(const fs::path& package, const std::string& name) {
    return run("dpkg-deb --field " + package.string() + ' ' + name).out;
}

} // namespace

TEST_CASE("the packages name what they need, have what they should, and are the same each time") {
    if (!has_program("dpkg-shlibdeps")) {
        MESSAGE("left out: dpkg-shlibdeps is not installed");
        return;
    }
    const TemporaryFolder first;
    const Packages packages = make_packages(first);
    REQUIRE(packages.size() == 4);
    const fs::path programs = packages.at("point-line-certificates");
    const fs::path library = packages.at("libplcheck-dev");
    const fs::path solver = packages.at("libpointline-dev");
    const fs::path documents = packages.at("point-line-certificates-doc");
    for (const auto& [name, package] : packages) {
        CAPTURE(name);
        CHECK(field(package, "Package") == name + "\n");
        CHECK(field(package, "Version") == PROJECT_VERSION "\n");
    }
    for (const char* needed : {"libc6", "libgmp10", "libflint", "libsqlite3-0"}) {
        CAPTURE(needed);
        CHECK(field(programs, "Depends").find(needed) != std::string::npos);
    }
    for (const char* needed : {"libgmp-dev", "libflint-dev"}) {
        CAPTURE(needed);
        CHECK(field(library, "Depends").find(needed) != std::string::npos);
    }
    for (const char* needed : {"libgmp10", "libceres3"}) {
        CAPTURE(needed);
        CHECK(field(solver, "Depends").find(needed) != std::string::npos);
    }
    CHECK(field(documents, "Architecture") == "all\n");

    if (has_program("lintian")) {
        // The maintainer's address is for those to set who hand the package out (PLC_CONTACT).
        const Outcome faults =
            run("lintian --allow-root --fail-on error --suppress-tags bogus-mail-host,"
                "bogus-mail-host-in-debian-changelog,root-in-contact " +
                first.path().string() + "/*.deb");
        CAPTURE(faults.out);
        CHECK(faults.status == 0);
    } else {
        MESSAGE("left out: lintian is not installed");
    }

    const TemporaryFolder root;
    const std::string at = root.path().string();
    REQUIRE(run("dpkg-deb --extract " + programs.string() + ' ' + at).status == 0);
    CHECK(run(at + "/usr/bin/plprove certify 2394 -o " + at + "/chicago.plc").status == 0);
    CHECK(run(at + "/usr/bin/plcheck " + at + "/chicago.plc").status == 0);
    // The programs come without headers, library and certificates.
    CHECK(!fs::exists(root / "usr/include"));
    CHECK(!fs::exists(root / "usr/share/point-line-certificates"));
    const fs::path of_all = root / "usr/share/doc";
    CHECK(fs::exists(of_all / "point-line-certificates/copyright"));
    CHECK(fs::exists(of_all / "point-line-certificates/sbom.spdx.json"));

    REQUIRE(run("dpkg-deb --extract " + library.string() + ' ' + at).status == 0);
    CHECK(fs::exists(root / "usr/include/plcheck/plcheck.h"));
    CHECK(!fs::exists(root / "usr/share/point-line-certificates"));
    REQUIRE(run("dpkg-deb --extract " + solver.string() + ' ' + at).status == 0);
    for (const char* file : {"estimator.h", "solver.h", "problem.h"})
        CHECK(fs::exists(root / "usr/include/pointline" / file));
    for (const char* file : {"libpointline.so", "libpointline.so.1", "pointline.pc",
                             "pointlineConfig.cmake", "pointlineTargets.cmake"}) {
        CAPTURE(file);
        CHECK(run("find " + at + "/usr/lib -name " + file).out != "");
    }
    CHECK(!fs::exists(root / "usr/share/point-line-certificates"));
    REQUIRE(run("dpkg-deb --extract " + documents.string() + ' ' + at).status == 0);
    CHECK(fs::exists(root / "usr/share/point-line-certificates/certs/classification.plc"));
    for (const char* file : {"README.md", "docs/install.md", "certs/FORMAT.md"}) {
        CAPTURE(file);
        CHECK(fs::exists(of_all / "point-line-certificates" / file));
    }
    for (const auto& [name, package] : packages) {
        CAPTURE(name);
        CHECK(fs::exists(of_all / name / "copyright"));
        CHECK(fs::exists(of_all / name / "changelog.gz"));
    }

    const TemporaryFolder second;
    for (const auto& [name, package] : make_packages(second)) {
        CAPTURE(name);
        const bool same = read_file(package) == read_file(packages.at(name));
        CHECK(same);
    }
}
