// Classification files by the letter of FORMAT.md, section 5: which lines are missed, which are
// out of place, and how many there may be.
#include "checker/replay.h"
#include "tests/support/all_classes.h"
#include "tests/support/malformed_files.h"

using namespace checker;

namespace {

const std::string head = "plcert 2 classification\nmodulus 2305843009213693951\n";

} // namespace

TEST_CASE("a file without records lacks one for each class, and the first 20 are told") {
    const ReplayedFile good = replay(all_classes(), "file", head + pool);
    const auto* file = std::get_if<ClassificationFile>(&good.content);
    REQUIRE(file);
    CHECK(file->verdicts.empty());
    CHECK(file->refusals.count == 143494);
    REQUIRE(file->refusals.first.size() == 20);
    for (std::size_t n = 0; n < 20; ++n)
        CHECK(file->refusals.first[n].reason == say("class ", n, ": there is no certificate"));
}

TEST_CASE("pools are numbered, and have cameras and features in the order of the table") {
    CHECK(complaint(head + "pool 2\n") == "3: found `2`, expected `1`");
    CHECK(complaint(head + "hello\n") == "3: found `hello`, expected `deficient`");
    CHECK(complaint(head + pool + "feature P/P/P point 1 2\n") ==
          "7: found nothing, expected an integer from -999999 to 999999");
    CHECK(complaint(head + pool + "feature Pa/Pa/Pa point 1 2 3 pin 1 2 3\n")
              .ends_with("expected a feature, in the order of the table"));
    CHECK(complaint(head + pool + "feature P/P point 1 2 3\n")
              .ends_with("expected a feature, in the order of the table"));
    CHECK(complaint(head + pool + "feature P/P/P point 1 2 3 pin 1 2 3\n")
              .ends_with("expected the end of the line"));
    CHECK(complaint(head + pool + "minimal 0 1 1\n" + pool) ==
          "8: found `pool`, expected `deficient`");
}

TEST_CASE("a minor is a residue that is not 0") {
    for (const char* wrong : {"0", "2305843009213693951"})
        CHECK(complaint(head + pool + "minimal 0 1 " + wrong + "\n")
                  .ends_with("expected an integer from 1 to 2305843009213693950"));
}

TEST_CASE("records are in the order of the classes, one each") {
    CHECK(complaint(head + pool + "minimal 5 1 1\nminimal 5 1 1\n") ==
          "8: class 5 is out of order");
    CHECK(complaint(head + pool + "minimal 5 1 1\nminimal 4 1 1\n") ==
          "8: class 4 is out of order");
}

TEST_CASE("there are at most 99 pools, of at most 1000 features") {
    std::string many = head;
    for (int n = 1; n <= 99; ++n)
        many += "pool " + std::to_string(n) + pool.substr(6);
    CHECK(std::holds_alternative<ClassificationFile>(replay(all_classes(), "file", many).content));
    CHECK(complaint(many + "pool 100" + pool.substr(6)).ends_with("expected at most 99 pools"));
    many = head + pool;
    for (int n = 1; n <= 1000; ++n)
        many += "feature P/P/P point 1 2 3\n";
    CHECK(complaint(many).ends_with("expected at most 1000 features in a pool"));
}
