// Laws of all kinds of cameras of the prover, and that the path tracker finds the same solutions
// whichever way it evaluates a camera.
#include "prover/cameras/camera_model.h"
#include "prover/many_views/monodromy.h"
#include "prover/problem/notation.h"

#include <doctest/doctest.h>
#include <random>

using namespace plprove;

namespace {

using Complex = CameraModel::Complex;
using Numbers = std::vector<Complex>;

Numbers random_camera(const CameraModel& model, bool second, std::mt19937& engine) {
    std::uniform_real_distribution<double> real(-1, 1);
    Numbers numbers;
    for (int i = 0; i < model.all_numbers(); ++i)
        numbers.emplace_back(real(engine), real(engine));
    if (second) std::ranges::copy(model.start_of_second, numbers.begin());
    return numbers;
}

/// Shared numbers are those of the conic I.
void make_conic_round(const CameraModel& model, Numbers& numbers) {
    const std::vector<std::vector<Complex>> round{{}, {1}, {}, {0, 0, 1}, {}, {0, 1, 0, 0, 1}};
    std::ranges::copy(round[static_cast<std::size_t>(model.shared)],
                      numbers.begin() + model.numbers);
}

/// The distance of two matrices, where the first is multiplied so that one entry agrees.
double distance_up_to_scale(const CameraMatrix<Complex>& a, const CameraMatrix<Complex>& b) {
    const Complex scale = b[1][1] / a[1][1];
    double result = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result = std::max(result, std::abs(scale * a[i][j] - b[i][j]));
    return result;
}

/// The camera that sees as this one does when all depths are divided by `depths`.
CameraMatrix<Complex> nearer(CameraMatrix<Complex> camera, const Complex& depths) {
    for (auto& row : camera)
        row[3] /= depths;
    return camera;
}

} // namespace

TEST_CASE("the list of kinds has those of the prover and the new one") {
    std::vector<std::string_view> names;
    for (const CameraModel* model : camera_models())
        names.push_back(model->name);
    CHECK(names == std::vector<std::string_view>{
                       "calibrated", "focal", "projective", "shared-focal", "shared-focal-center",
                       "shared-k", "upright", "upright-focal", "upright-shared-focal", "zooming"});
}

TEST_CASE("a camera has as many coordinates as unknowns, the second one less by the motions") {
    for (const CameraModel* model : camera_models()) {
        CAPTURE(model->name);
        CHECK(std::ssize(model->coordinates(false)) == model->unknowns);
        CHECK(std::ssize(model->coordinates(true)) + model->shared == model->dimension(2));
    }
}

TEST_CASE("a normalised camera is the same up to a factor and the scale of space") {
    std::mt19937 engine(1);
    for (const CameraModel* model : camera_models()) {
        CAPTURE(model->name);
        Complex depths = 0;
        for (const bool second : {true, false}) {
            Numbers numbers = random_camera(*model, second, engine);
            const auto before = model->matrix(numbers.data());
            model->normalise(numbers.data(), second, depths);
            CHECK(distance_up_to_scale(model->matrix(numbers.data()), nearer(before, depths)) <
                  1e-9);
            for (const ScaledRun& run : model->scaled_runs(second))
                CHECK(std::abs(numbers[static_cast<std::size_t>(run.first)] - 1.0) < 1e-12);
        }
    }
}

TEST_CASE("numbers of no camera are told") {
    for (const CameraModel* model : camera_models()) {
        if (model->is_camera == nullptr) continue;
        CAPTURE(model->name);
        std::mt19937 engine(2);
        Numbers numbers = random_camera(*model, false, engine);
        CHECK(model->is_camera(numbers.data()));
        make_conic_round(*model, numbers);
        std::fill_n(numbers.begin(), model->numbers, Complex(0));
        if (!model->scaled.empty()) { // a rotation, up to a factor
            numbers[0] = 1;
            numbers[1] = Complex(0, 1); // 1 + i i = 0
        }
        CHECK(!model->is_camera(numbers.data()));
    }
}

