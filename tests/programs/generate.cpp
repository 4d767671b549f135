// `plprove generate`: headers of C++ that solve a problem, compiled and run as people would.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace {

const std::string plprove = PLPROVE;
const std::string models = std::string(SOURCE_DIR) + "/models/";

/// Reads data, solves them, and prints `count real lost`, then each solution: whether it is real,
/// its unknowns, real and imaginary parts. The real ones, with rotations, come once more from
/// solve().
const std::string main_program = R"(
#include "p3p.h"
#include "five_points_poses.h"
#include "pairs.h"
#include <cstdlib>
#include <iostream>
#include <string>

void fill(double& number) { std::cin >> number; }
template <class Item, std::size_t count>
void fill(Item (&array)[count]) {
    for (Item& item : array)
        fill(item);
}
void print(double number) { std::cout << ' ' << number; }
void print(const std::complex<double>& number) {
    std::cout << ' ' << number.real() << ' ' << number.imag();
}
template <class Item, std::size_t count>
void print(const Item (&array)[count]) {
    for (const Item& item : array)
        print(item);
}
void members(const p3p::ComplexSolution& x) { print(x.s); }
void members(const p3p::Solution& x) { print(x.s); }
void members(const five_points_poses::ComplexSolution& x) { print(x.q), print(x.u), print(x.v); }
void members(const five_points_poses::Solution& x) { print(x.q), print(x.u), print(x.v); }
void members(const pairs::ComplexSolution& x) { print(x.q2), print(x.d2); }
void members(const pairs::Solution& x) { print(x.rotation), print(x.translation); }

template <class Data, class Solve, class SolveComplex>
void answer(const Data& data, Solve solve, SolveComplex solve_complex) {
    std::size_t lost = 0;
    const auto all = solve_complex(data, lost);
    const auto real = solve(data);
    std::cout << all.size() << ' ' << real.size() << ' ' << lost << '\n';
    for (const auto& solution : all) {
        std::cout << solution.real;
        members(solution);
        std::cout << '\n';
    }
    for (const auto& solution : real) {
        members(solution);
        std::cout << '\n';
    }
}
#define ANSWER(name)                                                                               \
    answer(data, [](const name::Data& d) { return name::solve(d); },                               \
           [](const name::Data& d, std::size_t& lost) {                                            \
               name::Stats stats;                                                                  \
               const auto all = name::solve_complex(d, {}, &stats);                                \
               lost = stats.lost;                                                                  \
               return all;                                                                         \
           })

int main(int, char** arguments) {
    std::cout.precision(17);
    const std::string name = arguments[1];
    if (name == "p3p") {
        p3p::Data data;
        fill(data.x), fill(data.d);
        ANSWER(p3p);
    } else if (name == "five_points_poses") {
        five_points_poses::Data data;
        fill(data.x), fill(data.y);
        ANSWER(five_points_poses);
    } else {
        pairs::Data data;
        fill(data.x1_1), fill(data.x1_2);
        ANSWER(pairs);
    }
}
)";

using Numbers = std::vector<double>;
using Complex = std::complex<double>;

/// What main_program printed.
struct Answer {
    std::size_t lost = 0;
    std::vector<bool> is_real;
    std::vector<std::vector<Complex>> all;
    std::vector<Numbers> real;
};

Numbers numbers_in(const std::string& line) {
    std::istringstream stream(line);
    Numbers numbers;
    for (double number = 0; stream >> number;)
        numbers.push_back(number);
    return numbers;
}

