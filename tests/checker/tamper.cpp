// An archive altered in any field that matters is refused, and for the right reason. Most tests
// alter the certificates of five classes, taken from the archive and renumbered; the checker is
// given these classes instead of all, and runs as always.
#include "checker/report.h"

#include <doctest/doctest.h>

#include <fstream>
#include <map>

using namespace checker;

namespace {

const Classification& all_classes() {
    static const Classification classes = classify();
    return classes;
}

const std::string& archive() {
    static const std::string bytes = [] {
        std::ifstream in(CERTS_DIR "/classification.plc", std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }();
    return bytes;
}

/// A star, a minimal class, Chicago, epipolar excess 1, and excess 6.
const std::vector<std::size_t> numbers{0, 4, 2394, 5093, 130456};

Classification few_classes() {
    Classification few{.signatures = numbers.size()};
    for (const std::size_t number : numbers) {
        few.swap_class.push_back(few.representatives.size());
        few.representatives.push_back(all_classes().representatives[number]);
    }
    return few;
}

/// The pool of the archive and the records of the five classes, with new numbers.
const std::string& few() {
    static const std::string text = [] {
        std::map<std::string, std::size_t> renumbered;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            renumbered[say(numbers[i])] = i;
        std::istringstream lines(archive());
        std::string result;
        bool wanted = true;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string kind, number, rest;
            words >> kind >> number;
            if (kind == "minimal" || kind == "deficient") {
                const auto place = renumbered.find(number);
                wanted = place != renumbered.end();
                std::getline(words, rest);
                if (wanted) line = say(kind, ' ', place->second, rest);
            }
            if (wanted) result += line + "\n";
        }
        return result;
    }();
    return text;
}

/// Replaces the n-th of the words after the first `start`; the line break after it is kept.
std::string altered(std::string text, const std::string& start, std::size_t n,
                    const std::string& word) {
    std::size_t begin = text.find(start);
    REQUIRE(begin != text.npos);
    begin += start.size();
    for (; n > 0; --n)
        begin = text.find_first_of(" \n", begin) + 1;
    return text.replace(begin, text.find_first_of(" \n", begin) - begin, word);
}

std::string without_line(std::string text, const std::string& start) {
    const std::size_t begin = text.find(start);
    REQUIRE(begin != text.npos);
    return text.erase(begin, text.find('\n', begin) + 1 - begin);
}

/// The only complaint about a file; it is a refusal, unless the file does not conform.
std::string complaint(const std::string& bytes, bool conforms = true) {
    const FileReport report = replay(few_classes(), "altered", bytes);
    CHECK(report.conforms == conforms);
    CHECK(report.refused == (conforms ? 1 : 0));
    CHECK(report.verdicts.size() == (conforms ? numbers.size() - 1 : 0));
    REQUIRE(!report.complaints.empty());
    return report.complaints.front().reason;
}

} // namespace

TEST_CASE("the archive holds, and gives the counts") {
    const Report report = summarize(all_classes(), {replay(all_classes(), "archive", archive())});
    CHECK(report.status == 0);
    CHECK(complaints(report) == "");
    std::map<std::string, Claim> claims;
    for (const Claim& claim : report.claims)
        claims[claim.claim] = claim;
    CHECK(claims.size() == 28);
    CHECK(claims["label classes, not minimal"].certified == "2878");
    CHECK(claims["label classes, minimal"].certified == "140616");
    CHECK(claims["terminal camera-minimal"].certified == "74575");
    CHECK(claims["five-point extensions, minimal"].certified == "6413");
    CHECK(claims["five-point extensions, minimal"].verdict.starts_with(
        "differs: the authors' script"));
    CHECK(claims["- of these, camera registration"].verdict == "confirmed");
    CHECK(claims["- terminal camera-minimal"].certified == "3615");
    CHECK(claims["3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P"].verdict == "confirmed");
    std::size_t differ = 0;
    for (const Claim& claim : report.claims)
        differ += claim.verdict.starts_with("differs");
    CHECK(differ == 2);
    CHECK(json(report).find("\"certified\": 140616, \"verdict\": \"confirmed\"") !=
          std::string::npos);
}

TEST_CASE("the archive without one record, with one twice, with two in the wrong order") {
    const std::size_t line = archive().find("\nminimal 70000 ") + 1;
    REQUIRE(line > 0);
    const std::string record = archive().substr(line, archive().find('\n', line) + 1 - line);
    std::string text = archive();
    text.erase(line, record.size());
    Report report = summarize(all_classes(), {replay(all_classes(), "archive", text)});
    CHECK(report.status == 1);
    CHECK(complaints(report).ends_with(": refused: class 70000: there is no certificate\n"));
    CHECK(report.claims[4].verdict == "not covered by these files");

    text = archive();
    text.insert(line, record);
    report = summarize(all_classes(), {replay(all_classes(), "archive", text)});
    CHECK(report.status == 2);
    CHECK(complaints(report).ends_with("class 70000 comes too late\n"));

    text = archive();
    const std::size_t next = line + record.size();
    const std::string following = text.substr(next, text.find('\n', next) + 1 - next);
    REQUIRE(following.starts_with("minimal 70001 "));
    text.replace(line, record.size() + following.size(), following + record);
    report = summarize(all_classes(), {replay(all_classes(), "archive", text)});
    CHECK(report.status == 2);
    CHECK(complaints(report).ends_with("class 70000 comes too late\n"));
}

