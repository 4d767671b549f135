// A file that takes more effort than it may proves nothing, and FORMAT.md says what takes how much.
#include "checker/degrees/krawczyk.h"
#include "checker/report/report.h"
#include "tests/support/file.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>
#include <sstream>
#include <vector>

using namespace checker;

namespace {

const std::string too_much = "the file takes more effort than allowed";

/// All that is said of the file.
std::string told(const std::string& text, std::uint64_t effort, std::size_t threads = 1) {
    static const Classification classes = classify();
    const Execution execution{[](const Progress&) {}, threads, effort};
    const ReplayedFile file = replay(classes, "f", text, execution);
    return finding(file) + complaints(file);
}

/// Checks that the file holds with so much effort, and that with less it proves nothing and is
/// complained of once.
void check_effort(const std::string& text, std::uint64_t effort, const std::string& holds) {
    CAPTURE(effort);
    CHECK(contains(told(text, effort), holds));
    const std::string less = told(text, effort - 1);
    CHECK(contains(less, too_much));
    CHECK(contains(less, ": 0 "));
    CHECK(std::ranges::count(less, '\n') == 2);
}

/// The example of FORMAT.md, section 9, with other starting values for its solution.
std::string example_from(const std::string& start) {
    const std::string format = read(SOURCE_DIR "/certs/FORMAT.md");
    const std::size_t begin = format.find("\nplcert 2 degrees\n") + 1;
    const std::string example = format.substr(begin, format.find("```", begin) - begin);
    return example.substr(0, example.rfind("real ")) + start + "\n";
}

} // namespace

TEST_CASE(
    "a solution takes an effort of 1, or of 4 or 16 if the first proofs fail, and of 16 if all "
    "fail") {
    if (!has_arb) return;
    const std::string holds = "1 degree record holds";
    check_effort(example_from("real 2 2 4 -3 4 -3 -4 12 16 -10 8 10"), 1, holds);
    // Starts that are far off, found by trying many.
    check_effort(example_from("real 4 7 16 -14 15 -15 -17 66 78 -52 37 51"), 4, holds);
    check_effort(example_from("real 4 4 25 -10 0 2 -25 51 44 -14 19 49"), 16, holds);
    std::string far = "real 0";
    for (int i = 0; i < 11; ++i)
        far += " 999999999999999999";
    check_effort(example_from(far), 16, "0 degree records hold, 1 refused");
}

TEST_CASE("the efforts of a file's solutions add up, whatever the number of threads") {
    if (!has_arb) return;
    std::istringstream file(read(CERTS_DIR "/degrees/three-points.plc"));
    std::string head; // of the first record
    std::vector<std::string> solutions;
    for (std::string line; std::getline(file, line) && solutions.size() < 40;)
        if (line.starts_with("real ") || line.starts_with("pair "))
            solutions.push_back(line + "\n");
        else
            head += line + "\n";
    std::string all = head;
    std::uint64_t sum = 0;
    for (const std::string& solution : solutions) {
        all += solution;
        std::uint64_t effort = 1;
        while (effort < 16 && contains(told(head + solution, effort), too_much))
            effort *= 4;
        sum += effort;
    }
    CHECK(sum >= solutions.size());
    check_effort(all, sum, "1 degree record holds");
    const std::string less = told(all, sum - 1);
    for (const std::size_t threads : {2, 3, 100})
        CHECK(told(all, sum - 1, threads) == less);
}

TEST_CASE("a solution in general that is refused takes an effort of 16 for each 121 of n², rounded "
          "up") {
    if (!has_arb) return;
    std::string record = "plcert 2 solutions\nproblem projective: 7*P/P\n";
    for (int view = 0; view < 2; ++view) {
        record += "view";
        for (int i = 0; i < 21; ++i)
            record += say(' ', (i * i * 7 + view * 31 + i + 5) % 83 + 1);
        record += '\n';
    }
    record += "real 0"; // and 14 coordinates
    for (int i = 0; i < 14; ++i)
        record += " 999999999999999999";
    record += '\n';
    check_effort(record, 32, "0 solution records hold, 1 refused");
}

TEST_CASE("a problem in general takes an effort of 10, and more for many coordinates") {
    const std::string head = "plcert 2 problems\nmodulus 2305843009213693951\n";
    const std::string unbalanced = "problem P/P\nunbalanced\n";
    check_effort(head + unbalanced + unbalanced + unbalanced, 30, "3 certificates hold");
    // 97 points with a pin in 12 views: 582 coordinates, and 77 of cameras.
    std::string large = "problem 97*Pa/a/-/-/-/-/-/-/-/-/-/-\nminimal 1\n";
    for (int camera = 0; camera < 11; ++camera)
        large += "camera 1 1 1 1 1 1 1\n";
    large += "scene";
    for (int i = 0; i < 97 * 6; ++i)
        large += " 1";
    const std::uint64_t size = 97 * 6 + 77;
    const std::uint64_t effort = 10 + size * size * size / 200'000;
    CHECK(contains(told(head + large + "\n", effort), "it is not balanced"));
    CHECK(contains(told(head + large + "\n", effort - 1), too_much));
}
