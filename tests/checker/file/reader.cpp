// Certificate files are read to the letter: bytes, lines, words, numbers, the first line.
#include "checker/replay.h"
#include "checker/version.h"
#include "tests/support/all_classes.h"
#include "tests/support/malformed_files.h"

using namespace checker;

namespace {

const std::string head =
    "plcert 2 classification\n# comment   with spaces\nmodulus 2305843009213693951\n";

/// The outcome of an action on a reader of these bytes: empty, or what is wrong.
template <class Action>
std::string outcome(const std::string& bytes, const Action& action) {
    try {
        Reader reader(bytes);
        action(reader);
        return "";
    } catch (const Malformed& malformed) {
        return say(malformed.complaint.line, ": ", malformed.complaint.reason);
    }
}

} // namespace

TEST_CASE("a file that is empty, or whose first line is wrong, does not conform") {
    CHECK(complaint("") == "0: found nothing, expected `plcert`");
    CHECK(complaint("# plcert\n") == "1: found `#`, expected `plcert`");
    CHECK(complaint("plcert 2 classification more\n") ==
          "1: found `more`, expected the end of the line");
    CHECK(complaint("plcert 2 classification\n") == "1: found nothing, expected `modulus`");
    CHECK(complaint("plcert 2 classification\nmodulus 7\n") ==
          "2: found `7`, expected `2305843009213693951`");
}

TEST_CASE("a file of format 1 is refused, and told what to do, whatever its kind") {
    const std::string advice = "1: this is a file of format 1: write it again with plprove 1.1 or "
                               "newer, or check it with plcheck 1.0";
    for (const std::string kind : {"classification", "problem", "degrees", "model", "catalogue"})
        CHECK(complaint("plcert 1 " + kind + "\n") == advice);
    CHECK(complaint("plcert 1\n") == advice);
}

TEST_CASE("a file of a later format is refused, and told that a newer plcheck reads it") {
    for (const std::string format : {"3", "10"})
        CHECK(complaint("plcert " + format + " problem\n") ==
              say("1: this is a file of format ", format, ", and plcheck ", software_version,
                  " reads format 2: check it with a newer plcheck"));
}

TEST_CASE("a version of the format is a number from 1, without leading zeros") {
    for (const std::string format : {"0", "01", "-2", "2.0", "two", "1000000"})
        CHECK(complaint("plcert " + format + " problem\n") ==
              "1: found `" + format + "`, expected an integer from 1 to 999999");
}

TEST_CASE("a file of an unknown kind is refused") {
    const std::string kinds =
        "`, expected `classification`, `problem`, `problems`, `solutions`, `at-most`, `degrees` "
        "or `model`";
    for (const std::string kind :
         {"catalogue", "digests", "Problem", "problemss", "Problems", "degree"})
        CHECK(complaint("plcert 2 " + kind + "\n") == "1: found `" + kind + kinds);
    CHECK(complaint("plcert 2\n") == "1: found `" + kinds);
}

TEST_CASE("bytes other than printable ASCII and line feeds do not conform") {
    CHECK(complaint("plcert 2 classification") ==
          "1: found `plcert 2 classification`, expected a line feed within 16384 bytes");
    CHECK(complaint("plcert 2 classification\r\n")
              .starts_with("1: found `\\x0d`, expected printable ASCII"));
    CHECK(complaint(std::string("plcert\0", 7) + "\n").starts_with("1: found `\\x00`"));
    CHECK(complaint("plcert\t1\n").starts_with("1: found `\\x09`"));
    CHECK(complaint("plcert 2 classificati\xc3\xb6n\n").starts_with("1: found `\\xc3`"));
    CHECK(complaint("plcert 2 classification\n# \x7f\n").starts_with("2: found `\\x7f`"));
}

TEST_CASE("words are separated by one space") {
    for (const char* first :
         {"plcert  2 classification\n", " plcert 2 classification\n", "plcert 2 classification \n"})
        CHECK(complaint(first).ends_with("expected words separated by one space"));
    CHECK(complaint("plcert 2 classification\n\n") ==
          "2: found nothing, expected words separated by one space");
}