TEST_CASE("cameras that are nearly none are cameras") {
    constexpr double near = 1e-4; // the determinant of the matrix is near^3
    for (const CameraModel* model : camera_models()) {
        if (model->is_camera == nullptr || model->scaled.empty()) continue;
        CAPTURE(model->name);
        std::mt19937 engine(3);
        Numbers numbers = random_camera(*model, false, engine);
        make_conic_round(*model, numbers);
        std::fill_n(numbers.begin(), model->scaled[0].count, Complex(0));
        numbers[0] = 1;
        numbers[1] = Complex(0, 1 - near);
        CHECK(model->is_camera(numbers.data()));
    }
}

TEST_CASE("cameras whose conic has rank 2, or with focal length 0, are none") {
    int conics = 0, focal_lengths = 0;
    for (const CameraModel* model : camera_models()) {
        if (model->is_camera == nullptr || model->shared == 0) continue;
        CAPTURE(model->name);
        std::mt19937 engine(4);
        Numbers numbers = random_camera(*model, false, engine);
        make_conic_round(*model, numbers);
        CHECK(model->is_camera(numbers.data()));
        Numbers flat = numbers;
        flat.back() = 0; // the last entry of the conic
        CHECK(!model->is_camera(flat.data()));
        ++conics;
        const ScaledRun turn = model->scaled[0];
        if (model->numbers == turn.count + 3) continue;
        // After the rotation and t: r, or r and s.
        const auto ratio = numbers.begin() + turn.count + 3;
        *ratio = 0;
        if (model->numbers == turn.count + 5) {
            CHECK(model->is_camera(numbers.data()));
            ratio[0] = Complex(0, 1) * ratio[1];
        }
        CHECK(!model->is_camera(numbers.data()));
        ++focal_lengths;
    }
    CHECK(conics == 6);
    CHECK(focal_lengths == 2);
}

TEST_CASE("a focal length each: coordinates are those of K R K1^-1 with any turn about the axis") {
    const auto focal = std::ranges::find(camera_models(), "focal", &CameraModel::name);
    REQUIRE(focal != camera_models().end());
    std::mt19937 engine(5);
    const Numbers numbers = random_camera(**focal, false, engine);
    const auto camera = (*focal)->matrix(numbers.data());
    // M ω⁻¹ Mᵀ is a multiple of diag(ρ², ρ², 1/e), with the ratio ρ of focal lengths.
    const Complex e = numbers.back(), r = numbers[6], s = numbers[7];
    const auto product = [&](std::size_t i, std::size_t j) {
        return camera[i][0] * camera[j][0] + camera[i][1] * camera[j][1] +
               camera[i][2] * camera[j][2] / e;
    };
    CHECK(std::abs(product(0, 1)) < 1e-9);
    CHECK(std::abs(product(0, 2)) < 1e-9);
    CHECK(std::abs(product(1, 2)) < 1e-9);
    CHECK(std::abs(product(0, 0) - product(1, 1)) < 1e-9);
    CHECK(std::abs(product(0, 0) - (r * r + s * s) * e * product(2, 2)) < 1e-9);
    // Rotations that differ by a turn about the axis have the same third row.
    Numbers turned = numbers;
    std::swap(turned[6], turned[7]);
    CHECK((*focal)->matrix(turned.data())[2] == camera[2]);
}

TEST_CASE("monodromy finds the same with the polynomials of the matrix as in a faster way") {
    for (const auto& [text, solutions] :
         {std::pair("5*P/P", 20), std::pair("P/P/P + Pabcde/Pabcde/Pabcde", 64),
          std::pair("projective: 7*P/P", 3)}) {
        CAPTURE(text);
        Problem problem = parse_problem(text);
        CameraModel slower = *problem.cameras;
        CHECK(slower.tracked != TrackedForm::polynomials);
        slower.tracked = TrackedForm::polynomials;
        problem.cameras = &slower;
        many_views::MonodromySettings settings;
        settings.edges = settings.edges_of_few = 5;
        CHECK(many_views::run_monodromy(problem, 1, settings).solutions == solutions);
    }
}
