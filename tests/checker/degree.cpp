// Degree files: systems and certificates made from known cameras, by exact arithmetic and without
// any tracker; each condition of FORMAT.md, section 9, violated in turn.
#include "checker/claims.h"
#include "checker/degree_system.h"

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <complex>
#include <random>
#include <set>

using namespace checker;

namespace {

using Rational = mpq_class;
using Complex = std::complex<double>;

const Classification& classes() {
    static const Classification all = classify();
    return all;
}

/// Reproducible integers from -bound to bound.
struct Random {
    std::mt19937_64 engine{7};
    int operator()(int bound) { return std::uniform_int_distribution<int>(-bound, bound)(engine); }
};

/// The first class that has all of these features.
std::size_t class_with(std::initializer_list<std::size_t> wanted) {
    for (std::size_t n = 0; n < classes().representatives.size(); ++n) {
        const Signature& s = classes().representatives[n];
        if (obstruction(s).minimal() &&
            std::all_of(wanted.begin(), wanted.end(), [&](std::size_t i) { return s[i] > 0; }))
            return n;
    }
    return 0;
}

using Space = std::array<Rational, 3>;

/// Cameras in the order of section 9, and a scene: points, each with a second point on each pin.
struct Instance {
    Coordinates<Rational> cameras{};
    std::vector<std::size_t> features{};
    std::vector<std::vector<Space>> points{}; // of a free line: two points of it
};

/// By the formula of section 2, which knows nothing of derivatives.
Space image(const Coordinates<Rational>& cameras, unsigned view, const Space& point) {
    if (view == 0) return point;
    const auto* q = &cameras[3 * view - 3];
    const Rational b = q[0], c = q[1], d = q[2];
    const Space centre =
        view == 1 ? Space{1, cameras[6], cameras[7]} : Space{cameras[8], cameras[9], cameras[10]};
    const Space x{point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]};
    return {(1 + b * b - c * c - d * d) * x[0] + 2 * (b * c - d) * x[1] + 2 * (b * d + c) * x[2],
            2 * (b * c + d) * x[0] + (1 - b * b + c * c - d * d) * x[1] + 2 * (c * d - b) * x[2],
            2 * (b * d - c) * x[0] + 2 * (c * d + b) * x[1] + (1 - b * b - c * c + d * d) * x[2]};
}

Space cross_product(const Space& a, const Space& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Instance random_instance(std::size_t number, Random& random) {
    Instance instance;
    for (std::size_t i = 0; i < camera_unknowns; ++i)
        instance.cameras[i] = Rational(random(i < 6 ? 4 : 9), i < 6 ? 4 : 2);
    for (std::size_t i = 0; i < feature_count; ++i) {
        for (unsigned n = 0; n < classes().representatives[number][i]; ++n) {
            instance.features.push_back(i);
            auto& points = instance.points.emplace_back();
            for (unsigned k = 0; k < features[i].pins + 1; ++k)
                points.push_back({random(9), random(9), random(9)});
        }
    }
    return instance;
}

/// An integer vector with at most 6 digits, up to scale.
std::string integers(const Space& x) {
    mpz_class scale = 1, divisor = 0;
    for (const Rational& c : x)
        scale = lcm(scale, c.get_den());
    std::array<mpz_class, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
        y[i] = x[i].get_num() * (scale / x[i].get_den());
        divisor = gcd(divisor, y[i]);
    }
    std::string text;
    for (mpz_class& c : y) {
        if (divisor != 0) c /= divisor;
        REQUIRE(abs(c) <= 999'999);
        text += " " + c.get_str();
    }
    return text;
}

std::string image_lines(const Instance& instance) {
    std::string text;
    for (std::size_t f = 0; f < instance.features.size(); ++f) {
        const Feature& feature = features[instance.features[f]];
        text += say("image ", feature.notation);
        for (unsigned v = 0; v < 3; ++v) {
            if (!(feature.views >> v & 1)) continue;
            text += " view";
            const bool sees_point = feature.point >> v & 1;
            const auto see = [&](std::size_t k) {
                return image(instance.cameras, v, instance.points[f][k]);
            };
            if (sees_point) text += " point" + integers(see(0));
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!(feature.pin[pin] >> v & 1)) continue;
                text += sees_point ? " toward" + integers(see(pin + 1))
                                   : " line" + integers(cross_product(see(0), see(pin + 1)));
            }
        }
        text += "\n";
    }
    return text;
}

