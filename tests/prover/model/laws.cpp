// Numbers of solutions that are known: Bezout's theorem, famous systems, and the models of the
// literature.
#include "prover/model/certificate.h"
#include "prover/model/solution_point.h"

#include <array>
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace plprove::model;

/// As many equations as unknowns, with all monomials of this degree, and data as coefficients.
std::string general_system(int unknowns, int degree) {
    const std::string n = std::to_string(unknowns), size = std::to_string(unknowns + 1);
    std::string list = "[1";
    for (int i = 1; i <= unknowns; ++i)
        list += ", x[" + std::to_string(i) + "]";
    std::string text = "model general\ndata a[1.." + n + "] : vector " + size;
    for (int d = 1; d < degree; ++d)
        text += ", b" + std::to_string(d) + "[1.." + n + "] : matrix " + size + " by " + size;
    text += "\nunknown x : vector " + n + "\nlet y = " + list + "]\nfor i in 1.." + n +
            "\nlet f1 = a[i]\n";
    for (int d = 1; d < degree; ++d)
        text += "let f" + std::to_string(d + 1) + " = b" + std::to_string(d) + "[i]*y + dot(f" +
                std::to_string(d) + ", y)*a[i]\n";
    return text + "equation dot(f" + std::to_string(degree) + ", y) = 0\nend\n";
}

/// By the names of their files.
std::map<std::string, Model> models_of_literature() {
    std::map<std::string, Model> models;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(SOURCE_DIR) + "/models")) {
        if (!entry.is_regular_file()) continue; // registrations/
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        models.emplace(entry.path().stem().string(), read_model(text.str()));
    }
    return models;
}

/// What a committed certificate shows; empty where it shows nothing.
struct Certificate {
    std::string claimed, at_least, at_most;
};

Certificate read_certificate(const std::string& name) {
    std::ifstream file(std::string(SOURCE_DIR) + "/certs/models/" + name + ".plc");
    Certificate shown;
    std::string word;
    while (file >> word) {
        if (word == "claimed") file >> shown.claimed;
        if (word == "fibre" || word == "distinct") file >> shown.at_least;
        if (word != "basis") continue;
        std::size_t size = 0;
        while (file >> word && word != "rows")
            size += word == "\\" ? 0 : 1;
        shown.at_most = std::to_string(size);
    }
    return shown;
}

} // namespace

TEST_CASE("general equations have as many solutions as Bezout says") {
    for (const auto& [unknowns, degree, count] : std::vector<std::array<int, 3>>{
             {1, 5, 5}, {2, 2, 4}, {2, 3, 9}, {3, 2, 8}, {4, 2, 16}, {3, 3, 27}}) {
        CAPTURE(unknowns);
        CAPTURE(degree);
        const Study found = study(general_system(unknowns, degree));
        CHECK(found.at_least() == static_cast<std::size_t>(count));
        CHECK(found.at_most() == static_cast<std::size_t>(count));
    }
}

TEST_CASE("bilinear equations have a binomial number of solutions") {
    const Study found =
        study("model bilinear\ndata a[1..4] : matrix 3 by 3\nunknown x[1..2], y[1..2]\n"
              "for i in 1..4\nequation dot([x[1], x[2], 1], a[i]*[y[1], y[2], 1]) = 0\n"
              "end\n");
    CHECK(found.at_least() == 6);
    CHECK(found.at_most() == 6);
}

TEST_CASE("cyclic 5-roots are 70") {
    const Model model =
        read_model("model cyclic\nunknown a, b, c, d, e\nequation a + b + c + d + e = 0\n"
                   "equation a*b + b*c + c*d + d*e + e*a = 0\n"
                   "equation a*b*c + b*c*d + c*d*e + d*e*a + e*a*b = 0\n"
                   "equation a*b*c*d + b*c*d*e + c*d*e*a + d*e*a*b + e*a*b*c = 0\n"
                   "equation a*b*c*d*e = 1\n");
    const auto fibre = find_fibre(model, compile(model)).fibre;
    REQUIRE(fibre);
    CHECK(fibre->count() == 70);
}

TEST_CASE("only solutions that are regular and keep the conditions count") {
    const auto count = [](const std::string& body) {
        return study("model m\ndata a, b\nunknown x\n" + body).at_least();
    };
    CHECK(count("equation x^2 = a\n") == 2);
    CHECK(count("equation x^2*(x - a) = 0\n") == 1);
    CHECK(count("equation (x - a)^2 = 0\n") == 0);
    CHECK(count("equation x*(x - a)*(x - b) = 0\nnonzero x - b\n") == 2);
    CHECK(count("equation (x^2 - a)/x = (b*x - a)/x\n") == 1);
    CHECK(count("equation x = a\nnonzero x - a\n") == 0);
    CHECK(count("equation x^6 = a\ncount x^2\n") == 3);
}

