// Digests: known vectors, and what a list of them says of files.
#include "checker/digests/sha256.h"
#include "checker/report/report.h"

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

Report report_of(const std::string& list, const std::string& path) {
    const Classification none;
    return summarize(none, {replay(none, path, problem), replay(none, "SHA256SUMS", list)});
}

} // namespace

TEST_CASE("a file with the digest that is listed") {
    const std::string digest = sha256(problem);
    for (const std::string path : {"seven.plc", "some/folder/seven.plc"}) {
        const Report report = report_of(digest + "  seven.plc\n", path);
        CHECK(report.status == 0);
        CHECK(text(report).find("digest as in SHA256SUMS") != std::string::npos);
        CHECK(text(report).find("SHA256SUMS: a list of 1 digest\n") != std::string::npos);
        CHECK(json(report).find("\"digest\": \"as in SHA256SUMS\"") != std::string::npos);
    }
    const Report deeper = report_of(digest + "  folder/seven.plc\n", "a/folder/seven.plc");
    CHECK(deeper.comparisons[0].digest == "as in SHA256SUMS");
}

TEST_CASE("a file with another digest is refused") {
    const Report report = report_of(sha256("") + "  seven.plc\n", "seven.plc");
    CHECK(report.status == 1);
    CHECK(complaints(report) == say("seven.plc:0: refused: its SHA-256 digest is ", sha256(problem),
                                    ", in SHA256SUMS it is ", sha256(""), "\n"));
    CHECK(text(report).find("digest not as in SHA256SUMS") != std::string::npos);
}

TEST_CASE("what is listed and not given is not verified") {
    for (const std::string name : {"other.plc", "more-seven.plc", "folder/seven.plc"}) {
        const Report report = report_of(sha256("") + "  " + name + "\n", "seven.plc");
        CHECK(report.status == 0);
        CHECK(report.comparisons[0].digest.empty());
        CHECK(text(report).find("- not verified, as it was not given: " + name) !=
              std::string::npos);
        CHECK(report.comparisons[1].not_given == std::vector{name});
        CHECK(json(report).find("\"not_verified\": [\n  \"" + name + "\"]") != std::string::npos);
    }
}

TEST_CASE("a list of digests is read to the letter") {
    const std::string digest = sha256("");
    for (const std::string& second :
         {digest + " name\n", digest + "  name", digest + "  \n", digest + " *name\n",
          digest.substr(1) + "  name\n", "A" + digest.substr(1) + "  name\n", std::string("\n"),
          "0" + digest + "  name\n"}) {
        const Report report = report_of(digest + "  name\n" + second, "seven.plc");
        CHECK(report.status == 2);
        CHECK(complaints(report) ==
              "SHA256SUMS:2: does not conform to FORMAT.md: expected a SHA-256 digest, two spaces, "
              "a name\n");
    }
}

TEST_CASE("every list of digests is compared with every file, and one that differs is enough") {
    const Classification none;
    const std::string good = sha256(problem) + "  seven.plc\n";
    const std::string bad = sha256("") + "  seven.plc\n";
    for (const bool good_first : {false, true}) {
        const Report report = summarize(none, {replay(none, "seven.plc", problem),
                                               replay(none, "one", good_first ? good : bad),
                                               replay(none, "two", good_first ? bad : good)});
        CHECK(report.status == 1);
        CHECK(report.comparisons[0].objections.size() == 1);
    }
    const Report both =
        summarize(none, {replay(none, "a/seven.plc", problem), replay(none, "b/seven.plc", problem),
                         replay(none, "sums", bad)});
    CHECK(both.comparisons[0].objections.size() == 1);
    CHECK(both.comparisons[1].objections.size() == 1);
}