constexpr int bits = 50;

std::string solution_line(const Coordinates<Complex>& z, bool real) {
    std::string line = say(real ? "real " : "pair ", bits);
    for (const Complex& x : z) {
        line += say(" ", std::llround(std::ldexp(x.real(), bits)));
        if (!real) line += say(" ", std::llround(std::ldexp(x.imag(), bits)));
    }
    return line + "\n";
}

Coordinates<Complex> approximate(const Coordinates<Rational>& exact) {
    Coordinates<Complex> z;
    for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = exact[i].get_d();
    return z;
}

const std::string head = "plcert 1 degrees\n";

std::string record(std::size_t number, const Instance& instance) {
    return say("degree ", number, " evidence none\n", image_lines(instance));
}

/// The images of a file of one record as a system of equations, read anew.
System system_of(const Instance& instance) {
    System system;
    std::istringstream lines(image_lines(instance));
    for (std::size_t f = 0; f < instance.features.size(); ++f) {
        const Feature& feature = features[instance.features[f]];
        FeatureImages images;
        std::string word;
        lines >> word >> word;
        for (unsigned v = 0; v < 3; ++v) {
            if (!(feature.views >> v & 1)) continue;
            lines >> word;
            const bool sees_point = feature.point >> v & 1;
            const auto vector = [&] {
                Image x;
                lines >> word >> x[0] >> x[1] >> x[2];
                return x;
            };
            if (sees_point) images.point[v] = vector();
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!(feature.pin[pin] >> v & 1)) continue;
                images.line[pin][v] = vector();
                if (sees_point) images.line[pin][v] = cross(images.point[v], images.line[pin][v]);
            }
        }
        add_feature(system, feature, images);
    }
    return system;
}

/// Value and derivative.
struct Dual {
    Rational value = 0, change = 0;
    Dual() = default;
    explicit Dual(double x) : value(x) {}
    Dual(const Rational& x, const Rational& dx) : value(x), change(dx) {}
    Dual operator-() const { return {-value, -change}; }
    Dual operator+(const Dual& b) const { return {value + b.value, change + b.change}; }
    Dual operator-(const Dual& b) const { return {value - b.value, change - b.change}; }
    Dual operator*(const Dual& b) const {
        return {value * b.value, value * b.change + change * b.value};
    }
};

/// One Newton step after the other, from random points: solutions, degenerate ones too.
std::vector<Coordinates<Complex>> hunt(const System& system, std::size_t tries) {
    std::vector<Coordinates<Complex>> found;
    std::mt19937_64 engine{3};
    std::normal_distribution<double> normal;
    while (tries-- > 0) {
        Coordinates<Complex> z, row;
        for (Complex& x : z)
            x = {normal(engine), normal(engine)};
        Scene<Complex> scene;
        double moved = 1;
        for (int step = 0; step < 40 && moved > 1e-13; ++step) {
            look(system, z, scene);
            Eigen::Matrix<Complex, 11, 11> jacobian;
            Eigen::Matrix<Complex, 11, 1> values;
            for (std::size_t e = 0; e < 11; ++e) {
                values[Eigen::Index(e)] = evaluate(system, system.equations[e], scene, row);
                for (std::size_t k = 0; k < 11; ++k)
                    jacobian(Eigen::Index(e), Eigen::Index(k)) = row[k];
            }
            const Eigen::Matrix<Complex, 11, 1> change = jacobian.partialPivLu().solve(values);
            moved = change.norm();
            for (std::size_t k = 0; k < 11; ++k)
                z[k] -= change[Eigen::Index(k)];
        }
        const auto moderate = [](const Complex& x) { return std::abs(x) < 200; };
        if (moved < 1e-12 && std::all_of(z.begin(), z.end(), moderate)) found.push_back(z);
    }
    return found;
}

