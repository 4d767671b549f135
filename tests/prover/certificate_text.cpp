// Lines of certificate files: broken where the format demands it, as late as possible, and nothing
// but broken; and what does not fit the format at all.
#include "prover/format/certificate_text.h"

#include <doctest/doctest.h>
#include <random>
#include <sstream>
#include <vector>

using namespace plprove;

namespace {

std::vector<std::string> physical_lines(const std::string& line) {
    std::string text;
    append_line(text, line);
    REQUIRE(text.ends_with('\n'));
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string one; std::getline(stream, one);)
        lines.push_back(one);
    return lines;
}

/// What a reader makes of the lines.
std::string joined(const std::vector<std::string>& lines) {
    std::string line;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        REQUIRE(lines[i].ends_with(" \\"));
        line += lines[i].substr(0, lines[i].size() - 1);
    }
    return line + lines.back();
}

/// Words of one letter, and a last one, in a line of `bytes` bytes.
std::string line_of(std::size_t bytes, std::size_t last_word) {
    std::string line;
    while (line.size() + last_word < bytes)
        line += "x ";
    return line.substr(0, bytes - last_word - 1) + ' ' + std::string(last_word, 'y');
}

} // namespace

TEST_CASE("a line of 16,384 bytes is not broken, a longer one is") {
    for (const std::size_t last : {1U, 2U, 3U, 100U}) {
        CAPTURE(last);
        const std::string fits = line_of(16384, last);
        REQUIRE(fits.size() == 16384);
        CHECK(physical_lines(fits) == std::vector{fits});
        const std::string exceeds = line_of(16385, last);
        REQUIRE(exceeds.size() == 16385);
        const std::vector<std::string> lines = physical_lines(exceeds);
        CHECK(lines.size() == 2);
        CHECK(joined(lines) == exceeds);
    }
}

TEST_CASE("a line is broken at the last space that leaves room for the mark") {
    // The words before the break have 16,382 bytes, or one more: then the last of them moves.
    const std::string rest = " " + std::string(100, 'z');
    const std::string first = line_of(16382, 5);
    CHECK(physical_lines(first + rest) == std::vector{first + " \\", rest.substr(1)});
    const std::string longer = line_of(16383, 5);
    const std::vector<std::string> lines = physical_lines(longer + rest);
    CHECK(lines[0].size() == 16384 - 5);
    CHECK(lines[1] == "yyyyy" + rest);
}

TEST_CASE("broken lines are as long as their words allow, and say the same") {
    std::mt19937 random(1);
    for (int repetition = 0; repetition < 50; ++repetition) {
        std::string line = "kernel";
        while (line.size() < 100'000)
            line += ' ' + std::string(1 + random() % (repetition % 2 == 0 ? 10 : 9000), '7');
        const std::vector<std::string> lines = physical_lines(line);
        CHECK(joined(lines) == line);
        for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
            CHECK(lines[i].size() <= longest_line);
            const std::string next_word = lines[i + 1].substr(0, lines[i + 1].find(' '));
            CHECK(lines[i].size() + 1 + next_word.size() > longest_line);
        }
        CHECK(lines.back().size() <= longest_line);
    }
}

TEST_CASE("a word that fits no line is refused") {
    const std::string longest(longest_line - 2, '1');
    CHECK(physical_lines(longest + ' ' + longest).size() == 2);
    CHECK_THROWS_AS(physical_lines(longest + "11 " + longest), FormatLimit);
    CHECK_THROWS_AS(physical_lines("minor " + longest + "1 1"), FormatLimit);
}

TEST_CASE("words, integers and ranges of them make a line") {
    CertificateText text;
    text.line("delete rows", std::vector{1, 2}, "columns", std::vector<std::string>{"11"}, 12U);
    CHECK(text.take() == "delete rows 1 2 columns 11 12\n");
    CHECK(certificate_file("problem", "problem P\n", "") == "plcert 2 problem\nproblem P\n");
}

TEST_CASE("a file of 64 MiB is written, a larger one is refused with what to do") {
    const std::size_t head = first_line("degrees").size();
    const std::string lines((std::size_t{64} << 20U) - head + 1, '\n');
    CHECK(certificate_file("degrees", std::string_view(lines).substr(1), "").size() == 64 << 20U);
    CHECK_THROWS_WITH_AS(certificate_file("degrees", lines, "ask for less"),
                         "the certificate file would have 67108865 bytes, and the format allows "
                         "67108864 (64 MiB): ask for less",
                         FormatLimit);
}

TEST_CASE("integers with more digits than the format allows are refused") {
    CHECK(coordinates(std::vector{-999'999, 0, 999'999}) == "-999999 0 999999");
    CHECK_THROWS_AS(coordinates(std::vector{1'000'000}), FormatLimit);
    CHECK_THROWS_AS(coordinates(std::vector{-1'000'000}), FormatLimit);
    CHECK(with_digits("-" + std::string(1000, '9'), 1000, "a kernel entry").size() == 1001);
    CHECK_THROWS_WITH_AS(with_digits(std::string(1001, '9'), 1000, "a kernel entry"),
                         doctest::Contains("1001 digits, and the format allows 1000"), FormatLimit);
}
