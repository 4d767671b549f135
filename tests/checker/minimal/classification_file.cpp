// An archive altered in any field that matters is refused, and for the right reason. Most tests
// alter the certificates of five classes.
#include "tests/support/few_classes.h"
#include "tests/support/report.h"

using namespace checker;

namespace {

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

/// What a file about the five classes proves. It has to conform.
ClassificationFile replayed(const std::string& bytes) {
    const ReplayedFile file = replay(few_classes(), "few", bytes);
    REQUIRE(std::holds_alternative<ClassificationFile>(file.content));
    return std::get<ClassificationFile>(file.content);
}

/// Why a file does not conform.
std::string malformed(const std::string& bytes) {
    const ReplayedFile file = replay(few_classes(), "altered", bytes);
    REQUIRE(std::holds_alternative<Malformed>(file.content));
    return std::get<Malformed>(file.content).complaint.reason;
}

/// The only refusal of a file that conforms. The other classes hold.
std::string refusal(const std::string& bytes) {
    const ClassificationFile file = replayed(bytes);
    CHECK(file.refusals.count == 1);
    CHECK(file.verdicts.size() == few_numbers.size() - 1);
    REQUIRE(!file.refusals.first.empty());
    return file.refusals.first.front().reason;
}

Report report_on(const std::string& bytes) {
    return summarize(all_classes(), {replay(all_classes(), "archive", bytes)});
}

} // namespace

TEST_CASE("the archive holds, and gives the counts") {
    const Report report = report_on(archive());
    CHECK(report.status == 0);
    CHECK(complaints(report) == "");
    std::map<std::string, paper::Claim> claims;
    for (const paper::Claim& claim : report.claims)
        claims[claim.claim] = claim;
    CHECK(claims.size() == 22 + 3 + 12); // of the paper, of causes, of complete visibility
    CHECK(claims.size() == report.claims.size());
    CHECK(claims["label classes, not minimal"].certified == "2878");
    CHECK(claims["label classes, minimal"].certified == "140616");
    CHECK(claims["terminal camera-minimal"].certified == "74575");
    CHECK(claims["five-point extensions, minimal"].certified == "6413");
    CHECK(claims["five-point extensions, minimal"].verdict.starts_with(
        "differs: the authors' script"));
    CHECK(claims["- of these, camera registration"].verdict == "confirmed");
    CHECK(claims["- terminal camera-minimal"].certified == "3615");
    CHECK(claims["3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P"].verdict == "confirmed");
    CHECK(claims["- PL0Ps"].certified == "19");
    CHECK(claims["terminal, on Kileel's list (linear in the trifocal tensor)"].certified == "66");
    CHECK(claims["terminal, neither"].certified == "74499");
    std::map<std::string, std::size_t> verdicts;
    for (const paper::Claim& claim : report.claims)
        ++verdicts[claim.verdict.substr(0, claim.verdict.find(':'))];
    CHECK(verdicts == std::map<std::string, std::size_t>{
                          {"confirmed", 19 + 12}, {"differs", 3}, {"not in the paper", 3}});
    CHECK(json(report).find("\"certified\": 140616, \"verdict\": \"confirmed\"") !=
          std::string::npos);
}

TEST_CASE("the archive without one record, with one twice, with two in the wrong order") {
    const std::size_t line = archive().find("\nminimal 70000 ") + 1;
    REQUIRE(line > 0);
    const std::string record = archive().substr(line, archive().find('\n', line) + 1 - line);
    std::string text = archive();
    text.erase(line, record.size());
    Report report = report_on(text);
    CHECK(report.status == 1);
    CHECK(complaints(report).ends_with(": refused: class 70000: there is no certificate\n"));
    CHECK(report.claims[4].verdict == "not covered by these files");

    text = archive();
    text.insert(line, record);
    report = report_on(text);
    CHECK(report.status == 2);
    CHECK(complaints(report).ends_with("class 70000 is out of order\n"));

    text = archive();
    const std::size_t next = line + record.size();
    const std::string following = text.substr(next, text.find('\n', next) + 1 - next);
    REQUIRE(following.starts_with("minimal 70001 "));
    text.replace(line, record.size() + following.size(), following + record);
    report = report_on(text);
    CHECK(report.status == 2);
    CHECK(complaints(report).ends_with("class 70000 is out of order\n"));
}