FileReport replayed(const std::string& records) {
    return replay(classes(), "file", head + records);
}

/// Why the only record of a file is refused, with the line.
std::string refusal(const std::string& records) {
    const FileReport report = replayed(records);
    CHECK(report.conforms);
    CHECK(report.degrees.empty());
    REQUIRE(report.refused == 1);
    return say(report.complaints[0].line, ": ", report.complaints[0].reason);
}

std::string violation(const std::string& records) {
    const FileReport report = replayed(records);
    CHECK(!report.conforms);
    CHECK(report.degrees.empty());
    return say(report.complaints.at(0).line, ": ", report.complaints.at(0).reason);
}

std::string with(std::string text, const std::string& old, const std::string& fresh) {
    REQUIRE(text.find(old) != text.npos);
    return text.replace(text.find(old), old.size(), fresh);
}

/// An instance in general position: nothing in it is degenerate, no image too long.
Instance good_instance(std::size_t number, int seed = 7) {
    Random random{std::mt19937_64(static_cast<std::uint64_t>(seed))};
    while (true) {
        const Instance instance = random_instance(number, random);
        try {
            const System system = system_of(instance);
            Scene<Rational> scene;
            look(system, instance.cameras, scene);
            if (degeneracy(system, instance.cameras, scene).empty()) return instance;
        } catch (const Refused&) {
        }
    }
}

/// Classes that together have all the features of minimal problems.
const std::vector<std::size_t>& all_kinds() {
    static const std::vector<std::size_t> numbers = [] {
        std::vector<std::size_t> some{2394, 6722};
        for (std::size_t i = 1; i < feature_count; ++i)
            some.push_back(class_with({i}));
        return some;
    }();
    return numbers;
}

constexpr std::size_t chicago = 2394;

/// A record of the Chicago problem: its head, images and true cameras.
const Instance& example() {
    static const Instance instance = good_instance(chicago);
    return instance;
}
const std::string& images() {
    static const std::string text = record(chicago, example());
    return text;
}
std::string solution() {
    return solution_line(approximate(example().cameras), true);
}

} // namespace

TEST_CASE("the equations hold at the true cameras, exactly, and not at others") {
    for (const std::size_t number : all_kinds()) {
        CAPTURE(number);
        Instance instance = good_instance(number);
        const System system = system_of(instance);
        REQUIRE(system.equations.size() == 11);
        Scene<Rational> scene;
        Coordinates<Rational> row;
        const auto residues = [&] {
            look(system, instance.cameras, scene);
            return std::count_if(
                system.equations.begin(), system.equations.end(),
                [&](const Equation& e) { return evaluate(system, e, scene, row) != 0; });
        };
        CHECK(residues() == 0);
        for (Rational& coordinate : instance.cameras) {
            coordinate += 1;
            CHECK(residues() > 0);
            coordinate -= 1;
        }
    }
}

TEST_CASE("derivatives are those of the values, over the dual numbers") {
    for (const std::size_t number : all_kinds()) {
        const Instance instance = good_instance(number);
        const System system = system_of(instance);
        Random random;
        Coordinates<Rational> point, row;
        for (Rational& x : point)
            x = random(9);
        Scene<Rational> scene;
        look(system, point, scene);
        for (std::size_t k = 0; k < 11; ++k) {
            Coordinates<Dual> moving, unused;
            for (std::size_t i = 0; i < 11; ++i)
                moving[i] = {point[i], Rational(i == k ? 1 : 0)};
            Scene<Dual> moving_scene;
            look(system, moving, moving_scene);
            for (const Equation& e : system.equations) {
                const Dual value = evaluate(system, e, moving_scene, unused);
                CHECK(evaluate(system, e, scene, row) == value.value);
                CHECK(row[k] == value.change);
            }
        }
    }
}

