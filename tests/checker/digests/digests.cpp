// Digests: known vectors, and what a list of them says of files.
#include "checker/digests/sha256.h"
#include "tests/support/report.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

TEST_CASE("SHA-256 of known texts") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    // One byte less than fits in a block, as many, one more.
    CHECK(sha256(std::string(55, 'a')) ==
          "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    CHECK(sha256(std::string(56, 'a')) ==
          "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
    CHECK(sha256(std::string(64, 'a')) ==
          "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

namespace {

const std::string problem = "plcert 2 problem\nproblem 7*P/P/P\nverdict over-constrained 10\n";

Report report_of(const std::string& list, const std::string& path,
                 const std::string& list_path = "SHA256SUMS") {
    const Classification none;
    return summarize(none, {replay(none, path, problem), replay(none, list_path, list)});
}

const std::string right = sha256(problem), wrong = sha256("");

} // namespace

TEST_CASE("a place is a path from the root, without detours") {
    CHECK(place_of("a.plc", "/home/me") == "/home/me/a.plc");
    CHECK(place_of("/a.plc", "/home/me") == "/a.plc");
    CHECK(place_of("./b//./a.plc", "/home/me/") == "/home/me/b/a.plc");
    CHECK(place_of("../a.plc", "/home/me") == "/home/a.plc");
    CHECK(place_of("b/../../c/a.plc", "/home/me") == "/home/c/a.plc");
    CHECK(place_of("../../../../a.plc", "/home/me") == "/a.plc");
    CHECK(folder_of("/home/me/a.plc") == "/home/me");
    CHECK(folder_of("/a.plc").empty());
    CHECK(working_folder().starts_with('/'));
}

TEST_CASE("a file with the digest that is listed, however its name is spelled") {
    const std::string here = working_folder();
    const std::vector<std::array<std::string, 3>> spellings{
        {"seven.plc", "seven.plc", "SHA256SUMS"},
        {"./seven.plc", "seven.plc", "SHA256SUMS"},
        {"seven.plc", "./some/../seven.plc", "SHA256SUMS"},
        {"some/../seven.plc", "seven.plc", "./SHA256SUMS"},
        {"seven.plc", "certs/seven.plc", "certs/SHA256SUMS"},
        {"degrees/seven.plc", "certs/degrees/seven.plc", "certs/SHA256SUMS"},
        {"../seven.plc", "seven.plc", "certs/SHA256SUMS"},
        {"seven.plc", here + "/seven.plc", "SHA256SUMS"},
        {here + "/seven.plc", "seven.plc", "certs/SHA256SUMS"},
        {"seven.plc\r", "seven.plc", "SHA256SUMS"}};
    for (const auto& [name, path, list] : spellings) {
        CAPTURE(name);
        const Report good = report_of(right + "  " + name + "\n", path, list);
        CHECK(good.status == 0);
        CHECK(good.findings.comparisons[0].digest == "as in " + list);
        CHECK(good.findings.comparisons[1].listed == 1);
        CHECK(contains(json(good), "\"digest\": \"as in " + list + "\""));
        CHECK(contains(detailed(good), "lists 1 given file\n"));
        const Report bad = report_of(wrong + "  " + name + "\n", path, list);
        CHECK(bad.status == 1);
        CHECK(bad.findings.comparisons[0].digest == "not as in " + list);
    }
}

TEST_CASE("a file with another digest is refused, and what it proves does not count") {
    const Report report = report_of(wrong + "  seven.plc\n", "seven.plc");
    CHECK(report.status == 1);
    CHECK(complaints(report) == say("seven.plc:0: refused: its SHA-256 digest is ", right,
                                    ", in SHA256SUMS it is ", wrong, "\n"));
    CHECK(conclusion(report) == "NOT VERIFIED: 1 of 2 files is refused (seven.plc)\n");
    const ExpectedProblem expected{.problem = parse_problem("7*P/P/P"),
                                   .verdict = "over-constrained"};
    const Classification none;
    CHECK(judge(none, report_of(right + "  seven.plc\n", "seven.plc").findings, expected).verified);
    CHECK_FALSE(judge(none, report.findings, expected).verified);
}

TEST_CASE("a list that has none of the files given is refused, as it says nothing") {
    for (const std::string name :
         {"other.plc", "more-seven.plc", "folder/seven.plc", "Seven.plc"}) {
        const Report report = report_of(wrong + "  " + name + "\n", "seven.plc");
        CHECK(report.status == 1);
        CHECK(report.findings.comparisons[0].digest.empty());
        CHECK(report.findings.comparisons[1].not_given == std::vector{name});
        CHECK(contains(complaints(report), "SHA256SUMS:0: refused: it lists none of the files "));
        CHECK(contains(json(report), "\"not_verified\": [\n  \"" + name + "\"]"));
    }
    // The list is of the files beside it, not of files with the same name elsewhere.
    const Classification none;
    const Report elsewhere =
        summarize(none, {replay(none, "certs/seven.plc", problem),
                         replay(none, "other/seven.plc", problem + "# another\n"),
                         replay(none, "certs/SHA256SUMS", right + "  seven.plc\n")});
    CHECK(elsewhere.findings.comparisons[1].objections.empty());
    CHECK(elsewhere.findings.comparisons[2].listed == 1);
}

TEST_CASE("lists alone verify nothing, even if they list each other") {
    const Classification none;
    CHECK(summarize(none, {replay(none, "SHA256SUMS", right + "  seven.plc\n")}).status == 1);
    DigestList list_of_other{{{"1", "two"}}}, list_of_one{{{"2", "one"}}};
    const Report report = summarize(none, {{"one", "2", list_of_other}, {"two", "1", list_of_one}});
    CHECK(report.findings.status == 0);
    CHECK(report.status == 1);
    CHECK(conclusion(report) == "NOT VERIFIED: no certificate among these files; give one, too\n");
}

TEST_CASE("of many names that are not given the first 20 are told, the rest counted") {
    std::string list = right + "  seven.plc\n";
    for (int i = 0; i < 25; ++i)
        list += wrong + "  " + std::to_string(i) + ".plc\n";
    const Report report = report_of(list, "seven.plc");
    CHECK(report.status == 0);
    CHECK(report.findings.comparisons[1].not_given.size() == 20);
    CHECK(contains(detailed(report), "SHA256SUMS lists 1 given file; 25 not given\n"));
}

TEST_CASE("a list of digests is read to the letter") {
    const std::string digest = sha256("");
    for (const std::string& second :
         {digest + " name\n", digest + "  name", digest + "  \n", digest + "  \r\n",
          digest + " *name\n", digest.substr(1) + "  name\n", "A" + digest.substr(1) + "  name\n",
          std::string("\n"), "0" + digest + "  name\n"}) {
        const Report report = report_of(digest + "  name\n" + second, "seven.plc");
        CHECK(report.status == 2);
        CHECK(complaints(report) ==
              "SHA256SUMS:2: does not conform to FORMAT.md: expected a SHA-256 digest, two spaces, "
              "a name\n");
    }
}

TEST_CASE("every list of digests is compared with every file, and one that differs is enough") {
    const Classification none;
    const std::string good = right + "  seven.plc\n";
    const std::string bad = wrong + "  seven.plc\n";
    for (const bool good_first : {false, true}) {
        const Report report = summarize(none, {replay(none, "seven.plc", problem),
                                               replay(none, "one", good_first ? good : bad),
                                               replay(none, "two", good_first ? bad : good)});
        CHECK(report.status == 1);
        CHECK(report.findings.comparisons[0].objections.size() == 1);
        CHECK(report.findings.comparisons[0].digest ==
              (good_first ? "not as in two" : "not as in one"));
    }
    const Report both =
        summarize(none, {replay(none, "seven.plc", problem), replay(none, "./seven.plc", problem),
                         replay(none, "sums", bad)});
    CHECK(both.findings.comparisons[0].objections.size() == 1);
    CHECK(both.findings.comparisons[1].objections.size() == 1);
}
