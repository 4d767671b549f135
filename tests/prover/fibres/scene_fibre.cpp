// Fibres of problems in general: their solutions solve the equations of certs/FORMAT.md, section
// 14, which are written here once more, in vectors.
#include "prover/fibres/scene_fibre.h"

#include "prover/geometry/quaternion.h"
#include "prover/model/fields.h"
#include "prover/problem/notation.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

const model::Algebra* algebra = nullptr; // of the numbers below

/// A number modulo q and g.
struct Value {
    model::Univariate polynomial;

    Value() = default;
    explicit Value(model::Univariate a) : polynomial(std::move(a)) {}
    explicit Value(int integer) : polynomial(algebra->constant(integer)) {}
    friend Value operator+(const Value& a, const Value& b) {
        return Value(model::Algebra::sum(a.polynomial, b.polynomial));
    }
    friend Value operator-(const Value& a, const Value& b) {
        return Value(model::Algebra::difference(a.polynomial, b.polynomial));
    }
    friend Value operator*(const Value& a, const Value& b) {
        return Value(algebra->product(a.polynomial, b.polynomial));
    }
    bool is_zero() const { return polynomial.is_zero(); }
};

using Vector = std::array<Value, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Value dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector vector(std::span<const int> numbers) {
    return {Value(numbers[0]), Value(numbers[1]), Value(numbers[2])};
}

struct Camera {
    std::array<Vector, 3> rows;
    Vector t;

    Vector image(const Vector& x, const Value& depth) const {
        Vector result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = dot(rows[i], x) + t[i] * depth;
        return result;
    }
};

/// The second camera of these coordinates.
Camera projective(std::span<const Value> n) {
    return {{Vector{}, {Value(1), n[0], n[1]}, {n[3], n[4], n[5]}}, {Value(1), n[2], n[6]}};
}
Camera calibrated(std::span<const Value> n) {
    return {quaternion_matrix(std::array{Value(1), n[0], n[1], n[2]}), {Value(1), n[3], n[4]}};
}

struct Example {
    SceneFibre fibre;
    model::Algebra modulo;
    std::vector<Value> unknowns;

    explicit Example(SceneFibre found)
        : fibre(std::move(found)), modulo(fibre.solutions.polynomial) {
        algebra = &modulo;
        for (const model::Univariate& unknown : fibre.solutions.unknowns)
            unknowns.emplace_back(unknown);
    }

    Value form() const {
        Value sum;
        for (std::size_t k = 0; k < fibre.form.size(); ++k)
            sum = sum + Value(fibre.form[k]) * unknowns[k];
        return sum;
    }
    std::span<const Value> depths() const { return std::span(unknowns).subspan(fibre.form.size()); }
};

/// The image vector of a point whose numbers in the view begin at `first`.
Vector seen(const Example& example, std::size_t view, std::size_t first) {
    return vector(std::span(example.fibre.views[view]).subspan(first));
}

/// Whether the camera sees the place at y.
bool sees(const Camera& camera, const Vector& x, const Value& depth, const Vector& y) {
    return std::ranges::all_of(cross(y, camera.image(x, depth)), &Value::is_zero);
}

/// The fibre of a seed of which one is found.
Example example(const std::string& text, int degree) {
    const auto scenes = find_scenes(parse_problem(text), degree, 1);
    REQUIRE(scenes);
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        if (auto fibre = find_scene_fibre(*scenes, seed, 3, [](long) {}))
            return Example(std::move(*fibre));
    throw std::runtime_error("no fibre was found");
}

void check_form(const Example& example, int degree) {
    CHECK(example.fibre.degree() == degree);
    CHECK(nmod_poly_is_squarefree(example.fibre.solutions.polynomial.get()) != 0);
    const model::Univariate t = example.modulo.reduced(model::Univariate({Modular(0), Modular(1)}));
    CHECK((example.form() - Value(t)).is_zero());
}

} // namespace

TEST_CASE("images of a fibre have coordinates as large as it may use") {
    const auto scenes = find_scenes(parse_problem("projective: 7*P/P"), 3, 1);
    REQUIRE(scenes);
    for (const int most : {3, 20}) {
        const auto fibre = find_scene_fibre(*scenes, 0, most, [](long) {});
        REQUIRE(fibre);
        int largest = 0;
        for (const auto& view : fibre->views)
            for (const int coordinate : view)
                largest = std::max(largest, std::abs(coordinate));
        CHECK(largest <= most);
        CHECK(largest > most / 2);
    }
}

TEST_CASE("solutions of seven points in two projective views") {
    const Example fibre = example("projective: 7*P/P", 3);
    check_form(fibre, 3);
    REQUIRE(fibre.unknowns.size() == 7 + 7);
    const Camera camera = projective(fibre.unknowns);
    for (std::size_t p = 0; p < 7; ++p)
        CHECK(sees(camera, seen(fibre, 0, 3 * p), fibre.depths()[p], seen(fibre, 1, 3 * p)));
}

TEST_CASE("solutions of five points, three on a line, in two calibrated views") {
    const Example fibre = example("3*PL/PL + 2*P/P", 16);
    check_form(fibre, 16);
    REQUIRE(fibre.unknowns.size() == 5 + 4);
    const Camera camera = calibrated(fibre.unknowns);
    const auto depths = fibre.depths();
    constexpr std::size_t factors = 6; // of the third point; those of free ones are around
    for (const auto& [first, depth] : {std::pair(0U, 0U), {3U, 1U}, {8U, 2U}, {11U, 3U}})
        CHECK(sees(camera, seen(fibre, 0, first), depths[depth], seen(fibre, 1, first)));
    const auto combined = [&](std::size_t view, const auto& a, const auto& b) {
        const std::vector<int>& numbers = fibre.fibre.views[view];
        return Value(numbers[factors]) * a + Value(numbers[factors + 1]) * b;
    };
    const auto third = [&](std::size_t view) {
        const Vector a = seen(fibre, view, 0), b = seen(fibre, view, 3);
        return Vector{combined(view, a[0], b[0]), combined(view, a[1], b[1]),
                      combined(view, a[2], b[2])};
    };
    CHECK(sees(camera, third(0), combined(0, depths[0], depths[1]), third(1)));
}
