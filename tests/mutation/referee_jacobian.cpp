#include "tests/mutation/referee_jacobian.h"

#include "prover/geometry/flint.h"
#include "prover/problem/notation.h"

#include <algorithm>

namespace referee {
using plprove::Feature;

mpz_class integer(const std::string& word) {
    mpz_class value;
    demand(!word.empty() && word.find_first_not_of("-0123456789") == word.npos &&
               value.set_str(word, 10) == 0,
           "a number");
    return value;
}

std::size_t index(const std::string& word) {
    const mpz_class value = integer(word);
    demand(value >= 0 && value < 1'000'000, "an index");
    return value.get_ui();
}

static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

static mpz_class dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Camera::turn(const Vector& v) const {
    const mpz_class& a = quaternion[0];
    const Vector u{quaternion[1], quaternion[2], quaternion[3]};
    const Vector uv = cross(u, v);
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = 2 * dot(u, v) * u[i] + (a * a - dot(u, u)) * v[i] + 2 * a * uv[i];
    return result;
}

static Vector unit(std::size_t i) {
    Vector e{0, 0, 0};
    e[i] = 1;
    return e;
}

static Vector vector(const Words& words, std::size_t first) {
    demand(first + 3 <= words.size(), "three coordinates");
    return {integer(words[first]), integer(words[first + 1]), integer(words[first + 2])};
}

Pool read_pool(const Text& file, std::size_t& at, int views) {
    Pool pool;
    ++at;
    for (int view = 2; view <= views; ++view, ++at) {
        demand(at < file.lines.size(), "a camera");
        const Words& words = file.lines[at];
        demand(words.size() == 11 && words[0] == "camera" && words[1] == std::to_string(view) &&
                   words[2] == "quaternion" && words[7] == "translation",
               "a camera");
        Camera camera;
        for (std::size_t i = 0; i < 4; ++i)
            camera.quaternion[i] = integer(words[3 + i]);
        camera.translation = vector(words, 8);
        pool.cameras.push_back(camera);
    }
    for (; at < file.lines.size() && file.lines[at][0] == "feature"; ++at) {
        const Words& words = file.lines[at];
        demand(words.size() >= 6 && words[2] == "point", "a placed feature");
        Placed placed{plprove::parse_feature(words[1]), vector(words, 3), {}};
        for (std::size_t i = 6; i < words.size(); i += 4) {
            demand(words[i] == "pin", "a pin");
            placed.directions.push_back(vector(words, i + 1));
        }
        demand(placed.feature.views() == views, "what each view sees");
        demand(static_cast<int>(placed.directions.size()) == placed.feature.lines, "all pins");
        pool.features.push_back(std::move(placed));
    }
    return pool;
}

/// The equation that an image is kept: of the point, or of a line through it.
struct Equation {
    std::size_t view;
    Vector line;
    std::optional<std::size_t> pin; ///< none: line . dx = 0; else line . de = 0 of this pin
};

/// The equations of a feature in order. Objects to points that section 2 excludes.
static std::vector<Equation> equations(const Placed& placed, const std::vector<Camera>& cameras) {
    std::vector<Equation> list;
    for (const Vector& direction : placed.directions)
        demand(direction[2] != 0, "the third coordinate of a direction");
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        Vector x = cameras[v].turn(placed.point);
        for (std::size_t i = 0; i < 3; ++i)
            x[i] += cameras[v].translation[i];
        const bool sees_point = placed.feature.sees_point(static_cast<int>(v));
        if (sees_point) {
            demand(x[2] != 0, "the third coordinate of an image");
            list.push_back({v, {0, x[2], -x[1]}, {}});
            list.push_back({v, {-x[2], 0, x[0]}, {}});
        }
        for (std::size_t pin = 0; pin < placed.directions.size(); ++pin) {
            if (!placed.feature.sees_line(static_cast<int>(v), static_cast<int>(pin))) continue;
            const Vector line = cross(x, cameras[v].turn(placed.directions[pin]));
            demand(line != Vector{0, 0, 0}, "the image of a line");
            if (!sees_point) list.push_back({v, line, {}});
            list.push_back({v, line, pin});
        }
    }
    return list;
}

/// A motion of one unknown: of a point, a direction, or a camera.
struct Unknown {
    enum Kind { point, direction, rotation, translation } kind;
    std::size_t which; ///< pin, or view
    std::size_t coordinate;
};