TEST_CASE("the five classes hold") {
    const FileReport report = replay(few_classes(), "few", few());
    CHECK(report.conforms);
    CHECK(report.refused == 0);
    CHECK(report.verdicts.size() == numbers.size());
}

TEST_CASE("header and modulus") {
    CHECK(complaint(altered(few(), "plcert ", 0, "2"), false) == "found `2`, expected `1`");
    CHECK(complaint(altered(few(), "plcert 1 ", 0, "catalogue"), false) ==
          "found `catalogue`, expected `classification`");
    CHECK(complaint(altered(few(), "modulus ", 0, "2305843009213693949"), false) ==
          "found `2305843009213693949`, expected `2305843009213693951`");
    CHECK(complaint(without_line(few(), "modulus"), false) == "found `pool`, expected `modulus`");
}

TEST_CASE("class and pool of a record") {
    CHECK(complaint(altered(few(), "minimal 2", 1, "2"), true) == "class 2: there is no such pool");
    CHECK(complaint(altered(few(), "minimal 2", 1, "0"), true) == "class 2: there is no such pool");
    CHECK(complaint(without_line(few(), "minimal 2")) == "class 2: there is no certificate");
    std::string beyond = few();
    beyond.replace(beyond.find("deficient 4"), 11, "deficient 5");
    const FileReport report = replay(few_classes(), "few", beyond);
    CHECK(report.refused == 2);
    CHECK(report.complaints[0].reason == "class 4: there is no certificate");
    CHECK(report.complaints[1].reason == "class 5: there is no such class");
    // The certificate of one class under the number of another.
    std::string swapped = without_line(few(), "minimal 1 ");
    swapped = altered(swapped, "minimal ", 0, "1");
    const FileReport wrong = replay(few_classes(), "few", swapped);
    CHECK(wrong.refused == 2);
    CHECK(wrong.complaints[0].reason.starts_with("class 1: the minor is "));
    CHECK(wrong.complaints[1].reason == "class 2: there is no certificate");
}

TEST_CASE("minors") {
    CHECK(complaint(altered(few(), "minimal 1 ", 1, "1")).starts_with("class 1: the minor is "));
    CHECK(complaint(altered(few(), "minor ", 0, "7")).starts_with("class 0: the minor is "));
    CHECK(complaint(altered(few(), "minor ", 0, "0"), false) ==
          "found `0`, expected an integer from 1 to 2305843009213693950");
}

TEST_CASE("verdicts, ranks, excesses, stars") {
    const std::string star = "class 0: it has rank 10, excess 0 0 0, S 1";
    const std::string excess = "class 4: it has rank 5, excess 0 0 6, S 0";
    CHECK(complaint(altered(few(), "deficient 0 1 rank ", 0, "9")) == star);
    CHECK(complaint(altered(few(), "deficient 0 1 rank ", 2, "1")) == star);
    CHECK(complaint(altered(few(), "deficient 0 1 rank ", 6, "0")) == star);
    CHECK(complaint(altered(few(), "deficient 4 1 rank ", 0, "6")) == excess);
    CHECK(complaint(altered(few(), "deficient 4 1 rank ", 4, "5")) == excess);
    CHECK(complaint(altered(few(), "deficient 4 1 rank ", 3, "6")) == excess);
    CHECK(complaint(altered(few(), "deficient 4 1 rank ", 6, "1")) == excess);

    std::string text = few(); // an obstructed class called minimal
    std::size_t begin = text.find("deficient 0"), end = text.find("minimal 1");
    CHECK(complaint(text.replace(begin, end - begin, "minimal 0 1 1\n")) == star);
    text = few(); // a minimal one called obstructed
    begin = text.find("minimal 1"), end = text.find("minimal 2");
    const std::string claim = "deficient 1 1 rank 10 excess 0 0 0 star 1\ndelete rows 1 columns 1\n"
                              "minor 1\nkernel 1 0 0 0 0 0 0 0 0 0 0\n";
    CHECK(complaint(text.replace(begin, end - begin, claim)) ==
          "class 1: it has rank 11, excess 0 0 0, S 0");
}

