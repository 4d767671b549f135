// Degree files by the letter of FORMAT.md, section 9.
#include "tests/checker/degrees/instances.h"

using namespace checker;
using namespace instances;

namespace {
const std::string& good_record() {
    static const std::string text = example_images() + example_solution();
    return text;
}

/// Why the good record does not conform with a part replaced.
std::string altered(const std::string& old, const std::string& fresh) {
    return violation(with(good_record(), old, fresh));
}
} // namespace

TEST_CASE("images that do not belong to the class") {
    const std::string& images = example_images();
    const std::string solution = example_solution();
    const std::string due =
        "class 2394: the images must be, in this order, those of 2*Pa/Pa/Pa + P/P/P";
    CHECK(refusal("degree 0 evidence none\nimage a/a/a view line 1 2 3 view line 1 2 3 view line 1 "
                  "2 3\n" +
                  solution) == "2: class 0: the class is not minimal");
    CHECK(refusal(with(images, "2394", "143494") + solution) ==
          "2: class 143494: there is no such class");
    CHECK(refusal(with(images, "2394", "2395") + solution)
              .starts_with("2: class 2395: the images must be"));
    const std::size_t last = images.rfind("image");
    CHECK(refusal(images.substr(0, last) + solution) == "2: " + due);
    CHECK(refusal(images + images.substr(last) + solution) == "2: " + due);
    const std::size_t first = images.find("image");
    CHECK(refusal(images.substr(0, first) + images.substr(last) +
                  images.substr(first, last - first) + solution) == "2: " + due);
}

TEST_CASE("records come in the order of their classes") {
    const std::string second = with(good_record(), "degree 2394", "degree 2395");
    CHECK(replayed("").bounds.empty());
    CHECK(replayed(good_record()).bounds.size() == 1);
    CHECK(replayed(good_record() + second).bounds.size() == 1);
    CHECK(violation(good_record() + good_record()) == "7: class 2394: is out of order");
    CHECK(violation(second + good_record()) == "7: class 2394: is out of order");
}

TEST_CASE("evidence is read to the letter") {
    CHECK(altered("degree", "degrees") == "2: found `degrees`, expected `degree`");
    CHECK(altered("2394", "-1").starts_with("2: found `-1`"));
    CHECK(altered("none", "some") == "2: found `some`, expected `complete`");
    CHECK(altered("none", "complete") == "2: found nothing, expected `edges`");
    CHECK(altered("none", "none complete").starts_with("2: found `complete`"));
    CHECK(altered("none", "complete edges -1 trace -9").starts_with("2: found `-1`"));
    CHECK(altered("none", "complete edges 3 trace some").starts_with("2: found `some`"));
    CHECK(altered("none", "complete edges 100 trace -9").starts_with("2: found `100`"));
    CHECK(altered("none", "complete edges 3 trace 0").starts_with("2: found `0`"));
    CHECK(altered("none", "complete edges 3 trace -100").starts_with("2: found `-100`"));
    CHECK(altered("none", "complete edges 3") == "2: found nothing, expected `trace`");
}

TEST_CASE("evidence that there are no more solutions has an edge or a trace, and proves nothing") {
    for (const std::string evidence :
         {"edges 1 trace none", "edges 99 trace none", "edges 0 trace -1", "edges 99 trace -99"}) {
        const DegreeFile file = replayed(with(good_record(), "none", "complete " + evidence));
        CHECK(file.bounds.at(0).solutions == replayed(good_record()).bounds.at(0).solutions);
    }
    CHECK(altered("none", "complete edges 0 trace none") ==
          "2: found `none`, expected the exponent of a trace, as there are 0 edges");
}

TEST_CASE("images and solutions are read to the letter") {
    CHECK(altered("image Pa/Pa/Pa", "image Pb/Pa/Pa") ==
          "3: found `Pb/Pa/Pa`, expected a feature of the table");
    CHECK(altered(" toward", " line") == "3: found `line`, expected `toward`");
    CHECK(altered(" view", "") == "3: found `point`, expected `view`");
    CHECK(altered("view point", "view point 1000000000000000000") ==
          "3: found `1000000000000000000`, expected an integer of at most 18 digits");
    CHECK(altered("view point", "view point 1").starts_with("3: found "));
    CHECK(violation(example_images()) == "5: found nothing, expected `pair`");
    CHECK(altered("real 50", "real 201").starts_with("6: found `201`"));
    CHECK(altered("real 50", "real -1").starts_with("6: found `-1`"));
    CHECK(contains(altered("real 50", "real 50 0"), "expected the end of the line"));
    CHECK(altered("real 50", "pair 50").starts_with("6: found nothing, expected an integer"));
    CHECK(altered("real 50", "real 50 1000000000000000000").starts_with("6: found `1000000000"));
    CHECK(altered("real 50", "solution 50") == "6: found `solution`, expected `pair`");
    std::string many = "degree 5 evidence none\n";
    for (int i = 0; i < 12; ++i)
        many += "image -/P/P view point 1 2 3 view point 1 2 3\n";
    CHECK(violation(many) == "14: found `image`, expected at most 11 features");
}

TEST_CASE("a record goes on in the next line after a backslash, and not elsewhere") {
    std::string longer = good_record();
    for (std::size_t at = longer.find(" toward"); at != longer.npos;
         at = longer.find(" toward", at + 10))
        longer.replace(at, 1, " \\\n");
    CHECK(replayed(longer).bounds.size() == 1);
    CHECK(altered(" toward", " \\ toward").starts_with("3: found `\\x5c`"));
    CHECK(altered(" toward", "\ntoward").starts_with("3: found nothing"));
}

TEST_CASE("a record that is refused touches no other record of its file") {
    const std::string refused = with(good_record(), "degree 2394", "degree 2393");
    const DegreeFile file = replayed(refused + good_record());
    CHECK(file.refusals.count == 1);
    REQUIRE(file.bounds.size() == 1);
    CHECK(file.bounds[0].number == chicago);
}
