// Images as files: what is read, exactly as written, and what is refused, and where.
#include "prover/solver/images_file.h"

#include "prover/solver/synthetic.h"
#include "prover/system/exit.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

const Features pin = parse_features("Pa/a/-");

/// A file for the problem above; the texts are what the first two views see of it, and cameras.
std::string file(const std::string& first, const std::string& second,
                 const std::string& more = "") {
    return R"({"problem": "Pa/a/-", )" + more + R"("features": [{"views": [)" + first + ", " +
           second + ", null]}]}";
}

const std::string good_first = R"({"point": [1, 2], "lines": {"a": [[1, 2], ["7/2", 1e1]]}})";
const std::string good_second = R"({"lines": {"a": [1, 2, -3.5]}})";

/// What is wrong with the text; empty if it is read.
std::string complaint(const std::string& text) {
    try {
        read_images(text, "f", pin);
        return "";
    } catch (const BadInput& error) {
        return error.what();
    }
}

} // namespace

TEST_CASE("numbers are exact as written") {
    CHECK(exact_number("1/3") == mpq_class(1, 3));
    CHECK(exact_number("-10/4") == mpq_class(-5, 2));
    CHECK(exact_number("0.1") == mpq_class(1, 10));
    CHECK(exact_number("-12.50e-1") == mpq_class(-5, 4));
    CHECK(exact_number("1E3") == mpq_class(1000));
    CHECK(exact_number("007") == mpq_class(7));
    for (const char* bad : {"", "nan", "inf", "1/0", "1e1000", "1.", ".5", "1/-3", "0x1", " 1",
                            "1 ", "1e", "--1", "1e101"}) {
        CAPTURE(bad);
        CHECK(!exact_number(bad));
    }
    CHECK(!exact_number(std::string(101, '1')));
    CHECK(exact_number(std::string(100, '1')));
}

TEST_CASE("a file is read as it is written") {
    const GivenImages images = read_images(file(good_first, good_second), "f", std::nullopt);
    CHECK(images.problem == pin);
    const GivenSighting& first = images.features[0][0];
    CHECK(*first.point == ExactVector{1, 2, 1});
    CHECK(first.lines[0]->points[1][0] == mpq_class(7, 2));
    CHECK(first.lines[0]->points[1][1] == 10);
    CHECK(images.features[0][1].lines[0]->coefficients == ExactVector{1, 2, mpq_class(-7, 2)});
    CHECK(!images.features[0][2].point);
}

TEST_CASE("calibration is undone exactly") {
    const std::string cameras = R"("cameras": [{"fx": 10, "fy": 5, "cx": 1, "cy": 1.5}, null,
        {"K": [[2, 1, 0], [0, 3, 0], [0, 0, 1]]}], )";
    const GivenImages images = read_images(file(good_first, good_second, cameras), "f", pin);
    const ConsistentImages normalised = consistent(images);
    CHECK(normalised.moved == 0);
    const ExactSighting& first = normalised.features[0][0];
    CHECK(*first.point == ExactVector{0, mpq_class(1, 10), 1});
    // The line still passes through both of its points.
    const ExactVector& l = *first.lines[0];
    CHECK(l[0] * (*first.point)[0] + l[1] * (*first.point)[1] + l[2] == 0);
    CHECK(l[0] * mpq_class(1, 4) + l[1] * mpq_class(17, 10) + l[2] == 0);
    CHECK(*normalised.features[0][1].lines[0] == ExactVector{1, 2, mpq_class(-7, 2)});
}

TEST_CASE("a line that misses its point is moved, and the answer says by how many pixels") {
    const std::string first = R"({"point": [0, 0], "lines": {"a": [[4, 1], [8, 0]]}})";
    const ConsistentImages moved = consistent(read_images(file(first, good_second), "f", pin));
    CHECK(moved.moved == doctest::Approx(2.0 / 3));
    const SeenImages seen = rounded(read_images(file(first, good_second), "f", pin), moved);
    const Sighting& sighting = seen.observation[0][0];
    CHECK(std::abs(sighting.point->dot(*sighting.lines[0])) < 1e-12);
}

