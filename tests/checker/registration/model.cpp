// The models of registrations: their texts are the committed ones, and a camera that sees the scene
// satisfies their equations, for each type.
#include "checker/registration/model.h"
#include "checker/model/layout.h"
#include "checker/model/sparse_polynomial.h"
#include "tests/checker/registration/committed.h"
#include "tests/support/file.h"
#include "tests/support/text.h"

#include <random>
#include <set>

using namespace checker;
using namespace registrations;

namespace {
using Vector = std::array<Residue, 3>;
using Values = std::map<std::string, std::vector<Residue>>;

Residue product(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector crossed(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A camera X -> R X + t, and a scene of the type that it sees, modulo q: data and unknowns by the
/// names of the model. The same frames as in the model.
class Scene {
public:
    explicit Scene(const Registration& type) : random_(7) {
        std::size_t rays = 0, group = 0, ray = 0, stars = 0, pin = 0;
        for (std::size_t size = 0; size < type.groups.size(); ++size)
            rays += size * type.groups[size];
        for (const unsigned count : type.stars)
            stars += count;
        const bool two_lines = type.lines == 2 && rays == 2 && stars == 0 && type.incidences == 0;
        const bool points = type.lines == 0 && stars >= 2;
        type.lines > 0 || points ? draw_circles() : draw_rotation();
        if (points || two_lines) t_[2] = {};
        std::size_t star = 0;
        for (std::size_t pins = 0; pins < type.stars.size(); ++pins)
            for (unsigned i = 0; i < type.stars[pins]; ++i) {
                add_star(++star, points);
                for (std::size_t own = 0; own < pins; ++own)
                    add_pin(star, ++pin);
            }
        for (unsigned i = 1; i <= type.lines; ++i)
            add_line(i, two_lines);
        for (unsigned i = 1; i <= type.incidences; ++i) {
            const Vector Y = vector();
            set("Y", i, Y);
            set("y", i, crossed(vector(), seen(Y)));
        }
        for (std::size_t size = 0; size < type.groups.size(); ++size)
            for (unsigned i = 0; i < type.groups[size]; ++i) {
                const Vector C = vector();
                set("C", ++group, C);
                for (std::size_t own = 0; own < size; ++own)
                    add_ray(++ray, C);
            }
    }

    const Values& values() const { return values_; }

private:
    Residue scalar() { return Residue::of(random_()); }
    Vector vector() { return {scalar(), scalar(), scalar()}; }

    void set(const std::string& name, std::size_t number, const Vector& v) {
        values_[name + std::to_string(number)] = {v[0], v[1], v[2]};
    }

    void draw_rotation() {
        const auto [x, y, z] = vector();
        values_["q"] = {x, y, z};
        const Residue n = (Residue{1} + x * x + y * y + z * z).inverse(), two{2}, one{1};
        R_ = {Vector{one + x * x - y * y - z * z, two * (x * y - z), two * (x * z + y)},
              Vector{two * (x * y + z), one - x * x + y * y - z * z, two * (y * z - x)},
              Vector{two * (x * z - y), two * (y * z + x), one - x * x - y * y + z * z}};
        for (Vector& row : R_)
            for (Residue& entry : row)
                entry = entry * n;
    }

    void draw_circles() {
        const Residue u = scalar(), v = scalar(), one{1}, two{2};
        values_["u"] = {u};
        values_["v"] = {v};
        const Residue n = (one + u * u).inverse(), m = (one + v * v).inverse();
        const Residue c = (one - u * u) * n, s = two * u * n;
        const Residue d = (one - v * v) * m, e = two * v * m;
        R_ = {Vector{c, -(s * d), s * e}, Vector{s, c * d, -(c * e)}, Vector{Residue{}, e, d}};
    }

    Vector turned(const Vector& v) const {
        return {product(R_[0], v), product(R_[1], v), product(R_[2], v)};
    }

    Vector seen(const Vector& point) const {
        const Vector v = turned(point);
        return {v[0] + t_[0], v[1] + t_[1], v[2] + t_[2]};
    }

    Vector on_line(const Vector& point, const Vector& direction) {
        const Residue at = scalar();
        return {point[0] + at * direction[0], point[1] + at * direction[1],
                point[2] + at * direction[2]};
    }

    void add_star(std::size_t number, bool points) {
        Vector X = number == 1 ? Vector{} : vector();
        if (points && number == 2) X = {X[0], Residue{}, Residue{}};
        const std::string n = std::to_string(number);
        const Vector x = seen(X);
        set("x", number, x);
        set("X", number, X);
        if (!points || number > 2) return;
        values_["a" + n] = {x[0]};
        values_["b" + n] = {x[1]};
        values_["h2"] = {X[0]};
    }

    void add_pin(std::size_t star, std::size_t number) {
        const std::vector<Residue>& X = values_["X" + std::to_string(star)];
        const Vector P = vector();
        set("P", number, P);
        set("p", number, seen(on_line({X[0], X[1], X[2]}, P)));
    }

    void add_line(std::size_t number, bool two_lines) {
        Vector L = vector(), D = vector();
        if (number == 1) { // its image is (0, 0, 1)
            D = {Residue{1}, Residue{}, Residue{}};
            L[2] = -(t_[2] + R_[2][1] * L[1]) * R_[2][2].inverse();
        }
        if (two_lines) L = {Residue{}, Residue{}, number == 1 ? Residue{} : L[2]};
        if (two_lines && number == 2) {
            D[2] = {};
            values_["h"] = {L[2]};
            values_["a"] = {D[0]};
            values_["b"] = {D[1]};
        }
        set("L", number, L);
        set("D", number, D);
        set("l", number, crossed(seen(L), turned(D)));
    }

    void add_ray(std::size_t number, const Vector& C) {
        const Vector E = vector();
        set("E", number, E);
        set("e", number, seen(on_line(C, E)));
    }

    std::mt19937_64 random_;
    std::array<Vector, 3> R_{};
    Vector t_ = vector();
    Values values_;
};

std::string text_of(const Registration& type) {
    return lines_of_model(model_of(type));
}

Program program_of(const Registration& type) {
    const std::string text = text_of(type) + "modulus 1\n";
    Reader reader(text);
    return read_program(reader);
}
} // namespace

TEST_CASE("a camera that sees the scene satisfies the equations of the model, for each type") {
    std::size_t equations = 0;
    for (const auto& [type, bound] : committed()) {
        CAPTURE(name_of(type));
        const Program program = program_of(type);
        const Layout layout = layout_of(program);
        const Values values = Scene(type).values();
        SparsePolynomials<Residue> ring(1, [](std::uint64_t) {});
        Given<SparsePolynomials<Residue>> given;
        for (const Declared* declared : {&layout.data, &layout.unknowns})
            for (const auto& [name, size] : declared->names) {
                CAPTURE(name);
                REQUIRE(values.at(name).size() == size);
                for (const Residue value : values.at(name))
                    given[name].push_back(ring.value(value));
            }
        const auto outcome = Machine<SparsePolynomials<Residue>>(ring, given).run(program);
        for (const auto& equation : outcome.equations)
            CHECK(equation.terms.empty());
        for (const auto& condition : outcome.conditions)
            CHECK_FALSE(condition.terms.empty());
        equations += outcome.equations.size();
    }
    CHECK(committed().size() == 89);
    CHECK(equations > 89 * 3);
}

TEST_CASE("the texts are the committed ones, whose names say the type") {
    std::set<std::string> names;
    for (const auto& [type, bound] : committed()) {
        const std::string name = name_of(type);
        CAPTURE(name);
        const std::string text =
            read(SOURCE_DIR "/models/registrations/" + name.substr(13) + ".model");
        CHECK(lines_of_model(text) == text_of(type));
        CHECK(names.insert(name).second);
    }
    CHECK(name_of(relative_pose) == "registration_s_l0_i0_r5");
    CHECK(name_of({.stars = {2, 1}, .groups = {0, 1}}) == "registration_s001_l0_i0_r1");
}