/// Headers of some problems in one program, compiled once.
class Solvers {
public:
    Solvers() {
        const auto generate = [&](const std::string& problem, const std::string& name) {
            const Outcome outcome =
                run(plprove + " generate " + problem + " -o " + path(name + ".h"));
            CHECK_MESSAGE(outcome.err.empty(), outcome.err);
            REQUIRE(outcome.status == 0);
        };
        generate(models + "p3p.model", "p3p");
        generate(models + "five_points_poses.model", "five_points_poses");
        generate("'5*P/P' --name pairs", "pairs");
        write_file(path("main.cpp"), main_program);
        const Outcome compiled =
            run(std::string(CXX) +
                " -std=c++17 -O1 -pedantic -Wall -Wextra -Wshadow -Wconversion "
                "-Wsign-conversion -Werror " +
                path("main.cpp") + " -o " + path("main"));
        CHECK_MESSAGE(compiled.err.empty(), compiled.err);
        REQUIRE(compiled.status == 0);
    }

    Answer solve(const std::string& name, const Numbers& data) const {
        std::ostringstream text;
        text.precision(17);
        for (const double number : data)
            text << number << '\n';
        write_file(path("data"), text.str());
        const Outcome outcome = run(path("main") + ' ' + name + " < " + path("data"));
        REQUIRE(outcome.status == 0);
        const std::vector<std::string> lines = lines_of(outcome.out);
        const Numbers counts = numbers_in(lines[0]);
        REQUIRE(lines.size() == static_cast<std::size_t>(1 + counts[0] + counts[1]));
        Answer answer;
        answer.lost = static_cast<std::size_t>(counts[2]);
        for (std::size_t i = 1; i < lines.size(); ++i) {
            Numbers numbers = numbers_in(lines[i]);
            if (i > static_cast<std::size_t>(counts[0])) {
                answer.real.push_back(numbers);
                continue;
            }
            answer.is_real.push_back(numbers[0] != 0);
            std::vector<Complex>& point = answer.all.emplace_back();
            for (std::size_t k = 1; k < numbers.size(); k += 2)
                point.emplace_back(numbers[k], numbers[k + 1]);
        }
        return answer;
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

private:
    TemporaryFolder folder_;
};

const Solvers& solvers() {
    static const Solvers once;
    return once;
}

using Json = nlohmann::ordered_json;

/// All numbers of a value, in their order; of a complex one, [re, im].
void append_numbers(const Json& value, Numbers& numbers) {
    if (value.is_number()) return numbers.push_back(value.get<double>());
    for (const Json& item : value)
        append_numbers(item, numbers);
}

/// Numbers that are the same on any machine, between -1 and 1.
Numbers random_numbers(std::size_t count, std::uint32_t seed) {
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i) {
        seed = seed * 1664525 + 1013904223;
        numbers.push_back(std::ldexp(static_cast<double>(seed >> 8), -23) - 1);
    }
    return numbers;
}

using Vector = std::array<Complex, 3>;

Vector vector_of(const Numbers& data, std::size_t number) {
    return {data[3 * number], data[3 * number + 1], data[3 * number + 2]};
}
Complex dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// (1 + q.q) times the rotation with Cayley's parameters q.
Vector rotated(const Vector& q, const Vector& x) {
    const Vector c = cross(q, x);
    const Complex qq = dot(q, q), qx = dot(q, x);
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = (1.0 - qq) * x[i] + 2.0 * (qx * q[i] + c[i]);
    return result;
}

} // namespace

TEST_CASE("headers find the solutions that plprove solve finds, real and complex") {
    for (const std::string name : {"p3p", "five_points_poses"}) {
        CAPTURE(name);
        const std::string file = models + name + ".model";
        const std::string example = solvers().path("example.json");
        REQUIRE(run(plprove + " solve --example " + file + " -o " + example).status == 0);
        Numbers data;
        append_numbers(Json::parse(read_file(example)), data);
        const Answer answer = solvers().solve(name, data);
        const auto expected =
            Json::parse(run(plprove + " solve --json " + file + ' ' + example).out);
        CHECK(answer.lost == 0);
        REQUIRE(answer.all.size() == (name == "p3p" ? 8U : 20U));
        REQUIRE(answer.all.size() == expected["solutions"].size());
        std::size_t real = 0;
        // Both put the real ones first. The order of others may depend on the last digits.
        for (const auto& solution : expected["solutions"]) {
            const bool is_real = solution["real"].get<bool>();
            real += is_real ? 1 : 0;
            Numbers parts;
            append_numbers(solution["unknowns"], parts);
            std::size_t near = 0;
            for (std::size_t i = 0; i < answer.all.size(); ++i) {
                double distance = 0;
                for (std::size_t k = 0; k < answer.all[i].size(); ++k) {
                    const Complex z =
                        is_real ? Complex(parts[k]) : Complex(parts[2 * k], parts[2 * k + 1]);
                    distance =
                        std::max(distance, std::abs(answer.all[i][k] - z) / (1 + std::abs(z)));
                }
                if (distance < 1e-8 && answer.is_real[i] == is_real) ++near;
            }
            CHECK(near == 1);
        }
        CHECK(real > 0);
        CHECK(answer.real.size() == real);
    }
}