TEST_CASE("true cameras are certified, for all kinds of features, from few digits, too") {
    for (const std::size_t number : all_kinds()) {
        CAPTURE(number);
        const Instance instance = good_instance(number);
        Coordinates<Complex> z = approximate(instance.cameras);
        for (const double error : {0.0, 1e-9, 1e-5}) {
            z[3] += error;
            const FileReport report = replayed(record(number, instance) + solution_line(z, true));
            for (const Complaint& complaint : report.complaints)
                CAPTURE(complaint.reason);
            REQUIRE(report.degrees.size() == 1);
            CHECK(report.degrees[0].number == number);
            CHECK(report.degrees[0].line == 2);
            CHECK(report.degrees[0].solutions == 1);
            CHECK(!report.degrees[0].complete);
        }
    }
    const std::string complete = with(images(), "none", "complete edges 6 trace -12");
    CHECK(replayed(complete + solution()).degrees.at(0).complete);
}

TEST_CASE("pairs count twice; a solution counts once") {
    const std::size_t number = class_with({21, 24});
    const Instance instance = good_instance(number);
    const std::string start = record(number, instance);
    const std::string real = solution_line(approximate(instance.cameras), true);
    std::vector<Coordinates<Complex>> different;
    std::size_t lines = 1;
    std::string text = start + real;
    for (const auto& z : hunt(system_of(instance), 1500)) {
        const std::string longer = text + solution_line(z, false);
        const FileReport report = replayed(longer);
        if (report.degrees.empty()) continue; // found before, real, or degenerate
        CHECK(report.degrees[0].solutions == 2 * lines + 1);
        text = longer;
        ++lines;
        different.push_back(z);
    }
    REQUIRE(different.size() > 1);

    const auto line = 2 + instance.features.size() + 1;
    const std::string same =
        say(line + 1, ": class ", number, ": this may be the solution of line ", line);
    Coordinates<Complex> z = different[0];
    CHECK(refusal(start + solution_line(z, false) + solution_line(z, false)) == same);
    Coordinates<Complex> conjugate = z;
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
    Coordinates<Complex> z = approximate(example().cameras);
    for (Complex& x : z)
        x += 100;
    CHECK(refusal(images() + solution_line(z, true)) ==
          "6: class 2394: no proof of a zero near the starting value");
    CHECK(refusal(record(chicago, good_instance(chicago, 8)) + solution()) ==
          "6: class 2394: no proof of a zero near the starting value");
    const std::string large = " 999999999999999999";
    std::string far = "real 0";
    for (int i = 0; i < 11; ++i)
        far += large;
    CHECK(refusal(images() + far + "\n").starts_with("6: class 2394: no "));
}

TEST_CASE("images that do not belong to the class") {
    const std::string due =
        "class 2394: the images must be, in this order, those of 2*Pa/Pa/Pa + P/P/P";
    CHECK(refusal("degree 0 evidence none\nimage a/a/a view line 1 2 3 view line 1 2 3 view line 1 "
                  "2 3\n" +
                  solution()) == "2: class 0: the class is not minimal");
    CHECK(refusal(with(images(), "2394", "143494") + solution()) ==
          "2: class 143494: there is no such class");
    CHECK(refusal(with(images(), "2394", "2395") + solution())
              .starts_with("2: class 2395: the images must be"));
    const std::size_t last = images().rfind("image");
    CHECK(refusal(images().substr(0, last) + solution()) == "2: " + due);
    CHECK(refusal(images() + images().substr(last) + solution()) == "2: " + due);
    const std::size_t first = images().find("image");
    CHECK(refusal(images().substr(0, first) + images().substr(last) +
                  images().substr(first, last - first) + solution()) == "2: " + due);
}

