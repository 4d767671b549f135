// Proofs that a starting value leads to one solution (FORMAT.md, section 9), and that solutions are
// different.
#include "checker/degrees/ball.h"
#include "tests/checker/degrees/instances.h"

#include <regex>

using namespace checker;
using namespace instances;

TEST_CASE("true cameras are certified, for all kinds of features, from few digits, too") {
    for (const std::size_t number : all_kinds()) {
        CAPTURE(number);
        const Instance instance = good_instance(number);
        ComplexCameras z = approximate(instance.cameras);
        for (const double error : {0.0, 1e-9, 1e-5}) {
            z[3] += error;
            const DegreeFile file = replayed(record(number, instance) + solution_line(z, true));
            for (const Complaint& complaint : file.refusals.first)
                CAPTURE(complaint.reason);
            REQUIRE(file.bounds.size() == 1);
            CHECK(file.bounds[0].number == number);
            CHECK(file.bounds[0].solutions == 1);
        }
    }
}

TEST_CASE("images of many digits are taken exactly") {
    const mpz_class large("999999999999999999999999999999999989");
    const Ball<64> difference = Ball<64>(large) - Ball<64>(mpz_class(large - 1));
    CHECK(acb_contains_int(difference.get()));
    CHECK(!nonzero(difference - Ball<64>(1)));
    CHECK(nonzero(difference - Ball<64>(2)));

    // The same image points, and lines, by vectors of up to 18 digits.
    const std::string factor = "99999999999"; // the images have at most six
    std::string text = example_images(), longer;
    const std::regex integer(" (-?[1-9][0-9]*)(?=[ \n])");
    const std::size_t start = text.find("image");
    longer = text.substr(0, start);
    text.erase(0, start);
    for (std::smatch match; std::regex_search(text, match, integer);) {
        longer += match.prefix().str() + " " +
                  mpz_class(mpz_class(match[1]) * mpz_class(factor)).get_str();
        text = match.suffix();
    }
    const DegreeFile file = replayed(longer + text + example_solution());
    REQUIRE(file.bounds.size() == 1);
    CHECK(file.bounds[0].solutions == 1);
}

TEST_CASE("pairs count twice; a solution counts once") {
    const std::size_t number = class_with({21, 24});
    const Instance instance = good_instance(number);
    const std::string start = record(number, instance);
    const std::string real = solution_line(approximate(instance.cameras), true);
    std::vector<ComplexCameras> different;
    std::size_t lines = 1;
    std::string text = start + real;
    for (const auto& z : hunt(system_of(instance), 1500)) {
        const std::string longer = text + solution_line(z, false);
        const DegreeFile file = replayed(longer);
        if (file.bounds.empty()) continue; // found before, real, or degenerate
        CHECK(file.bounds[0].solutions == 2 * lines + 1);
        text = longer;
        ++lines;
        different.push_back(z);
    }
    REQUIRE(different.size() > 1);

    const auto line = 2 + instance.features.size() + 1;
    const std::string same =
        say(line + 1, ": class ", number, ": this may be the solution of line ", line);
    ComplexCameras z = different[0];
    CHECK(refusal(start + solution_line(z, false) + solution_line(z, false)) == same);
    ComplexCameras conjugate = z;
    for (Complex& x : conjugate)
        x = std::conj(x);
    CHECK(refusal(start + solution_line(z, false) + solution_line(conjugate, false)) == same);
    CHECK(refusal(start + real + real) == same);
    z[0] += 1e-12;
    CHECK(refusal(start + solution_line(z, false) + solution_line(different[0], false)) == same);
    CHECK(refusal(start + solution_line(approximate(instance.cameras), false)) ==
          say(line, ": class ", number, ": the pair may be real"));
    CHECK(refusal(start + solution_line(different[0], true))
              .ends_with("no proof of a zero near the starting value"));
}

TEST_CASE("what is no solution is refused") {
    ComplexCameras z = approximate(example().cameras);
    for (Complex& x : z)
        x += 100;
    CHECK(refusal(example_images() + solution_line(z, true)) ==
          "6: class 2394: no proof of a zero near the starting value");
    CHECK(refusal(record(chicago, good_instance(chicago, 8)) + example_solution()) ==
          "6: class 2394: no proof of a zero near the starting value");
    const std::string large = " 999999999999999999";
    std::string far = "real 0";
    for (int i = 0; i < 11; ++i)
        far += large;
    CHECK(refusal(example_images() + far + "\n").starts_with("6: class 2394: no "));
}