TEST_CASE("where not all solutions are found, there is one, and the reason") {
    const Study found = study("model m\ndata a\nunknown x\nequation x^2 = a\n",
                              [](const Model&, const Program&) -> FibreSearch {
                                  return {{}, "a reason"};
                              });
    CHECK(found.at_least() == 1);
    CHECK(found.at_most() == 2);
    CHECK(found.no_fibre.empty());
    CHECK(found.only_one == "a reason");
}

TEST_CASE("a relation that does not hold is refused") {
    CHECK_THROWS_WITH_AS(
        study("model m\ndata a\nunknown x\nlet y = x^2\nequation y = a\nrelation y = x\n"),
        "line 6, column 1: this relation does not hold for all data and unknowns: correct it, or "
        "write 'equation' if it shall hold for solutions",
        ModelError);
}

TEST_CASE("fewer equations than unknowns have no solution") {
    const Study found = study("model m\ndata a\nunknown x, y\nequation x = a\n");
    CHECK(!found.fibre);
    CHECK(found.no_fibre == "1 equation for 2 unknowns");
    CHECK(found.at_most() == std::size_t{0});
}

TEST_CASE("equations that contradict each other for generic data have no solution") {
    for (const std::string body :
         {"unknown x\nequation x = a\nequation x = b\n",
          "unknown x, y\nequation x = a\nequation x^2 = b\n",
          "unknown x, y\nequation x*y = a\nequation x^2*y^2 = b\nequation x + y = 1\n"}) {
        CAPTURE(body);
        const Study found = study("model m\ndata a, b\n" + body);
        CHECK(!found.fibre);
        CHECK(found.at_most() == std::size_t{0});
    }
}

TEST_CASE("ranks at random solutions tell where solutions are not isolated") {
    const auto seen = [](const std::string& body) {
        return study("model m\ndata a, b\nunknown x, y, z\n" + body).ranks;
    };
    const RanksSeen curves = seen("equation x = a\nequation y = b\nequation x + y = a + b\n");
    CHECK(curves.solutions == 10);
    CHECK(curves.rank == 2);
    CHECK(curves.digits > 100);
    CHECK(seen("equation x*y = a\nequation x*y*z = a*z\nequation z = b\n").rank == 2);
    CHECK(seen("equation x = a\nequation y = b\nequation x*z = y\n").solutions == 0);
}

TEST_CASE("the models of the literature have as many solutions as is certified, and claimed") {
    // Gröbner bases that take half a minute, or are too large.
    const std::set<std::string> slow{"rig_four_points", "rig_six_lines", "three_generalised_views"};
    for (const auto& [name, model] : models_of_literature()) {
        CAPTURE(name);
        CHECK(model.name == name);
        if (slow.contains(name)) {
            if (model.claimed > 0)
                CHECK(read_certificate(name).at_least == std::to_string(model.claimed));
            continue;
        }
        const Program program = compile(model);
        const auto fibre = find_fibre(model, program).fibre;
        REQUIRE(fibre);
        CHECK(std::to_string(fibre->count()) == read_certificate(name).at_least);
        if (model.claimed > 0) CHECK(fibre->count() == static_cast<std::size_t>(model.claimed));
    }
}

TEST_CASE("each model of the literature has a solution that is found by solving for data") {
    // Two equations without data are in the same unknowns; an equation is linear in no data; or its
    // data are those of equations before it.
    const std::set<std::string> exceptions{"radial_absolute_pose",
                                           "four_spheres",
                                           "two_views_triangulation",
                                           "burmester_sphere",
                                           "flexes",
                                           "homography_distortions",
                                           "homography_motion",
                                           "conics_points_conics",
                                           "homography_error",
                                           "depth_priors",
                                           "depth_priors_focals"};
    for (const auto& [name, model] : models_of_literature()) {
        CAPTURE(name);
        const auto found = find_solution_point(model, compile(model)).fibre;
        CHECK(found.has_value() == !exceptions.contains(name));
        if (found) CHECK(found->count() == 1);
    }
}

TEST_CASE("the table of docs/models.md has what the committed certificates show") {
    std::ifstream page(std::string(SOURCE_DIR) + "/docs/models.md");
    std::size_t rows = 0;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| [")) continue;
        const std::string name = line.substr(3, line.find(']') - 3);
        CAPTURE(name);
        const Certificate shown = read_certificate(name);
        const std::string numbers =
            " | " + shown.claimed + " | " + shown.at_least + " | " + shown.at_most + " |";
        CHECK(line.ends_with(numbers));
        ++rows;
    }
    CHECK(rows == models_of_literature().size());
}

TEST_CASE("a certificate is the same each time") {
    std::ostringstream text;
    text << std::ifstream(std::string(SOURCE_DIR) + "/models/five_points.model").rdbuf();
    std::ostringstream committed;
    committed << std::ifstream(std::string(SOURCE_DIR) + "/certs/models/five_points.plc").rdbuf();
    CHECK(write(study(text.str())) == committed.str());
}
