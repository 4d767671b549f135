// Lines that go on: a line whose last word is a backslash continues in the next one, in every kind
// of file, with the same result as the line in one piece.
#include "tests/support/few_classes.h"
#include "tests/support/file.h"
#include "tests/support/report.h"

#include <random>

using namespace checker;

namespace {

/// All words of a text with their line numbers, as `word@line`; or what is wrong with it.
std::string words_of(const std::string& bytes) {
    try {
        Reader reader(bytes);
        std::string words;
        while (!reader.at_end()) {
            const std::size_t line = reader.line();
            words += say(reader.word(), '@', line, ' ');
            if (reader.at_end()) reader.end_line();
        }
        return words;
    } catch (const Malformed& malformed) {
        return say(malformed.complaint.line, ": ", malformed.complaint.reason);
    }
}

std::string first_complaint(const std::string& bytes) {
    return complaints(summarize({}, {replay(few_classes(), "file", bytes)}));
}

/// The text with lines broken: at spaces that `chosen` names, outside of comments.
template <class Chosen>
std::string broken(const std::string& text, const Chosen& chosen) {
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        for (const char c : line)
            result +=
                c == ' ' && line[0] != '#' && chosen() ? std::string(" \\\n") : std::string{c};
        result += '\n';
    }
    return result;
}

std::string file(const std::string& path) {
    return read(SOURCE_DIR "/" + path);
}

/// What plcheck says of the file, for people and in JSON, without its digest.
std::string told(const Classification& classes, const std::string& bytes) {
    ReplayedFile replayed = replay(classes, "file", bytes);
    replayed.sha256.clear();
    const Report report = summarize(classes, {replayed});
    return detailed(report) + json(report) + complaints(report);
}

/// The text with each line in one piece.
std::string in_one_piece(std::string text) {
    const std::string mark = " \\\n";
    for (std::size_t at; (at = text.find(mark)) != text.npos;)
        text.replace(at, mark.size(), " ");
    return text;
}

/// Checks that a file that holds says the same however it is broken.
void same_however_broken(const Classification& classes, const std::string& given) {
    const std::string bytes = in_one_piece(given);
    const std::string expected = told(classes, bytes);
    const bool as_given = told(classes, given) == expected;
    CHECK(as_given);
    CHECK(expected.find("\"status\": 0") != expected.npos);
    const bool everywhere = told(classes, broken(bytes, [] { return true; })) == expected;
    CHECK(everywhere);
    std::mt19937_64 random(1);
    for (const unsigned one_in : {2U, 10U}) {
        const auto chosen = [&] { return random() % one_in == 0; };
        const bool in_places = told(classes, broken(bytes, chosen)) == expected;
        CHECK(in_places);
    }
}

} // namespace

TEST_CASE("the words of the next line follow in place of the backslash") {
    CHECK(words_of("a b\nc\n") == "a@1 b@1 c@2 ");
    CHECK(words_of("a \\\nb\nc\n") == "a@1 b@2 c@3 ");
    CHECK(words_of("a b \\\nc \\\nd e\nf\n") == "a@1 b@1 c@2 d@3 e@3 f@4 ");
    CHECK(words_of("a \\b\n") == "a@1 \\b@1 ");
    CHECK(words_of("a \\ b\n") == "a@1 \\@1 b@1 ");
    CHECK(words_of("a \\\\\n") == "a@1 \\\\@1 ");
    CHECK(words_of("a\\\nb\n") == "a\\@1 b@2 ");
}

TEST_CASE("a line ends where the last of its parts ends") {
    Reader reader("a \\\nb\nc\n");
    CHECK(reader.word() == "a");
    CHECK_FALSE(reader.at_end());
    CHECK(reader.comes("b"));
    CHECK(reader.line() == 2);
    CHECK_THROWS_AS(reader.end_line(), Malformed);
    CHECK(reader.word() == "b");
    CHECK(reader.at_end());
    reader.end_line();
    CHECK(reader.word() == "c");
}

TEST_CASE("a backslash alone is no line") {
    const std::string expected = "found `\\x5c`, expected a word before the backslash";
    CHECK(words_of("\\\n") == "1: " + expected);
    CHECK(words_of("\\\na\n") == "1: " + expected);
    CHECK(words_of("a\n\\\nb\n") == "2: " + expected);
    CHECK(words_of("a \\\n\\\nb\n") == "2: " + expected);
}

