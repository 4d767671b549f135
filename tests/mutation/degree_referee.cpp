#include "tests/mutation/degree_referee.h"

#include "prover/fibres/cameras_over.h"
#include "prover/fibres/univariate_field.h"
#include "prover/minimal/obstruction.h"
#include "prover/problem/notation.h"
#include "prover/three_views/scene.h"
#include "tests/mutation/bases.h"

#include <Eigen/LU>
#include <algorithm>
#include <flint/ulong_extras.h>

namespace mutation {

namespace {

using Number = std::complex<long double>;
using Vector = std::array<Number, 3>;
using Point = Eigen::Vector<Number, plprove::camera_dimension>;
using Words = std::vector<std::string>;

Number dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// R^T x for the quaternion (1, u): (1 - u·u) x + 2 (u·x) u - 2 u × x.
Vector rotated_back(const Vector& u, const Vector& x) {
    const Vector across = cross(u, x);
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = (1.0L - dot(u, u)) * x[i] + 2.0L * (dot(u, x) * u[i] - across[i]);
    return result;
}

/// The camera equations of a class at images with integer coordinates.
class Equations {
public:
    Equations(const plprove::CameraSystem& system, const std::vector<plprove::Complex3>& vectors)
        : system_(system) {
        for (const plprove::Complex3& x : vectors)
            vectors_.push_back({x[0], x[1], x[2]});
    }

    Point values(const Point& z) const {
        const std::array<Vector, 3> turn{Vector{}, {z[0], z[1], z[2]}, {z[3], z[4], z[5]}};
        const std::array<Vector, 3> centre{Vector{}, {1.0L, z[6], z[7]}, {z[8], z[9], z[10]}};
        const auto view = [&](int vector) {
            return static_cast<std::size_t>(system_.vectors[static_cast<std::size_t>(vector)].view);
        };
        const auto direction = [&](int vector) {
            return rotated_back(turn[view(vector)], vectors_[static_cast<std::size_t>(vector)]);
        };
        Point result;
        for (std::size_t e = 0; e < system_.equations.size(); ++e) {
            const auto& [kind, at] = system_.equations[e];
            Number& value = result[static_cast<Eigen::Index>(e)];
            const Vector first = direction(at[0]), second = direction(at[1]);
            const auto between = [&](int a, int b) {
                return difference(centre[view(a)], centre[view(b)]);
            };
            if (kind == plprove::EquationKind::epipolar) {
                value = dot(between(at[1], at[0]), cross(first, second));
                continue;
            }
            const Vector third = direction(at[2]);
            value = kind == plprove::EquationKind::pencil
                        ? dot(first, cross(second, third))
                        : dot(second, between(at[0], at[1])) * dot(third, first) -
                              dot(third, between(at[0], at[2])) * dot(second, first);
        }
        return result;
    }