TEST_CASE("solutions of a header solve the equations") {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        CAPTURE(seed);
        const Numbers depths = random_numbers(12, seed);
        const Answer answer = solvers().solve("p3p", depths);
        CHECK(answer.all.size() == 8);
        for (const std::vector<Complex>& s : answer.all)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = i + 1; j < 3; ++j) {
                    Vector side;
                    for (std::size_t k = 0; k < 3; ++k)
                        side[k] = s[i] * depths[3 * i + k] - s[j] * depths[3 * j + k];
                    CHECK(std::abs(dot(side, side) - depths[9 + i + j - 1]) <
                          1e-12 * (1 + std::norm(s[i]) + std::norm(s[j])));
                }

        const Numbers images = random_numbers(30, seed);
        const Answer poses = solvers().solve("pairs", images);
        CHECK(poses.all.size() == 20);
        for (const std::vector<Complex>& unknowns : poses.all) {
            const Vector q{unknowns[0], unknowns[1], unknowns[2]};
            const Vector t{1, unknowns[3], unknowns[4]};
            const double size = (1 + std::norm(q[0]) + std::norm(q[1]) + std::norm(q[2])) *
                                (1 + std::abs(t[1]) + std::abs(t[2]));
            for (std::size_t i = 0; i < 5; ++i) {
                const Vector y = rotated(q, vector_of(images, i));
                CHECK(std::abs(dot(vector_of(images, 5 + i), cross(t, y))) < 1e-12 * size);
            }
        }
        for (const Numbers& pose : poses.real) {
            const Vector t = vector_of(pose, 3);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    CHECK(std::abs(dot(vector_of(pose, i), vector_of(pose, j)) -
                                   (i == j ? 1.0 : 0.0)) < 1e-12);
            CHECK(std::abs(cross(vector_of(pose, 0), vector_of(pose, 1))[2] - pose[8]) < 1e-12);
            for (std::size_t i = 0; i < 5; ++i) {
                const Vector x = vector_of(images, i);
                const Vector y{dot(vector_of(pose, 0), x), dot(vector_of(pose, 1), x),
                               dot(vector_of(pose, 2), x)};
                CHECK(std::abs(dot(vector_of(images, 5 + i), cross(t, y))) <
                      1e-12 * (1 + std::sqrt(std::abs(dot(t, t)))));
            }
        }
    }
}

TEST_CASE("data with fewer solutions are no trouble for a header") {
    // The rays are one: the distances of points on it do not fit.
    const Answer none = solvers().solve("p3p", {0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1});
    CHECK(none.all.size() + none.lost == 8);
    CHECK(none.all.size() < 8);
    for (const std::vector<Complex>& s : none.all)
        for (const Complex& z : s)
            CHECK(std::isfinite(std::abs(z)));
}