TEST_CASE("a space stands before the backslash, and nothing after it") {
    CHECK(words_of("a \\ \nb\n") == "1: found `a \\x5c `, expected words separated by one space");
    CHECK(words_of("a  \\\nb\n") == "1: found `a  \\x5c`, expected words separated by one space");
    CHECK(words_of("a \\\n b\n") == "2: found ` b`, expected words separated by one space");
    CHECK(words_of("a \\\n\nb\n") == "2: found nothing, expected words separated by one space");
}

TEST_CASE("a file does not end in a backslash") {
    const std::string expected = "found nothing, expected a line feed within 16384 bytes";
    CHECK(words_of("a \\\n") == "2: " + expected);
    CHECK(words_of("a\nb \\\n") == "3: " + expected);
    CHECK(words_of("a \\") == "1: found `a \\x5c`, expected a line feed within 16384 bytes");
    CHECK(first_complaint("plcert 2 problem\nproblem P/P \\\n") ==
          "file:3: does not conform to FORMAT.md: " + expected + "\n");
}

TEST_CASE("a comment does not continue a line, and does not go on") {
    CHECK(words_of("a \\\n# b\n") ==
          "2: found `# b`, expected the rest of the line before, no comment");
    CHECK(words_of("a\n# b \\\nc\n") == "a@1 c@3 ");
    CHECK(words_of("a\n# b \\\n# c \\\nd\n") == "a@1 d@4 ");
    CHECK(words_of("a\n#\\\nb\n") == "a@1 b@3 ");
    CHECK(words_of("a\n# b \\\n") == "a@1 ");
    // Not even where any word would be read, to be refused.
    CHECK(first_complaint("plcert 2 problem\nproblem 7*P/P/P\nverdict \\\n# over\n")
              .starts_with("file:4: does not conform to FORMAT.md: "));
}

TEST_CASE("each line in the file has at most 16384 bytes, its backslash included") {
    const std::string longest(16382, 'x');
    CHECK(words_of(longest + " \\\ny\n") == longest + "@1 y@2 ");
    CHECK(words_of("y \\\n" + longest + " \\\nz\n") == "y@1 " + longest + "@2 z@3 ");
    CHECK(words_of(longest + "x \\\ny\n").starts_with("1: found `xxx"));
    CHECK(words_of("y \\\n" + longest + "x \\\nz\n")
              .ends_with("expected a line feed within 16384 bytes"));
    CHECK(words_of("y \\\n" + longest + "x \\\nz\n").starts_with("2: "));
    std::string many; // there is no limit
    for (int n = 0; n < 1000; ++n)
        many += "x \\\n";
    CHECK(words_of(many + "x\n").ends_with("x@1000 x@1001 "));
}

TEST_CASE("a complaint names the line of the file in which the word stands") {
    CHECK(words_of("a \\\nb \\\nc\x01\n").starts_with("3: found `\\x01`"));
    CHECK(first_complaint("plcert \\\n2 classification\nmodulus \\\n7\n") ==
          "file:4: does not conform to FORMAT.md: found `7`, expected `2305843009213693951`\n");
    CHECK(first_complaint("plcert 2 classification\nmodulus 2305843009213693951 \\\n7\n") ==
          "file:3: does not conform to FORMAT.md: found `7`, expected the end of the line\n");
    CHECK(first_complaint("plcert 2 problem\nproblem P/P/P \\\n+ \\\nP/P\nverdict minimal\n")
              .starts_with("file:4: does not conform to FORMAT.md: found `P/P`"));
    CHECK(first_complaint("plcert \\\n1 problem\n").find("format 1") != std::string::npos);
}

TEST_CASE("continued lines of each kind of file say the same as those in one piece") {
    same_however_broken(few_classes(), few_certificates());
    const std::string corpus = "tests/fuzz/corpus/certificate/";
    // A minimal problem, one with steps, an obstructed one, a dimension count, one in two views.
    for (const char* number : {"1", "13", "7", "6", "4", "12", "3"})
        same_however_broken(all_classes(), file(corpus + "problem-" + number + ".plc"));
    same_however_broken({}, file("certs/models/p3p.plc"));
    const std::string format = file("certs/FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 degrees\n") + 1;
    same_however_broken(all_classes(), format.substr(start, format.find("```", start) - start));
}