TEST_CASE("images that are zero") {
    const std::string zero = "2: class 2394: an image, or an auxiliary one, is zero";
    const std::size_t last = images().rfind("image");
    const auto with_images = [&](const std::string& views) {
        return images().substr(0, last) + "image P/P/P" + views + "\n" + solution();
    };
    CHECK(refusal(with_images(" view point 0 0 0 view point 1 2 3 view point 3 4 5")) == zero);
    CHECK(refusal(with_images(" view point 1 2 4 view point 1 0 0 view point 3 4 5")) == zero);
    const std::size_t toward = images().find("toward"), point = images().find("point") + 5;
    const std::size_t end = images().find(" view", toward);
    CHECK(refusal(images().substr(0, toward + 6) + images().substr(point, toward - 1 - point) +
                  images().substr(end) + solution()) == zero);
}

TEST_CASE("degenerate cameras") {
    const auto reason = [](const System& system, const auto& cameras) {
        Scene<std::decay_t<decltype(cameras[0])>> scene;
        look(system, cameras, scene);
        return std::string(degeneracy(system, cameras, scene));
    };
    const Instance& instance = example();
    const System system = system_of(instance);
    CHECK(reason(system, instance.cameras).empty());

    Coordinates<Complex> isotropic = approximate(instance.cameras);
    for (const std::size_t first : {0U, 3U}) {
        Coordinates<Complex> z = isotropic;
        z[first] = {0, 1}, z[first + 1] = z[first + 2] = 0;
        CHECK(reason(system, z) == "the norm of a quaternion is zero");
    }
    const auto with_centre_3 = [&](const Space& centre) {
        Coordinates<Rational> cameras = instance.cameras;
        std::copy(centre.begin(), centre.end(), &cameras[8]);
        return reason(system, cameras);
    };
    CHECK(with_centre_3({0, 0, 0}).empty()); // does not solve the equations, but is no degeneracy
    for (const auto& points : instance.points)
        CHECK(with_centre_3(points[0]) == "a point is the centre of a view of it");
    for (std::size_t f = 0; f < 2; ++f)
        CHECK(with_centre_3(instance.points[f][1]) ==
              "a line has no direction, or meets the centre of a view of it");

    // Views that are not turned, so that rays and normals are the images themselves.
    const Coordinates<Rational> plain{0, 0, 0, 0, 0, 0, 2, 3, -1, 4, 5};
    const auto one = [&](std::string_view name, const FeatureImages& images) {
        System alone;
        const auto has_name = [&](const Feature& f) { return f.notation == name; };
        add_feature(alone, *std::find_if(features.begin(), features.end(), has_name), images);
        return reason(alone, plain);
    };
    using Lines = std::array<Image, 3>;
    CHECK(one("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 1, -1}, {1, 0, 0}}}}) ==
          "a ray is parallel to a plane of its incidence");
    CHECK(one("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 0, 0}, {1, 1, -1}}}}) ==
          "a ray is parallel to a plane of its incidence");
    CHECK(one("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 0, 0}, {2, 0, 0}}}}) ==
          "a line has no direction, or meets the centre of a view of it");
    CHECK(one("P/a/a", {{Image{1, 3, 3}}, {Lines{Image{}, {1, 0, 0}, {0, 1, 0}}}}).empty());
    CHECK(one("-/P/P", {{Image{}, {1, 2, 3}, {1, 2, 3}}, {}}) ==
          "a ray is parallel to the plane that it should meet");
    CHECK(one("-/P/P", {{Image{}, {1, 2, 3}, {1, 1, 3}}, {}}).empty());
}

TEST_CASE("degenerate solutions of the equations are refused") {
    const Instance instance = good_instance(6722);
    const std::string start = record(6722, instance);
    std::size_t refused = 0;
    for (const auto& z : hunt(system_of(instance), 60)) {
        const FileReport report = replayed(start + solution_line(z, false));
        refused +=
            report.refused > 0 && report.complaints[0].reason ==
                                      "class 6722: a ray is parallel to a plane of its incidence";
    }
    CHECK(refused > 0);
}

TEST_CASE("degree files are read to the letter") {
    const std::string good = images() + solution();
    CHECK(replayed(good).conforms);
    CHECK(replayed("").conforms);
    CHECK(replayed(with(good, "none", "complete edges 0 trace none")).degrees.at(0).complete);
    const std::string second = with(good, "degree 2394", "degree 2395");
    CHECK(replayed(good + second).conforms);
    CHECK(violation(good + good) == "7: class 2394: comes too late");
    CHECK(violation(second + good) == "7: class 2394: comes too late");
    const auto altered = [&](const std::string& old, const std::string& fresh) {
        return violation(with(good, old, fresh));
    };
    CHECK(altered("degree", "degrees") == "2: found `degrees`, expected `degree`");
    CHECK(altered("2394", "-1").starts_with("2: found `-1`"));
    CHECK(altered("none", "some") == "2: found `some`, expected `none`");
    CHECK(altered("none", "complete") == "2: found nothing, expected `edges`");
    CHECK(altered("none", "complete edges -1 trace -9").starts_with("2: found `-1`"));
    CHECK(altered("none", "complete edges 3 trace some").starts_with("2: found `some`"));
    CHECK(altered("none", "complete edges 100 trace -9").starts_with("2: found `100`"));
    CHECK(altered("none", "complete edges 3 trace 0").starts_with("2: found `0`"));
    CHECK(altered("none", "complete edges 3 trace -100").starts_with("2: found `-100`"));
    CHECK(altered("none", "complete edges 3") == "2: found nothing, expected `trace`");
    CHECK(altered("image Pa/Pa/Pa", "image Pb/Pa/Pa") ==
          "3: found `Pb/Pa/Pa`, expected one of at most 11 features of the table");
    CHECK(altered(" toward", " line") == "3: found `line`, expected `toward`");
    CHECK(altered(" view", "") == "3: found `point`, expected `view`");
    CHECK(altered("view point", "view point 1000000").starts_with("3: found `1000000`"));
    CHECK(altered("view point", "view point 1").starts_with("3: found "));
    CHECK(violation(images()) == "5: found nothing, expected `pair`");
    CHECK(altered("real 50", "real 201").starts_with("6: found `201`"));
    CHECK(altered("real 50", "real -1").starts_with("6: found `-1`"));
    CHECK(altered("real 50", "real 50 0").find("expected the end of the line") !=
          std::string::npos);
    CHECK(altered("real 50", "pair 50").starts_with("6: found nothing, expected an integer"));
    CHECK(altered("real 50", "real 50 1000000000000000000").starts_with("6: found `1000000000"));
    CHECK(altered("real 50", "solution 50") == "6: found `solution`, expected `pair`");
    std::string many = "degree 5 evidence none\n";
    for (int i = 0; i < 12; ++i)
        many += "image -/P/P view point 1 2 3 view point 1 2 3\n";
    CHECK(violation(many) == "14: found `-/P/P`, expected one of at most 11 features of the table");
}

namespace {

/// A report on all classes, each with the verdict that its obstruction gives, and on a file of
/// these degrees.
Report degree_report(const std::vector<Degree>& degrees, bool classification = true) {
    FileReport minimal{.name = "all", .kind = "classification"};
    for (std::size_t n = 0; classification && n < classes().representatives.size(); ++n)
        minimal.verdicts.push_back({n, n, obstruction(classes().representatives[n])});
    FileReport file{.name = "degrees", .kind = "degrees"};
    file.degrees = degrees;
    return summarize(classes(), {minimal, file});
}

DegreeClaim claim(const Report& report, const std::string& start) {
    for (const DegreeClaim& c : report.degrees)
        if (c.claim.starts_with(start)) return c;
    FAIL(start);
    return {};
}

} // namespace

TEST_CASE(
    "a degree speaks for its constraint class; certified, evidence and claimed are kept apart") {
    const std::size_t point = class_with({21}), pins = class_with({24});
    REQUIRE(class_with({}) > 0);
    const Report none = degree_report({});
    CHECK(none.degrees.empty());
    CHECK(text(none).find("camera-degrees") == std::string::npos);

    // One record on a class with P/a/a, and what it says of the problems with Pab/b/a instead.
    const Report report = degree_report({{point, 1, 160, true}, {chicago, 2, 312, false}});
    const DegreeClaim exactly = claim(report, "terminal, degree 160");
    CHECK(exactly.paper == "547");
    CHECK(exactly.verdict.starts_with("open: "));
    std::set<std::size_t> equivalent; // by swaps, exchanges and relabelings, one after the other
    std::vector<Signature> todo{classes().representatives[point]};
    std::set<Signature> seen(todo.begin(), todo.end());
    while (!todo.empty()) {
        const Signature s = todo.back();
        todo.pop_back();
        const std::size_t number = class_of(classes(), s, false);
        if (classes().swap_class[number] == number) equivalent.insert(number);
        std::vector<Signature> next;
        for (const Map& map : relabelings) {
            Signature image{};
            for (std::size_t i = 0; i < feature_count; ++i)
                image[i] = s[map[i]];
            next.push_back(image);
        }
        for (std::size_t i = 12; i < feature_count; ++i) {
            const std::size_t other = i < 18 ? (i ^ 1) : i < 21 ? i : i < 24 ? i + 3 : i - 3;
            Signature image = s;
            if (s[i] == 0 || other == i) continue;
            --image[i], ++image[other];
            next.push_back(image);
        }
        for (const Signature& t : next)
            if (seen.insert(t).second) todo.push_back(t);
    }
    CHECK(exactly.known == say(equivalent.size()));
    CHECK(exactly.certified == say(equivalent.size() + 1)); // and Chicago, which is alone
    CHECK(equivalent.size() > 1);
    CHECK(claim(report, "terminal, degree at least 300").certified == "1");
    CHECK(claim(report, "terminal, degree at least 300").paper == "73816");
    CHECK(claim(report, "terminal, degree at least 300").known == "-");
    CHECK(claim(report, "3002_1, class 2394").certified == "312");
    CHECK(claim(report, "3002_1, class 2394").known == "-");
    CHECK(claim(report, "3010_0, class 6722").verdict == "not covered by these files");
    CHECK(pins != point);

    const std::string lines = text(report);
    CHECK(lines.find(
              "- class 2394: certified to have at least 312 solutions; evidence that there are "
              "no more: none\n") != std::string::npos);
    CHECK(json(report).find("\"certified_at_least\": 312, \"evidence_complete\": false") !=
          std::string::npos);
}

TEST_CASE("the largest certified bound of a constraint class counts") {
    const Report report = degree_report({{6722, 1, 200, true}, {6722, 2, 216, false}});
    CHECK(claim(report, "3010_0").certified == "216");
    CHECK(claim(report, "3010_0").known == "-"); // the evidence for 200 is refuted
    const Report same = degree_report({{6722, 1, 216, true}, {6722, 2, 216, false}});
    CHECK(claim(same, "3010_0").known == "216");
}

TEST_CASE("degrees of classes that are not certified to be minimal do not count") {
    const Report report = degree_report({{chicago, 1, 312, true}}, false);
    CHECK(report.degrees.empty());
    CHECK(text(report).find("no class of theirs is certified to be minimal") != std::string::npos);
}

TEST_CASE("a table that agrees with the paper, and one that does not") {
    // Degrees for all classes, as the paper claims them or nearly so.
    std::vector<Degree> degrees;
    for (std::size_t n = 0; n < classes().representatives.size(); ++n)
        if (obstruction(classes().representatives[n]).minimal())
            degrees.push_back({n, n, 500, false});
    Report report = degree_report(degrees);
    CHECK(claim(report, "terminal, degree at least 300").certified == "74575");
    CHECK(claim(report, "terminal, degree at least 300").verdict == "differs, certified");
    CHECK(claim(report, "terminal, degree 160").verdict == "differs, certified");
    CHECK(claim(report, "terminal, degree below 300").verdict == "differs, certified");
    CHECK(report.status == 0);
    const std::string found = errata(report);
    CHECK(found.find("terminal, degree 160\n  Paper: 547; certified at least: 74575; certified "
                     "exactly: 0; known exactly: 0; differs") != std::string::npos);

    for (Degree& degree : degrees)
        if (degree.number == 6722) degree = {6722, 1, 176, true};
    report = degree_report(degrees);
    CHECK(claim(report, "terminal, degree 176").paper == "0");
    CHECK(claim(report, "terminal, degree 176").known == "1");
    CHECK(claim(report, "terminal, degree 176").verdict == "differs, by evidence");
    CHECK(errata(report).find("Witness: class 6722: 3*P/P/P + a/a/a") != std::string::npos);
    // At most one problem has less than 300 solutions, since the others are certified to have more.
    CHECK(claim(report, "terminal, degree below 300").verdict == "differs, certified");
}

TEST_CASE(
    "evidence alone certifies neither that there are fewer problems nor that there are more") {
    const auto report = [](std::size_t others) { // 759 with less than 300, as claimed
        std::vector<Degree> degrees;
        std::size_t terminal = 0;
        for (std::size_t n = 0; n < classes().representatives.size(); ++n)
            if (obstruction(classes().representatives[n]).minimal()) {
                terminal += classes().swap_class[n] == n;
                degrees.push_back({n, n, terminal <= 759 ? 80 : others, true});
            }
        return degree_report(degrees);
    };
    for (const std::size_t others : {160U, 300U}) {
        const Report r = report(others);
        const DegreeClaim below = claim(r, "terminal, degree below 300"),
                          rest = claim(r, "terminal, degree at least 300");
        const std::size_t least = std::stoul(rest.certified), less = std::stoul(below.known);
        CHECK(least + less == 74575);
        CHECK(below.verdict == (less > 759   ? "differs, by evidence"
                                : less < 759 ? "differs, certified"
                                             : "agrees, by evidence"));
        CHECK(rest.verdict == (least > 73816   ? "differs, certified"
                               : least < 73816 ? "differs, by evidence"
                                               : "agrees, by evidence"));
    }
}

TEST_CASE("registrations with the five points") {
    std::vector<Degree> degrees;
    std::size_t claimed = 0;
    for (std::size_t n = 0; n < classes().representatives.size(); ++n)
        if (obstruction(classes().representatives[n]).minimal())
            degrees.push_back({n, n, 160, true});
    const Report report = degree_report(degrees);
    std::size_t agree = 0, problems = 0;
    for (const DegreeClaim& c : report.degrees) {
        problems += c.claim.starts_with("PL0P, ");
        if (!c.claim.starts_with("PL0P, ") || c.paper == "-") continue;
        ++claimed;
        agree += c.verdict == "agrees, by evidence";
        if (c.paper == "80") CHECK(c.verdict == "differs, certified");
    }
    CHECK(problems == 51);
    CHECK(claimed == 4);
    CHECK(agree == 3);
    CHECK(claim(report, "terminal, degree at least 300").verdict == "differs, by evidence");
    CHECK(claim(report, "terminal, degree below 300").verdict == "differs, by evidence");

    for (Degree& degree : degrees)
        degree.solutions = 100, degree.complete = false;
    std::size_t open = 0;
    for (const DegreeClaim& c : degree_report(degrees).degrees)
        open += c.claim.starts_with("PL0P, ") && c.verdict == "open";
    CHECK(open == 3);
}
