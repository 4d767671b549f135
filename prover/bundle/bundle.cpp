#include "prover/bundle/bundle.h"

#include "prover/system/sha256.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace plprove {

namespace {

namespace fs = std::filesystem;

/// The files of a folder, and of the folders in it, whose names end like this. A folder that is not
/// required may be missing.
struct Selection {
    const char* folder;
    std::vector<std::string> endings;
    bool required = true;
};

const Selection bundle_selections[] = {
    {"certs", {".plc", ".md", ".csv", "SHA256SUMS"}},
    {"checker", {".cpp", ".h", "CMakeLists.txt"}},
    {"docs", {".md", ".svg", ".json"}, false},
    {"proofs", {".md", ".v", ".awk", ".expected", "Makefile", ".cpp", ".h"}},
};

constexpr const char* bundle_files[] = {"CITATION.cff", "LICENSE", "certs/vectors/verdicts.txt"};

/// Small files that show what a checker does; they prove nothing, and many do not even conform.
constexpr const char* vectors = "certs/vectors/";

const Selection checker_selections[] = {
    {"checker", {".cpp", ".h", "CMakeLists.txt"}},
    {"cmake", {".cmake"}},
    {"packaging", {".awk", ".cmake", ".in", "CMakeLists.txt"}},
};

constexpr const char* checker_files[] = {
    "CITATION.cff",    "CMakeLists.txt", "CMakePresets.json", "LICENSE",
    "certs/FORMAT.md", "docs/ci.md",     "docs/install.md",   "docs/report.schema.json"};

constexpr const char* landmarks[] = {"certs/FORMAT.md", "certs/SHA256SUMS", "checker/main.cpp"};

constexpr const char* bundle_readme =
    R"(Certificates for the classification of point-line minimal problems

certs/     the certificates; FORMAT.md specifies them, enough to write another checker
checker/   the sources of plcheck, which believes nothing and replays every certificate
proofs/    why a certificate that passes implies its claim, and programs that a proof needs

With a C++20 compiler, GMP (https://gmplib.org) and FLINT with Arb (https://flintlib.org), in this
folder:

    c++ -std=c++20 -O2 -DPLC_ARB -I. checker/*.cpp checker/*/*.cpp -lflint-arb -lflint -lgmpxx -lgmp -o plcheck
    ./plcheck certs/*.plc certs/degrees/*.plc certs/solutions/*.plc
    ./plcheck --effort 2000000 certs/solutions/large/*.plc

The first line builds the checker. FLINT 3 has Arb inside: leave out -lflint-arb. The second line
replays certificates in about a minute, the third those that take some minutes more. They print what
is proved, and exit with 0 if all certificates hold.

Without FLINT, the checker replays all but the degree files:

    c++ -std=c++20 -O2 -I. checker/*.cpp checker/*/*.cpp -lgmpxx -lgmp -o plcheck
    ./plcheck certs/*.plc

SHA256SUMS has the SHA-256 digest of every other file here: sha256sum --check SHA256SUMS
)";

constexpr const char* checker_readme = R"(plcheck, the checker of point-line certificates

checker/         the sources
certs/FORMAT.md  what a certificate file is, and what plcheck verifies
example.plc      a certificate: the Chicago problem 2*Pa/Pa/Pa + P/P/P is minimal

With a C++20 compiler and GMP (https://gmplib.org), in this folder:

    c++ -std=c++20 -O2 -I. checker/*.cpp checker/*/*.cpp -lgmpxx -lgmp -o plcheck
    ./plcheck example.plc

The first line builds the checker. The second prints what the certificate proves, and exits with 0
if it holds. Degree files need FLINT with Arb (https://flintlib.org), too: add to the first line
-DPLC_ARB and, before -lgmpxx, -lflint-arb -lflint (with FLINT 3: -lflint).

docs/install.md says how to install plcheck with CMake, and how to call it from a program.
SHA256SUMS has the SHA-256 digest of every other file here: sha256sum --check SHA256SUMS
)";

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw std::runtime_error("cannot read " + path.string());
    return content;
}

void require_project(const fs::path& source) {
    for (const char* landmark : landmarks)
        if (!fs::is_regular_file(source / landmark))
            throw std::runtime_error(source.string() +
                                     " is not the project's source folder, it has no " + landmark +
                                     ": name that folder with --source");
}

void add_selection(Files& files, const fs::path& source, const Selection& selection) {
    if (!selection.required && !fs::exists(source / selection.folder)) return;
    for (const auto& entry : fs::recursive_directory_iterator(source / selection.folder)) {
        const std::string path = entry.path().lexically_relative(source).generic_string();
        const auto ends_path = [&](const std::string& ending) { return path.ends_with(ending); };
        if (entry.is_regular_file() && std::ranges::any_of(selection.endings, ends_path))
            files[path] = read(entry.path());
    }
}

/// Requires that certs/SHA256SUMS has the digest of every certificate, and no other.
void check_digests(const Files& files) {
    Files digests;
    std::istringstream lines(files.at("certs/SHA256SUMS"));
    for (std::string digest, name; lines >> digest >> name;)
        digests["certs/" + name] = digest;
    for (const auto& [path, digest] : digests)
        if (!files.contains(path))
            throw std::runtime_error("certs/SHA256SUMS names " + path +
                                     ", which is not there: restore it, or write SHA256SUMS again");
    for (const auto& [path, content] : files)
        if (path.ends_with(".plc") && !path.starts_with(vectors) &&
            digests[path] != sha256(content))
            throw std::runtime_error(
                path + " is not the file whose digest is in certs/SHA256SUMS: restore it, or "
                       "write SHA256SUMS again");
}

Files select(const fs::path& source, std::span<const Selection> selections,
             std::span<const char* const> single_files) {
    require_project(source);
    Files files;
    for (const Selection& selection : selections)
        add_selection(files, source, selection);
    for (const char* name : single_files)
        files[name] = read(source / name);
    return files;
}

std::string sums(const Files& files) {
    std::string text;
    for (const auto& [path, content] : files)
        text += sha256(content) + "  " + path + '\n';
    return text;
}

Files finished(Files files, const char* readme) {
    files["README"] = readme;
    files["SHA256SUMS"] = sums(files);
    return files;
}

} // namespace

Files bundle(const fs::path& source) {
    Files files = select(source, bundle_selections, bundle_files);
    check_digests(files);
    return finished(std::move(files), bundle_readme);
}

Files checker_archive(const fs::path& source, const std::string& example) {
    Files files = select(source, checker_selections, checker_files);
    files["example.plc"] = example;
    return finished(std::move(files), checker_readme);
}

} // namespace plprove