TEST_CASE("the five classes hold") {
    const ClassificationFile file = replayed(few_certificates());
    CHECK(file.refusals.count == 0);
    CHECK(file.verdicts.size() == few_numbers.size());
}

TEST_CASE("header and modulus") {
    CHECK(malformed(altered(few_certificates(), "plcert 2 ", 0, "catalogue")) ==
          "found `catalogue`, expected `classification`, `problem`, `problems`, `solutions`, "
          "`at-most`, "
          "`degrees` or `model`");
    CHECK(malformed(altered(few_certificates(), "modulus ", 0, "2305843009213693949")) ==
          "found `2305843009213693949`, expected `2305843009213693951`");
    CHECK(malformed(without_line(few_certificates(), "modulus")) ==
          "found `pool`, expected `modulus`");
}

TEST_CASE("class and pool of a record") {
    CHECK(refusal(altered(few_certificates(), "minimal 2", 1, "2")) ==
          "class 2: there is no such pool");
    CHECK(refusal(altered(few_certificates(), "minimal 2", 1, "0")) ==
          "class 2: there is no such pool");
    CHECK(refusal(without_line(few_certificates(), "minimal 2")) ==
          "class 2: there is no certificate");
    std::string beyond = few_certificates();
    beyond.replace(beyond.find("deficient 4"), 11, "deficient 5");
    const ClassificationFile file = replayed(beyond);
    CHECK(file.refusals.count == 2);
    CHECK(file.refusals.first[0].reason == "class 4: there is no certificate");
    CHECK(file.refusals.first[1].reason == "class 5: there is no such class");
    // The certificate of one class under the number of another.
    std::string swapped = without_line(few_certificates(), "minimal 1 ");
    swapped = altered(swapped, "minimal ", 0, "1");
    const ClassificationFile wrong = replayed(swapped);
    CHECK(wrong.refusals.count == 2);
    CHECK(wrong.refusals.first[0].reason.starts_with("class 1: the minor is "));
    CHECK(wrong.refusals.first[1].reason == "class 2: there is no certificate");
}

TEST_CASE("minors") {
    CHECK(refusal(altered(few_certificates(), "minimal 1 ", 1, "1"))
              .starts_with("class 1: the minor is "));
    CHECK(refusal(altered(few_certificates(), "minor ", 0, "7"))
              .starts_with("class 0: the minor is "));
    CHECK(malformed(altered(few_certificates(), "minor ", 0, "0")) ==
          "found `0`, expected an integer from 1 to 2305843009213693950");
}

TEST_CASE("verdicts, ranks, excesses, stars") {
    const std::string star = "class 0: it has rank 10, excess 0 0 0, S 1";
    const std::string excess = "class 4: it has rank 5, excess 0 0 6, S 0";
    CHECK(refusal(altered(few_certificates(), "deficient 0 1 rank ", 0, "9")) == star);
    CHECK(refusal(altered(few_certificates(), "deficient 0 1 rank ", 2, "1")) == star);
    CHECK(refusal(altered(few_certificates(), "deficient 0 1 rank ", 6, "0")) == star);
    CHECK(refusal(altered(few_certificates(), "deficient 4 1 rank ", 0, "6")) == excess);
    CHECK(refusal(altered(few_certificates(), "deficient 4 1 rank ", 4, "5")) == excess);
    CHECK(refusal(altered(few_certificates(), "deficient 4 1 rank ", 3, "6")) == excess);
    CHECK(refusal(altered(few_certificates(), "deficient 4 1 rank ", 6, "1")) == excess);

    std::string text = few_certificates(); // an obstructed class called minimal
    std::size_t begin = text.find("deficient 0"), end = text.find("minimal 1");
    CHECK(refusal(text.replace(begin, end - begin, "minimal 0 1 1\n")) == star);
    text = few_certificates(); // a minimal one called obstructed
    begin = text.find("minimal 1"), end = text.find("minimal 2");
    const std::string claim = "deficient 1 1 rank 10 excess 0 0 0 star 1\ndelete rows 1 columns 1\n"
                              "minor 1\nkernel 1 0 0 0 0 0 0 0 0 0 0\n";
    CHECK(refusal(text.replace(begin, end - begin, claim)) ==
          "class 1: it has rank 11, excess 0 0 0, S 0");
}

