// What a degree file proves does not depend on the number of threads that replay it.
#include "checker/degrees/krawczyk.h"
#include "checker/report/report.h"
#include "tests/support/text.h"

#include <fstream>

using namespace checker;

namespace {

/// The head of a record, and its solutions, a line each.
struct DegreeText {
    std::string head{};
    std::vector<std::string> solutions{};

    std::string text() const {
        std::string text = head;
        for (const std::string& solution : solutions)
            text += solution + '\n';
        return text;
    }
};

/// Some solutions of the first record of a committed file.
DegreeText first_record() {
    DegreeText record;
    std::ifstream file(CERTS_DIR "/degrees/three-points.plc");
    for (std::string line; std::getline(file, line) && record.solutions.size() < 20;) {
        if (line.starts_with("real ") || line.starts_with("pair ")) {
            record.solutions.push_back(line);
        } else {
            record.head += line + '\n';
        }
    }
    return record;
}

const Classification& classes() {
    static const Classification all = classify();
    return all;
}

/// All that is said of the file.
std::string told(const std::string& text, std::size_t threads) {
    const ReplayedFile file = replay(classes(), "f", text, {[](const Progress&) {}, threads});
    return finding(file) + complaints(file);
}

void check_same(const DegreeText& record, const std::string& expected) {
    const std::string by_one = told(record.text(), 1);
    CHECK(contains(by_one, expected));
    for (const std::size_t threads : {2, 3, 100})
        CHECK(told(record.text(), threads) == by_one);
}

} // namespace

TEST_CASE("any number of threads proves the same, and finds the same flaw first") {
    if (!has_arb) return;
    const DegreeText good = first_record();
    const std::size_t count = good.solutions.size();
    REQUIRE(count >= 8);
    check_same(good, "1 degree record holds");
    for (const std::size_t place : {std::size_t{0}, std::size_t{1}, count / 2, count - 1}) {
        CAPTURE(place);
        DegreeText flawed = good;
        flawed.solutions[place] = "real 0 9 9 9 9 9 9 9 9 9 9 9";
        const auto at = [&](std::size_t solution) {
            const auto lines = std::ranges::count(good.head, '\n');
            return "f:" + std::to_string(static_cast<std::size_t>(lines) + 1 + solution) + ": ";
        };
        check_same(flawed, at(place) + "refused: ");
        flawed.solutions.back() = "real 0 1 1 1 1 1 1 1 1 1 1 1"; // a second flaw
        check_same(flawed, at(place) + "refused: ");
        DegreeText doubled = good;
        doubled.solutions.insert(doubled.solutions.begin() + static_cast<long>(place),
                                 good.solutions.back());
        check_same(doubled, at(count) + "refused: ");
        DegreeText malformed = good;
        malformed.solutions[place] += " 7";
        check_same(malformed, at(place));
    }
}
