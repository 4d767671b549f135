// The container image: its sources are all that CMake asks for. That it builds and runs,
// tests/packages tries.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <regex>
#include <set>

namespace {

/// The first group of each match of a pattern in a file of the project.
std::set<std::string> found(const std::string& file, const std::string& pattern) {
    const std::string text = read_file(SOURCE_DIR "/" + file);
    const std::regex regex(pattern);
    std::set<std::string> words;
    for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
        words.insert((*match)[1]);
    return words;
}

} // namespace

TEST_CASE("the image is built from each folder that CMake enters, but for the tests") {
    const std::set<std::string> copied = found("packaging/Containerfile", "\nCOPY ([a-z]+) ");
    std::set<std::string> entered = found("CMakeLists.txt", "add_subdirectory\\(([a-z]+)\\)");
    CHECK(entered.size() > 4);
    for (const char* with_tests : {"tests", "examples"}) // PLC_TESTS is off in the image
        entered.erase(with_tests);
    for (const std::string& folder : entered) {
        CAPTURE(folder);
        CHECK(copied.contains(folder));
    }
}