    /// Where Newton's method leads; nothing if it does not converge quickly. Each equation is of
    /// degree at most 2 in each unknown, so that differences give the derivatives exactly.
    std::optional<Point> solve(Point z) const {
        constexpr int most_steps = 25;
        constexpr long double small = 1e-12L, rounding = 1e-8L; // steps near bad solutions
        long double relative = 1;
        for (int step = 0; step < most_steps && relative > small; ++step) {
            Eigen::Matrix<Number, plprove::camera_dimension, plprove::camera_dimension> jacobian;
            for (Eigen::Index k = 0; k < z.size(); ++k) {
                const long double h = 1 + std::abs(z[k]);
                Point more = z, less = z;
                more[k] += h;
                less[k] -= h;
                jacobian.col(k) = (values(more) - values(less)) / (2 * h);
            }
            const Point change = jacobian.partialPivLu().solve(values(z));
            z -= change;
            relative = 0;
            for (Eigen::Index k = 0; k < z.size(); ++k)
                relative = std::max(relative, std::abs(change[k]) / (1 + std::abs(z[k])));
            if (!std::isfinite(relative)) return {};
        }
        return relative < rounding ? std::optional(z) : std::nullopt;
    }

private:
    const plprove::CameraSystem& system_;
    std::vector<Vector> vectors_;
};

/// The numbers of a line from some word on; nothing if one of these is none.
std::optional<std::vector<double>> numbers(const Words& words, std::size_t first,
                                           std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = first; i < first + count; ++i) {
        char* end = nullptr;
        if (i >= words.size() || words[i].empty()) return {};
        result.push_back(std::strtod(words[i].c_str(), &end));
        if (*end != '\0') return {};
    }
    return result;
}

/// The free vectors of the images, as these lines give them; nothing if they are not those of the
/// system.
std::optional<plprove::Images> images(const plprove::CameraSystem& system,
                                      const std::vector<const Words*>& lines) {
    if (lines.size() != system.features.size()) return {};
    plprove::Images result;
    auto free = system.free.begin();
    for (std::size_t f = 0; f < lines.size(); ++f) {
        const Words& words = *lines[f];
        if (words.size() < 2 || words[1] != plprove::notation(system.features[f])) return {};
        std::size_t place = 2;
        for (int view = -1; free != system.free.end() && free->feature == static_cast<int>(f);
             ++free, place += 4) {
            if (free->view != view && (place >= words.size() || words[place++] != "view"))
                return {};
            view = free->view;
            const char* name = free->line < 0 ? "point" : free->toward ? "toward" : "line";
            const auto x = numbers(words, place + 1, 3);
            if (!x || words[place] != name) return {};
            result.push_back({(*x)[0], (*x)[1], (*x)[2]});
        }
        if (place != words.size()) return {};
    }
    return result;
}

/// The starting values of a solution.
std::optional<Point> start(const Words& words) {
    const bool real = words[0] == "real";
    const std::size_t each = real ? 1 : 2;
    const auto bits = numbers(words, 1, 1);
    const auto values = numbers(words, 2, plprove::camera_dimension * each);
    if (!bits || !values) return {};
    Point result;
    for (Eigen::Index k = 0; k < result.size(); ++k) {
        const auto i = static_cast<std::size_t>(k) * each;
        result[k] = {std::ldexp((*values)[i], -static_cast<int>((*bits)[0])),
                     real ? 0 : std::ldexp((*values)[i + 1], -static_cast<int>((*bits)[0]))};
    }
    return result;
}

bool differ(const Point& a, const Point& b) {
    constexpr long double apart = 1e-8L;
    for (Eigen::Index k = 0; k < a.size(); ++k)
        if (std::abs(a[k] - b[k]) > apart * (1 + std::abs(a[k]))) return true;
    return false;
}

plprove::QuaternionCameras cameras(const Point& z) {
    plprove::CameraPoint point;
    for (std::size_t k = 0; k < point.size(); ++k)
        point[k] = plprove::Complex(z[static_cast<Eigen::Index>(k)]);
    return plprove::standard_chart().cameras(point);
}

/// The lines of a file without comments; lines that go on in others are one.
File whole_lines(const std::string& text) {
    File lines;
    bool goes_on = false;
    for (const Words& words : split(text)) {
        if (words[0].starts_with('#')) continue;
        if (!goes_on) lines.emplace_back();
        Words& line = lines.back();
        line.insert(line.end(), words.begin(), words.end());
        goes_on = line.back() == "\\";
        if (goes_on) line.pop_back();
    }
    return lines;
}

/// The polynomial with the residues of a line from some word on, and a further coefficient 1 if it
/// is monic.
plprove::model::Univariate polynomial(const Words& words, std::size_t first, bool monic) {
    std::vector<plprove::Modular> coefficients;
    for (std::size_t i = first; i < words.size(); ++i)
        coefficients.push_back(plprove::Modular::of(std::stoull(words[i])));
    if (monic) coefficients.push_back(plprove::Modular(1));
    return plprove::model::Univariate(coefficients);
}

/// Why the lines of a fibre do not solve the equations; they conform, and the checker accepts them.
/// All is done by FLINT, and by the prover's equations and derivatives.
std::optional<std::string> objection_to_fibre(const plprove::CameraSystem& system,
                                              const plprove::Images& free,
                                              const std::vector<const Words*>& lines) {
    using plprove::model::Univariate;
    const Univariate g = polynomial(*lines[1], 1, true);
    if (nmod_poly_is_squarefree(g.get()) == 0) return "the polynomial has a multiple root";
    const plprove::UnivariateField field(g);
    std::vector<Univariate> coordinates;
    Univariate sum = field.constant(0);
    for (std::size_t k = 0; k < plprove::camera_dimension; ++k) {
        coordinates.push_back(polynomial(*lines[2 + k], 1, false));
        const int factor = std::stoi((*lines[2 + plprove::camera_dimension])[2 + k]);
        sum = field.sum(sum, field.scaled(coordinates.back(), factor));
    }
    const Univariate t = field.reduced(Univariate({plprove::Modular(0), plprove::Modular(1)}));
    if (nmod_poly_equal(sum.get(), t.get()) == 0) return "the sum is not t";
    std::vector<plprove::IntegerVector> vectors;
    for (const plprove::Complex3& x : free)
        vectors.push_back({static_cast<std::int64_t>(x[0].real()),
                           static_cast<std::int64_t>(x[1].real()),
                           static_cast<std::int64_t>(x[2].real())});
    const plprove::CameraImages images = plprove::camera_images(system, vectors);
    plprove::CamerasOver cameras(field, images, coordinates);
    const auto vanishes = [](const Univariate& value) { return value.is_zero(); };
    if (!std::ranges::all_of(cameras.values(), vanishes)) return "an equation is not 0";
    const Univariate determinant = plprove::model::determinant(field, cameras.gradients());
    if (field.without_common_factors(determinant).degree() != g.degree())
        return "a singular Jacobian";
    if (lines.back()->front() != "factor") return {};
    const Univariate factor = polynomial(*lines.back(), 2, true);
    if (nmod_poly_is_irreducible(factor.get()) == 0 || n_is_prime(factor.degree()) == 0)
        return "the factor is reducible, or of a degree that is no prime";
    if (field.without_common_factors(factor).degree() != g.degree() - factor.degree())
        return "the factor is none";
    return {};
}

/// The records of this class in a file that conforms.
std::vector<File> records_of(const std::string& text, std::size_t number) {
    std::vector<File> found;
    for (const File& record : records(whole_lines(text)))
        if (class_of(record) == number) found.push_back(record);
    return found;
}

/// Why the record does not show this number of different solutions of the class with this number.
std::optional<std::string> objection_to_record(const File& record, std::size_t number,
                                               std::size_t solutions) {
    const auto& classes = plprove::label_classes();
    if (number >= classes.size()) return "no such class";
    if (plprove::obstruction(plprove::problem_of(classes[number])).deficiency() != 0)
        return "the class is not minimal";
    std::vector<const Words*> image_lines, solution_lines;
    for (std::size_t i = 1; i < record.size(); ++i)
        (record[i][0] == "image" ? image_lines : solution_lines).push_back(&record[i]);

    const plprove::CameraSystem system = plprove::camera_system(classes[number]);
    const auto free = images(system, image_lines);
    if (!free) return "the images are not those of the class";
    const auto vectors = plprove::image_vectors(system, plprove::standard_constants(system), *free);
    if (std::ranges::count(vectors, plprove::Complex3{}) > 0) return "an image is zero";
    if (solution_lines.front()->front() == "fibre") {
        if (std::stoul((*solution_lines.front())[1]) != solutions) return "another number of roots";
        return objection_to_fibre(system, *free, solution_lines);
    }
    const Equations equations(system, vectors);
    std::vector<Point> found;
    for (const Words* solution : solution_lines) {
        const auto from = start(*solution);
        const auto z = from ? equations.solve(*from) : std::nullopt;
        if (!z) return "no solution near " + (*solution)[0] + " " + (*solution)[2] + " ...";
        constexpr double least = 1e-12;
        if (plprove::nondegeneracy(system, vectors, cameras(*z)) < least)
            return "a degenerate solution";
        found.push_back(*z);
        if ((*solution)[0] == "pair") found.push_back(z->conjugate());
    }
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!differ(found[i], found[j])) return "a solution that comes twice";
    if (found.size() != solutions) return "another number of solutions";
    return {};
}

} // namespace

DegreeReferee::DegreeReferee() {
    for (const File& record : committed_degrees()) {
        std::size_t& known = known_[class_of(record)];
        known = std::max(known, shown(record));
    }
}

std::optional<std::string>
DegreeReferee::objection(const std::string& text, const std::vector<checker::LowerBound>& bounds) {
    for (const auto& [number, solutions, cycle_types, block_cycles] : bounds) {
        if (known_.contains(number) && solutions > known_[number])
            return "more solutions than there are";
        // A class may have several fibres.
        std::optional<std::string> reason = "no record of the class";
        for (const File& record : records_of(text, number)) {
            const auto [place, is_new] =
                found_.try_emplace(std::to_string(solutions) + "\n" + join(record));
            if (is_new) place->second = objection_to_record(record, number, solutions);
            reason = place->second;
            if (!reason) break;
        }
        if (reason) return reason;
    }
    return {};
}

} // namespace mutation