TEST_CASE("what is wrong is refused, and where it is") {
    const auto with_first = [](const std::string& first) { return file(first, good_second); };
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "no JSON"},
        {"{", "no JSON"},
        {R"({"problem": 1e999})", "no JSON"},
        {R"({"problem": NaN})", "no JSON"},
        {"{\"problem\" \xff\x1b[2J: 1}", "last read: '\"problem\" ?'"},
        {"[" + std::string(2'000'000, '['), "more than 20 deep"},
        {R"({"x\u001b[2J": 1})", "no member called \"x?[2J\""},
        {R"({"features": [], "features": []})", "two members are called \"features\""},
        {"[]", "the file: expected an object"},
        {"{}", "the file: expected the member \"features\""},
        {R"({"camera": []})", "no member called \"camera\""},
        {R"({"problem": "P/P", "features": []})", "problem: expected images of Pa/a/-"},
        {R"({"problem": "what?", "features": []})", "f: problem: "},
        {R"({"features": []})", "features: these are 0: give the 1 of Pa/a/-, in this order"},
        {R"({"features": [{"views": [{"point": 1}, null, {"lines": {"b": 2}}]}, 3]})",
         "features: these are 2, P/-/b + ?: give the 1 of Pa/a/-"},
        {R"({"features": {}})", "features: expected a list"},
        {R"({"features": [{"views": [null, null]}]})", "features[0].views: expected 3 views"},
        {R"({"features": [{"views": [null, null, null]}]})", "features[0].views[0]: expected"},
        {R"({"features": [{"name": 1, "view": []}]})", "no member called \"view\""},
        {file(good_first, good_first), "features[0].views[1]: there is no member called \"point\""},
        {with_first(R"({"lines": {"a": [1, 2, 3]}})"), "views[0]: expected the member \"point\""},
        {with_first(R"({"point": [1, 2]})"), "views[0]: expected the member \"lines\""},
        {with_first(R"({"point": [1], "lines": {"a": [1, 2, 3]}})"), "views[0].point: expected"},
        {with_first(R"({"point": [1, "x"], "lines": {"a": [1, 2, 3]}})"), "views[0].point[1]"},
        {with_first(R"({"point": [1, true], "lines": {"a": [1, 2, 3]}})"), "views[0].point[1]"},
        {with_first(R"({"point": [1, 2], "lines": {"b": [1, 2, 3]}})"), "no member called \"b\""},
        {with_first(R"({"point": [1, 2], "lines": {"a": [0, 0, 3]}})"), "lines.a: expected a line"},
        {with_first(R"({"point": [1, 2], "lines": {"a": [[1, 2], [1, 2]]}})"), "two different"},
        {with_first(R"({"point": [1, 2], "lines": {"a": [1]}})"), "lines.a: expected"},
        {file(good_first, good_second, R"("cameras": [], )"), "cameras: expected 3 cameras"},
        {file(good_first, good_second, R"("cameras": [{"fx": 1}, null, null], )"),
         "cameras[0]: expected the member \"cx\""},
        {file(good_first, good_second,
              R"("cameras": [{"fx": 0, "fy": 1, "cx": 1, "cy": 1}, null, null], )"),
         "cameras[0]: expected positive focal lengths"},
        {file(good_first, good_second, R"("cameras": [null, {"K": [[1, 0], [0, 1]]}, null], )"),
         "cameras[1].K: expected an upper triangular"},
        {file(good_first, good_second,
              R"("cameras": [null, {"K": [[1,0,0],[1,1,0],[0,0,1]]}, null], )"),
         "cameras[1].K: expected an upper triangular"}};
    CHECK(complaint(file(good_first, good_second)).empty());
    for (const auto& [text, expected] : bad) {
        CAPTURE(text);
        const std::string found = complaint(text);
        CAPTURE(found);
        CHECK(found.starts_with("f: "));
        CHECK(found.find(expected) != std::string::npos);
    }
}

TEST_CASE("images that no generic scene has are refused") {
    const auto refusal = [](const std::string& text, const Features& problem) -> std::string {
        const GivenImages images = read_images(text, "f", problem);
        try {
            refuse_degenerate(images);
            return "";
        } catch (const BadInput& error) {
            return error.what();
        }
    };
    const auto points = [](const std::string& first, const std::string& second) {
        return R"({"features": [{"name": "corner", "views": [{"point": [0, 1]}, {"point": )" +
               first + R"(}]}, {"views": [{"point": [2, 1]}, {"point": )" + second + "}]}]}";
    };
    const Features problem = parse_features("2*P/P");
    CHECK(refusal(points("[3, 1]", "[5, 2]"), problem).empty());
    CHECK(refusal(points("[3, 1]", "[3, 1.0]"), problem)
              .starts_with("view 2 sees feature 1 (P/P, corner) and feature 2 (P/P) at the same "
                           "point"));
    CHECK(refusal(points("[0, 1]", "[2, 1]"), problem).starts_with("views 1 and 2 see the same"));
}

TEST_CASE("the images of a synthetic scene are read back to a millionth of a pixel") {
    const SyntheticScene scene = synthetic_scene(parse_features("2*Pa/Pa/Pa + P/P/P"), 1);
    const GivenImages images = read_images(images_file(scene), "f", scene.problem);
    const ConsistentImages normalised = consistent(images);
    CHECK(normalised.moved == 0);
    refuse_degenerate(images);
    const SeenImages seen = rounded(images, normalised);
    for (std::size_t f = 0; f < scene.problem.size(); ++f)
        for (std::size_t v = 0; v < 3; ++v) {
            const Sighting& found = seen.observation[f][v];
            const Sighting& made = scene.images.observation[f][v];
            CHECK((*found.point - *made.point).norm() < 1e-8);
            for (std::size_t line = 0; line < made.lines.size(); ++line)
                CHECK(found.lines[line]->normalized().cross(*made.lines[line]).norm() < 1e-7);
        }
}