TEST_CASE("plprove generate writes the same each time, and says what it wrote") {
    const TemporaryFolder folder;
    const std::string path = (folder / "p3p.h").string();
    const std::string command = plprove + " generate " + models + "p3p.model";
    const Outcome report = run(command + " -o " + path);
    CHECK(report.out == "model       p3p\n"
                        "solutions   8 complex solutions for generic data: as many as modulo a "
                        "prime, and as the model claims\n"
                        "solver      " +
                            path + ": p3p::solve\n");
    const Outcome printed = run(command + " --threads 3");
    CHECK(printed.out == read_file(path));
    CHECK(printed.err.empty());
    CHECK(printed.out.find("#include \"p3p.h\"\n") != std::string::npos);
    CHECK(run(command + " --seed 1").out != printed.out);
    CHECK(run(plprove + " generate - < " + models + "p3p.model").out == printed.out);
    const auto json = nlohmann::json::parse(run(command + " --json --name pose -o " + path).out);
    CHECK(json["solutions"] == 8);
    CHECK(json["namespace"] == "pose");
    CHECK(read_file(path).find("namespace pose {") != std::string::npos);
}

TEST_CASE("the example in the comment of a header compiles") {
    const std::string start = "//     ";
    std::string example;
    for (const std::string& line : lines_of(read_file(solvers().path("pairs.h")))) {
        if (line == start + "#include \"pairs.h\"") example = "\n";
        if (!example.empty() && line.starts_with("//"))
            example += line.substr(std::min(line.size(), start.size())) + '\n';
        if (line == start + '}') break;
    }
    CHECK(example.find("data.x1_2[0][0] = 0.5;") != std::string::npos);
    write_file(solvers().path("example.cpp"), example);
    const Outcome outcome = run(std::string(CXX) + " -std=c++17 -Wall -Wextra -Werror " +
                                solvers().path("example.cpp") + " -fsyntax-only");
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
}

TEST_CASE("names of a model that C++ has for something else are others in a header") {
    const TemporaryFolder folder;
    const std::string model = (folder / "word.model").string();
    write_file(model, "model double\ndata int, real\nunknown residual, u\n"
                      "equation residual^2 = int + u\nequation u*residual = real\n");
    const Outcome header = run(plprove + " generate " + model);
    CHECK(header.status == 0);
    for (const char* line :
         {"\nnamespace double_model {\n", "    double int_ = {};\n", "    double real_ = {};\n",
          "    double residual_ = {};\n", "    double u = {};\n", "    bool real = false;\n"})
        CHECK(header.out.find(line) != std::string::npos);
}

TEST_CASE("plprove generate refuses what has no solver, and writes nothing") {
    const TemporaryFolder folder;
    const std::string header = (folder / "out.h").string();
    const auto complaint = [&](const std::string& arguments, int status) {
        const Outcome outcome = run(plprove + " generate " + arguments + " -o " + header);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        CHECK(!std::filesystem::exists(header));
        return outcome.err;
    };
    const auto model = [&](const std::string& text) {
        write_file(folder / "m.model", text);
        return (folder / "m.model").string();
    };
    CHECK(complaint("none.model", 2) ==
          "plprove: cannot read none.model: name a file with a model\n");
    CHECK(complaint("'6*P/P'", 2).find("6*P/P is not minimal") != std::string::npos);
    CHECK(complaint("P/Q", 2).starts_with("plprove: not a problem: "));
    CHECK(complaint(model("model m\ndata a, b\nunknown x\nequation x = a\nequation x = b\n"), 2)
              .find("2 equations for 1 unknown") != std::string::npos);
    // Two equations that say the same: solutions come in curves.
    CHECK(complaint(model("model m\ndata a\nunknown x, y\nequation x + y = a\n"
                          "equation 2*x + 2*y = 2*a\n"),
                    2)
              .find("no data with a solution were found") != std::string::npos);
    CHECK(complaint(model("model m\nclaimed 3\ndata a\nunknown x\nequation x^2 = a\n"), 2)
              .find("2 solutions were found, but the model claims 3") != std::string::npos);
    CHECK(complaint(model("model m\nclaimed 10001\ndata a\nunknown x\nequation x^2 = a\n"), 2)
              .find("10001 solutions are too many") != std::string::npos);
    CHECK(complaint(models + "p3p.model --name int", 3).find("--name") != std::string::npos);
}