TEST_CASE("a line has at most 16384 bytes, a file 64 MiB") {
    CHECK(complaint(head + "#" + std::string(16384, '-') + "\n")
              .ends_with("expected a line feed within 16384 bytes"));
    const std::string longest = head + "#" + std::string(16383, '-') + "\n" + pool;
    CHECK(
        std::holds_alternative<ClassificationFile>(replay(all_classes(), "file", longest).content));
    CHECK(complaint(std::string((64 << 20) + 1, '#')) == "0: the file is larger than 64 MiB");
    CHECK(complaint(std::string(64 << 20, '#')).starts_with("1: found `####"));
    CHECK_THROWS_AS(Reader(std::string((64 << 20) + 1, '#')), Malformed);
}

TEST_CASE("an integer has one spelling, and a range") {
    const auto with_point = [&](const std::string& x) {
        std::string text = head + pool;
        return complaint(text.replace(text.find("point 1") + 6, 1, x));
    };
    for (const std::string wrong : {"01", "-0", "+1", "1.0", "1e3", "1000000", "-1000000", "0x1",
                                    "--1", "-", "99999999999999999999", "a"})
        CHECK(with_point(wrong) ==
              "7: found `" + wrong + "`, expected an integer from -999999 to 999999");
    const auto integer = [](const std::string& word) {
        return outcome(word + "\n", [](Reader& reader) { reader.integer(-999'999, 999'999); });
    };
    for (const char* good : {"0", "7", "-7", "999999", "-999999", "10"})
        CHECK(integer(good) == "");
    const std::int64_t least = std::numeric_limits<std::int64_t>::min();
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::string bytes = say(least, ' ', most, '\n');
    Reader reader(bytes);
    CHECK(reader.integer(least, most) == least);
    CHECK(reader.integer(least, most) == most);
}

TEST_CASE("an integer of many digits has at most 1000") {
    const auto big = [](const std::string& word) {
        return outcome(word + "\n", [](Reader& reader) { reader.big_integer(1000); });
    };
    for (const std::string& good : {std::string("0"), std::string("-1"), std::string(1000, '9'),
                                    "-" + std::string(1000, '9')})
        CHECK(big(good) == "");
    for (const std::string& wrong :
         {std::string("-0"), std::string("00"), std::string("a"), std::string("-"),
          std::string(1001, '9'), "-" + std::string(1001, '9'), "0" + std::string(10, '1')})
        CHECK(big(wrong).ends_with("expected an integer of at most 1000 digits"));
}

TEST_CASE("a pattern takes coordinates, counts, words and ends of lines") {
    Reader reader("point -3 0 4\n# a comment\nminimal 7 1\nend\n");
    CHECK(reader.line() == 1);
    CHECK(reader.comes("point"));
    CHECK_FALSE(reader.comes("poin"));
    CHECK(reader.take("point @ @ @ $") == Numbers{-3, 0, 4});
    CHECK(reader.line() == 3);
    CHECK(reader.take("minimal # # $") == Numbers{7, 1});
    CHECK_FALSE(reader.at_end());
    CHECK(reader.take("end $").empty());
    CHECK(reader.at_end());
    const auto take = [](const std::string& bytes, std::string_view pattern) {
        return outcome(bytes, [&](Reader& other) { other.take(pattern); });
    };
    CHECK(take("point -3\n", "point #") == "1: found `-3`, expected an integer from 0 to 999999");
    CHECK(take("point 3\n", "points") == "1: found `point`, expected `points`");
    CHECK(take("point 3\n", "point $") == "1: found `3`, expected the end of the line");
    CHECK(take("point\n", "point #") == "1: found nothing, expected an integer from 0 to 999999");
}

TEST_CASE("hostile bytes do not reach the terminal") {
    CHECK(printable("\x1b[2J\n\\", 40) == "\\x1b[2J\\x0a\\x5c");
    CHECK(printable(std::string(100, 'a'), 40) == std::string(40, 'a') + "...");
    CHECK(printable(std::string(40, 'a'), 40) == std::string(40, 'a'));
    CHECK(printable("\xff", 40) == "\\xff");
    CHECK(replay(all_classes(), "\x1b[2J.plc", "").name == "\\x1b[2J.plc");
}