static std::vector<Unknown> own_unknowns(const Feature& feature) {
    std::vector<Unknown> list;
    for (std::size_t i = 0; i < (feature.has_point ? 3U : 2U); ++i)
        list.push_back({Unknown::point, 0, i});
    for (std::size_t pin = 0; pin < static_cast<std::size_t>(feature.lines); ++pin)
        for (std::size_t i = 0; i < 2; ++i)
            list.push_back({Unknown::direction, pin, i});
    return list;
}

static std::vector<Unknown> camera_unknowns(std::size_t views) {
    std::vector<Unknown> list;
    for (std::size_t view = 1; view < views; ++view) {
        for (std::size_t i = 0; i < 3; ++i)
            list.push_back({Unknown::rotation, view, i});
        for (std::size_t i = view == 1 ? 1 : 0; i < 3; ++i)
            list.push_back({Unknown::translation, view, i});
    }
    return list;
}

/// How fast the left side of the equation changes with the unknown.
static mpz_class derivative(const Equation& equation, const Unknown& unknown, const Placed& placed,
                            const Camera& camera) {
    const Vector axis = unit(unknown.coordinate);
    switch (unknown.kind) {
    case Unknown::point:
        return equation.pin ? mpz_class(0) : dot(equation.line, camera.turn(axis));
    case Unknown::direction:
        return equation.pin == unknown.which ? dot(equation.line, camera.turn(axis)) : mpz_class(0);
    case Unknown::rotation: {
        if (equation.view != unknown.which) return 0;
        const Vector& arm = equation.pin ? placed.directions[*equation.pin] : placed.point;
        return dot(equation.line, cross(axis, camera.turn(arm)));
    }
    case Unknown::translation:
        return equation.view == unknown.which && !equation.pin ? equation.line[unknown.coordinate]
                                                               : mpz_class(0);
    }
    return 0;
}

Jacobian jacobian(const std::vector<Placed>& features, const std::vector<Camera>& cameras) {
    for (std::size_t v = 1; v < cameras.size(); ++v)
        demand(cameras[v].quaternion != std::array<mpz_class, 4>{0, 0, 0, 0}, "a quaternion");
    demand(cameras.size() > 1 && cameras[1].translation[0] != 0, "the first coordinate of t_2");
    Jacobian result;
    const std::vector<Unknown> camera_columns = camera_unknowns(cameras.size());
    result.cameras = camera_columns.size();
    for (const Placed& placed : features)
        result.own += own_unknowns(placed.feature).size();
    std::size_t first = 0;
    for (const Placed& placed : features) {
        const std::vector<Unknown> own = own_unknowns(placed.feature);
        for (const Equation& equation : equations(placed, cameras)) {
            auto& row = result.rows.emplace_back(result.own + result.cameras);
            const Camera& camera = cameras[equation.view];
            for (std::size_t c = 0; c < own.size(); ++c)
                row[first + c] = derivative(equation, own[c], placed, camera);
            for (std::size_t c = 0; c < camera_columns.size(); ++c)
                row[result.own + c] = derivative(equation, camera_columns[c], placed, camera);
        }
        first += own.size();
    }
    return result;
}

std::uint64_t minor_without(const Jacobian& j, const std::vector<std::size_t>& rows,
                            const std::vector<std::size_t>& columns) {
    const std::size_t size = j.rows.size() - rows.size();
    demand(j.own + j.cameras - columns.size() == size, "a square matrix");
    plprove::ResidueMatrix matrix(static_cast<int>(size), static_cast<int>(size));
    for (std::size_t r = 0, target = 0; r < j.rows.size(); ++r) {
        if (std::ranges::find(rows, r) != rows.end()) continue;
        for (std::size_t c = 0, place = 0; c < j.rows[r].size(); ++c)
            if (std::ranges::find(columns, c) == columns.end())
                matrix.at(static_cast<int>(target), static_cast<int>(place++)) =
                    mpz_fdiv_ui(j.rows[r][c].get_mpz_t(), plprove::modulus);
        ++target;
    }
    return nmod_mat_det(matrix.get());
}

long own_rank(const Jacobian& j, const std::vector<mpz_class>* beside) {
    plprove::IntegerMatrix matrix(static_cast<int>(j.rows.size()),
                                  static_cast<int>(j.own + (beside ? 1 : 0)));
    for (std::size_t r = 0; r < j.rows.size(); ++r) {
        for (std::size_t c = 0; c < j.own; ++c)
            fmpz_set_mpz(matrix.at(static_cast<int>(r), static_cast<int>(c)),
                         j.rows[r][c].get_mpz_t());
        if (beside)
            fmpz_set_mpz(matrix.at(static_cast<int>(r), static_cast<int>(j.own)),
                         (*beside)[r].get_mpz_t());
    }
    return fmpz_mat_rank(matrix.get());
}
} // namespace referee