TEST_CASE("deleted rows and columns") {
    const std::string count =
        "class 4: there must be 6 deleted rows, deleted columns and kernel vectors";
    const std::string lists = "delete rows 24 28 32 36 40 44 columns 6 7 8 9 10 11\n";
    const auto with = [&](const std::string& other) {
        std::string text = few_certificates();
        return text.replace(text.find(lists), lists.size(), other + "\n");
    };
    CHECK(refusal(with("delete rows 24 28 32 36 40 columns 6 7 8 9 10 11")) == count);
    CHECK(refusal(with("delete rows 24 28 32 36 40 43 44 columns 6 7 8 9 10 11")) == count);
    CHECK(refusal(with("delete rows 24 28 32 36 40 44 columns 6 7 8 9 10")) == count);
    CHECK(refusal(with("delete rows 24 28 32 36 40 45 columns 6 7 8 9 10 11")) ==
          "class 4: J has only 44 rows");
    CHECK(refusal(with("delete rows 23 28 32 36 40 44 columns 6 7 8 9 10 11"))
              .starts_with("class 4: the minor is "));
    CHECK(refusal(with("delete rows 24 28 32 36 40 44 columns 5 7 8 9 10 11"))
              .starts_with("class 4: the minor is "));
    CHECK(malformed(with("delete rows 28 24 32 36 40 44 columns 6 7 8 9 10 11")) ==
          "found `24`, expected an integer from 29 to 999999");
    CHECK(malformed(with("delete rows 24 28 32 36 40 44 columns 6 7 8 9 10 12")) ==
          "found `12`, expected an integer from 11 to 11");
    CHECK(malformed(with("delete rows columns 6")).starts_with("found `columns`, expected"));
}

TEST_CASE("kernel vectors") {
    const std::string first = "kernel -1 -12 12 0 0 17 0 0 0 0 0\n";
    const std::string second = "kernel 12 8 9 0 0 0 17 0 0 0 0\n";
    const auto with = [&](const std::string& other) {
        std::string text = few_certificates();
        return text.replace(text.find(first), first.size(), other);
    };
    const std::string name = "class 4: kernel vector 1 ";
    CHECK(refusal(with("kernel -1 -12 12 0 1 17 0 0 0 0 0\n")) ==
          name + "does not keep all images");
    CHECK(refusal(with("kernel -2 -12 12 0 0 17 0 0 0 0 0\n")) ==
          name + "does not keep all images");
    CHECK(refusal(with("kernel -2 -24 24 0 0 34 0 0 0 0 0\n")) ==
          name + "has entries with a common divisor");
    CHECK(refusal(with("kernel 1 12 -12 0 0 -17 0 0 0 0 0\n")) ==
          name + "is not in basis form at deleted column 1");
    CHECK(refusal(with("kernel -1 -12 12 0 0 17 1 0 0 0 0\n")) ==
          name + "is not in basis form at deleted column 2");
    CHECK(refusal(with(second)) == name + "is not in basis form at deleted column 1");
    CHECK(refusal(with("")) ==
          "class 4: there must be 6 deleted rows, deleted columns and kernel vectors");
    CHECK(refusal(with(first + first)) ==
          "class 4: there must be 6 deleted rows, deleted columns and kernel vectors");
    const auto repeated = [&](int times) {
        std::string lines;
        for (int i = 0; i < times; ++i)
            lines += first;
        return lines;
    };
    CHECK(refusal(with(repeated(6))) == // eleven together
          "class 4: there must be 6 deleted rows, deleted columns and kernel vectors");
    CHECK(malformed(with(repeated(7))) == "found `kernel`, expected at most 11 kernel vectors");
    CHECK(malformed(with("kernel -1 -12 12 0 0 17 0 0 0 0\n")) ==
          "found nothing, expected an integer of at most 1000 digits");
    CHECK(malformed(with("kernel " + std::string(1001, '7') + " -12 12 0 0 17 0 0 0 0 0\n"))
              .ends_with("expected an integer of at most 1000 digits"));
}