TEST_CASE("deleted rows and columns") {
    const std::string count =
        "class 4: there must be 6 deleted rows, deleted columns and kernel vectors";
    const std::string lists = "delete rows 24 28 32 36 40 44 columns 6 7 8 9 10 11\n";
    const auto with = [&](const std::string& other) {
        std::string text = few();
        return text.replace(text.find(lists), lists.size(), other + "\n");
    };
    CHECK(complaint(with("delete rows 24 28 32 36 40 columns 6 7 8 9 10 11")) == count);
    CHECK(complaint(with("delete rows 24 28 32 36 40 43 44 columns 6 7 8 9 10 11")) == count);
    CHECK(complaint(with("delete rows 24 28 32 36 40 44 columns 6 7 8 9 10")) == count);
    CHECK(complaint(with("delete rows 24 28 32 36 40 45 columns 6 7 8 9 10 11")) ==
          "class 4: J has only 44 rows");
    CHECK(complaint(with("delete rows 23 28 32 36 40 44 columns 6 7 8 9 10 11"))
              .starts_with("class 4: the minor is "));
    CHECK(complaint(with("delete rows 24 28 32 36 40 44 columns 5 7 8 9 10 11"))
              .starts_with("class 4: the minor is "));
    CHECK(complaint(with("delete rows 28 24 32 36 40 44 columns 6 7 8 9 10 11"), false) ==
          "found `24`, expected an integer from 29 to 999999");
    CHECK(complaint(with("delete rows 24 28 32 36 40 44 columns 6 7 8 9 10 12"), false) ==
          "found `12`, expected an integer from 11 to 11");
    CHECK(complaint(with("delete rows columns 6"), false).starts_with("found `columns`, expected"));
}

TEST_CASE("kernel vectors") {
    const std::string first = "kernel -1 -12 12 0 0 17 0 0 0 0 0\n";
    const std::string second = "kernel 12 8 9 0 0 0 17 0 0 0 0\n";
    const auto with = [&](const std::string& other) {
        std::string text = few();
        return text.replace(text.find(first), first.size(), other);
    };
    const std::string name = "class 4: kernel vector 1 ";
    CHECK(complaint(with("kernel -1 -12 12 0 1 17 0 0 0 0 0\n")) ==
          name + "does not keep all images");
    CHECK(complaint(with("kernel -2 -12 12 0 0 17 0 0 0 0 0\n")) ==
          name + "does not keep all images");
    CHECK(complaint(with("kernel -2 -24 24 0 0 34 0 0 0 0 0\n")) ==
          name + "has entries with a common divisor");
    CHECK(complaint(with("kernel 1 12 -12 0 0 -17 0 0 0 0 0\n")) ==
          name + "has not the form of a basis at deleted column 1");
    CHECK(complaint(with("kernel -1 -12 12 0 0 17 1 0 0 0 0\n")) ==
          name + "has not the form of a basis at deleted column 2");
    CHECK(complaint(with(second)) == name + "has not the form of a basis at deleted column 1");
    CHECK(complaint(with("")) ==
          "class 4: there must be 6 deleted rows, deleted columns and kernel vectors");
    CHECK(complaint(with(first + first)) ==
          "class 4: there must be 6 deleted rows, deleted columns and kernel vectors");
    CHECK(complaint(with("kernel -1 -12 12 0 0 17 0 0 0 0\n"), false) ==
          "found nothing, expected an integer of at most 1000 digits");
    CHECK(complaint(with("kernel " + std::string(1001, '7') + " -12 12 0 0 17 0 0 0 0 0\n"), false)
              .ends_with("expected an integer of at most 1000 digits"));
}

TEST_CASE("coordinates and cameras") {
    // What the five classes use: every minor or motion that the change concerns is wrong.
    const auto refused = [](const std::string& text) {
        const FileReport report = replay(few_classes(), "few", text);
        CHECK(report.conforms);
        REQUIRE(report.refused > 0);
        for (const auto& [line, reason] : report.complaints)
            CHECK(reason.find(": the minor is ") != reason.npos);
        return report.refused;
    };
    CHECK(refused(altered(few(), "camera 2 quaternion ", 0, "5")) == 5);
    CHECK(refused(altered(few(), "camera 3 quaternion ", 6, "11")) == 5);
    CHECK(refused(altered(few(), "camera 2 quaternion ", 5, "11")) == 5);
    CHECK(refused(altered(few(), "feature P/P/P point ", 1, "11")) > 0);
    CHECK(refused(altered(few(), "feature Pa/Pa/Pa point ", 4, "11")) > 0);

    const auto first_reason = [](const std::string& text) {
        const FileReport report = replay(few_classes(), "few", text);
        CHECK(report.refused == 6);
        CHECK(report.complaints[1].reason == "class 0: its pool is refused");
        return report.complaints.at(0).reason;
    };
    CHECK(first_reason(altered(few(), "camera 2 quaternion 0 0 1 1 translation ", 0, "0")) ==
          "pool 1: the translation of camera 2 begins with 0");
    CHECK(first_reason(altered(few(), "feature Pa/Pa/Pa point ", 2, "0")) ==
          "pool 1: an image of the point has third coordinate 0");
    CHECK(first_reason(altered(few(), "feature Pa/Pa/Pa point ", 6, "0")) ==
          "pool 1: a direction has third coordinate 0");
}

TEST_CASE("features of the pool") {
    std::string text = few();
    const std::string type = "feature Pa/Pa/Pa ";
    while (text.find(type) != text.npos)
        text = without_line(text, type);
    const FileReport report = replay(few_classes(), "few", text);
    REQUIRE(report.refused > 0);
    for (const auto& [line, reason] : report.complaints)
        CHECK(reason.ends_with("its pool has too few Pa/Pa/Pa"));
}
