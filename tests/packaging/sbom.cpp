// The bill of materials: it names what the programs need and nothing else, and has the fields that
// SPDX 2.3 requires.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <regex>
#include <set>
#include <yaml-cpp/yaml.h>

namespace {

using Names = std::set<std::string>;

/// JSON is YAML.
YAML::Node bill() {
    return YAML::Load(read_file(installed() / "share/doc/point-line-certificates/sbom.spdx.json"));
}

/// The shared libraries that the installed programs name, but those of compiler, sanitizers and C.
/// Bindings for C++ are part of their libraries; unoptimised programs call functions of theirs.
Names needed() {
    const Outcome outcome =
        run("cd " + (installed() / "bin").string() + " && LC_ALL=C readelf -d plcheck plprove");
    REQUIRE(outcome.status == 0);
    const std::regex library(R"(Shared library: \[([^\]]*\.so))");
    const std::regex system("lib(stdc\\+\\+|gcc_s|m|c|[a-z]+san)\\.so|ld-linux.*");
    Names names;
    for (std::sregex_iterator i(outcome.out.begin(), outcome.out.end(), library), end; i != end;
         ++i)
        if (!std::regex_match((*i)[1].str(), system))
            names.insert(std::regex_replace((*i)[1].str(), std::regex("xx|_cxx"), ""));
    return names;
}

/// What CMake looks for to build checker and prover.
Names looked_for() {
    const std::regex call(R"(find_package\((\w+))");
    Names names;
    for (const char* file : {"/checker/CMakeLists.txt", "/prover/CMakeLists.txt"}) {
        const std::string text = read_file(SOURCE_DIR + std::string(file));
        for (std::sregex_iterator i(text.begin(), text.end(), call), end; i != end; ++i)
            names.insert((*i)[1]);
    }
    return names;
}

} // namespace

TEST_CASE("the bill of materials names what the programs need, and nothing else") {
    Names names, files;
    for (const YAML::Node& package : bill()["packages"]) {
        names.insert(package["name"].as<std::string>());
        if (package["packageFileName"]) files.insert(package["packageFileName"].as<std::string>());
    }
    CHECK(files == needed());
    Names due = looked_for();
    due.insert("point-line-certificates");
    due.erase("Threads"); // part of the C library
    if (!files.contains("libmpi.so")) due.erase("MPI");
    if (files.contains("libflint-arb.so")) due.insert("Arb"); // else it is part of FLINT
    CHECK(names == due);
}

TEST_CASE("the bill of materials has the fields that SPDX 2.3 requires") {
    const YAML::Node document = bill();
    CHECK(document["spdxVersion"].as<std::string>() == "SPDX-2.3");
    CHECK(document["dataLicense"].as<std::string>() == "CC0-1.0");
    CHECK(document["SPDXID"].as<std::string>() == "SPDXRef-DOCUMENT");
    CHECK(document["name"].as<std::string>() == "point-line-certificates-" PROJECT_VERSION);
    CHECK(document["documentNamespace"].as<std::string>().starts_with("https://"));
    const YAML::Node creation = document["creationInfo"];
    CHECK(std::regex_match(creation["created"].as<std::string>(),
                           std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
    CHECK(creation["creators"].size() == 1);
    const std::regex id("SPDXRef-[A-Za-z0-9.-]+"), version(R"(\d+(\.\d+)+)");
    Names ids{"SPDXRef-DOCUMENT"}, related;
    for (const YAML::Node& package : document["packages"]) {
        CAPTURE(package["name"].as<std::string>());
        CHECK(std::regex_match(package["SPDXID"].as<std::string>(), id));
        CHECK(ids.insert(package["SPDXID"].as<std::string>()).second);
        CHECK(std::regex_match(package["versionInfo"].as<std::string>(), version));
        CHECK(!package["licenseDeclared"].as<std::string>().empty());
        CHECK(package["downloadLocation"].as<std::string>() == "NOASSERTION");
        CHECK(!package["filesAnalyzed"].as<bool>());
    }
    for (const YAML::Node& relation : document["relationships"]) {
        CHECK(ids.contains(relation["spdxElementId"].as<std::string>()));
        related.insert(relation["relatedSpdxElement"].as<std::string>());
    }
    ids.erase("SPDXRef-DOCUMENT");
    CHECK(related == ids);
}