TEST_CASE("coordinates and cameras") {
    // What the five classes use: every minor or motion that the change concerns is wrong.
    const auto refused = [](const std::string& text) {
        const ClassificationFile file = replayed(text);
        REQUIRE(file.refusals.count > 0);
        for (const auto& [line, reason] : file.refusals.first)
            CHECK(reason.find(": the minor is ") != reason.npos);
        return file.refusals.count;
    };
    CHECK(refused(altered(few_certificates(), "camera 2 quaternion ", 0, "5")) == 5);
    CHECK(refused(altered(few_certificates(), "camera 3 quaternion ", 6, "11")) == 5);
    CHECK(refused(altered(few_certificates(), "camera 2 quaternion ", 5, "11")) == 5);
    CHECK(refused(altered(few_certificates(), "feature P/P/P point ", 1, "11")) > 0);
    CHECK(refused(altered(few_certificates(), "feature Pa/Pa/Pa point ", 4, "11")) > 0);

    const auto first_reason = [](const std::string& text) {
        const ClassificationFile file = replayed(text);
        CHECK(file.refusals.count == 6);
        CHECK(file.refusals.first[1].reason == "class 0: its pool is refused");
        return file.refusals.first.at(0).reason;
    };
    CHECK(first_reason(altered(few_certificates(), "camera 2 quaternion 0 0 1 1 translation ", 0,
                               "0")) == "pool 1: the translation of camera 2 begins with 0");
    CHECK(first_reason(altered(few_certificates(), "feature Pa/Pa/Pa point ", 2, "0")) ==
          "pool 1: an image of the point has third coordinate 0");
    CHECK(first_reason(altered(few_certificates(), "feature Pa/Pa/Pa point ", 6, "0")) ==
          "pool 1: a direction has third coordinate 0");

    // Cameras are refused at the line of their pool, a feature at its own.
    const auto first_line = [](const std::string& text) {
        return replayed(text).refusals.first.at(0).line;
    };
    const std::string text = few_certificates();
    const std::size_t pool = std::ranges::count(text.substr(0, text.find("pool 1")), '\n') + 1;
    CHECK(first_line(altered(text, "camera 2 quaternion 0 0 1 1 translation ", 0, "0")) == pool);
    const std::size_t feature =
        std::ranges::count(text.substr(0, text.find("feature Pa/Pa/Pa point ")), '\n') + 1;
    CHECK(first_line(altered(text, "feature Pa/Pa/Pa point ", 2, "0")) == feature);
}

TEST_CASE("features of the pool") {
    std::string text = few_certificates();
    const std::string type = "feature Pa/Pa/Pa ";
    while (text.find(type) != text.npos)
        text = without_line(text, type);
    const ClassificationFile file = replayed(text);
    REQUIRE(file.refusals.count > 0);
    for (const auto& [line, reason] : file.refusals.first)
        CHECK(reason.ends_with("its pool has too few Pa/Pa/Pa"));
}
