// What the proof of Theorem U17 needs computed (proofs/two_points.md): the intersection numbers of
// Proposition U18 (a), and for (b) one example modulo q = 2^61 - 1, in which the system (8) has six
// simple zeros. From the folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/two_points.cpp -lflint -lgmp -o two_points
//
// Each line of the output is a fact and its place in the proof; exit status 1 if one fails. A fact
// marked as a control is no hypothesis: it shows that the computation would notice a bad example.
#include "checker/algebra/modular.h"
#include "proofs/computations/boundary_system.h"
#include "proofs/computations/intersection_numbers.h"

#include <flint/nmod_poly.h>
#include <flint/nmod_poly_factor.h>
#include <flint/ulong_extras.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>

namespace {

using namespace proofs;

/// A polynomial modulo q of degree less than 40, from its values at 0, ..., 39.
class Polynomial {
public:
    explicit Polynomial(const std::function<Residue(Residue)>& value) {
        constexpr std::size_t count = 40;
        std::array<mp_limb_t, count> x, y;
        for (std::size_t n = 0; n < count; ++n) {
            x[n] = n;
            y[n] = value({n}).value;
        }
        nmod_poly_init(polynomial_, checker::modulus);
        nmod_poly_interpolate_nmod_vec(polynomial_, x.data(), y.data(), count);
    }
    Polynomial(const Polynomial&) = delete;
    Polynomial& operator=(const Polynomial&) = delete;
    ~Polynomial() { nmod_poly_clear(polynomial_); }

    slong degree() const { return nmod_poly_degree(polynomial_); }
    bool squarefree() const { return nmod_poly_is_squarefree(polynomial_) != 0; }
    bool coprime(const Polynomial& other) const {
        nmod_poly_t divisor;
        nmod_poly_init(divisor, checker::modulus);
        nmod_poly_gcd(divisor, polynomial_, other.polynomial_);
        const bool constant = nmod_poly_degree(divisor) == 0;
        nmod_poly_clear(divisor);
        return constant;
    }

private:
    nmod_poly_t polynomial_;
};

/// What the proof of (b) asks of an example.
struct Verdict {
    bool plane = false;  // A_1, A_2 determine sigma_2, sigma_3
    bool smooth = false; // the conic Q_2 = 0 in that plane
    bool six = false;    // K has six different zeros on the conic, so it contains no curve
    bool proper = false; // at these Q_1, the b_v and the factors w' are not 0
    bool all() const { return plane && smooth && six && proper; }
};

Verdict examine(const System& system) {
    Verdict verdict;
    verdict.plane = system.scale() != zero;
    if (!verdict.plane) return verdict;
    verdict.smooth = system.discriminant() != zero;
    const Vector3 start = system.point_of_conic();
    if (system.form(system.second, start) != zero) return verdict;
    // The other point of the conic on the line through `start` in the direction (1, z, 0).
    const auto point = [&](Residue z) {
        const Vector3 direction{one, z, zero};
        return combination(system.form(system.second, direction), start,
                           -system.polar(start, direction), direction);
    };
    const Polynomial k([&](Residue z) { return checker::determinant(system.matrix(point(z))); });
    const Polynomial excluded([&](Residue z) { return system.excluded(point(z)); });
    verdict.six = k.degree() == 6 && k.squarefree();
    verdict.proper = verdict.six && k.coprime(excluded);
    return verdict;
}

/// Prints facts, and remembers whether one failed.
class Facts {
public:
    void state(const std::string& place, const std::string& fact, bool holds) {
        std::cout << (holds ? "holds   " : "FAILS   ") << place << ": " << fact << "\n";
        all_ = all_ && holds;
    }
    bool all() const { return all_; }

private:
    bool all_ = true;
};

void state_numbers(Facts& facts) {
    const auto [pin, seen_by_two, seen_by_one] = intersection_numbers();
    const std::string number = "Proposition U18 (a), intersection number of two free lines and ";
    facts.state(number + "a pin", "672", pin == 672);
    facts.state(number + "a point that two views see", "704", seen_by_two == 704);
    facts.state(number + "a point that one view sees", "800", seen_by_one == 800);
    // What the proof subtracts; two of the zeros that are left belong to each element.
    constexpr int escaping = 8 * 12; // Proposition U18 (b)
    constexpr int centred = 8 * 6;   // all cameras have the centre Y, or all X
    constexpr int coplanar = 8 * 4;  // in the last row, with a factor 0
    const int last = seen_by_two - escaping - 2 * centred - coplanar;
    facts.state("Theorem U17, first row", "264", pin - escaping - centred == 2 * 264);
    facts.state("Theorem U17, second row", "256", seen_by_two - escaping - 2 * centred == 2 * 256);
    facts.state("Theorem U17, third row", "304", seen_by_one - escaping - 2 * centred == 2 * 304);
    facts.state("Theorem U17, last row", "240", last == 2 * 240);
}

void state_example(Facts& facts, const std::string& place, const Verdict& verdict) {
    facts.state(place, "A_1, A_2 are independent in sigma_2, sigma_3", verdict.plane);
    facts.state(place, "the conic Q_2 = 0 in the plane A_1 = A_2 = 0 is smooth", verdict.smooth);
    facts.state(place, "K = 0 meets it in six different points", verdict.six);
    facts.state(place, "Q_1, all b_v and all factors w' are not 0 there", verdict.proper);
}

void state_examples(Facts& facts) {
    Images images(11);
    const Condition line = images.free_line(), other = images.free_line();
    const Vector3 y = images.vector(), z = images.vector();
    const ImageLine y1 = images.through(1, y), y2 = images.through(1, y);
    const ImageLine z1 = images.through(2, z), z2 = images.through(2, z);
    const Condition seen_by_two{y1, y2, z1, z2};
    const ImageLine x1 = images.through(0, y), x2 = images.through(0, y);
    const Condition seen_by_one{x1, x2, images.free_line()[1], images.free_line()[2]};
    const Condition through{images.free_line()[0], images.through(1, y), images.through(2, z)};
    const std::string place = "Proposition U18 (b), ";
    facts.state(place + "modulus", "2^61 - 1 is prime", n_is_prime(checker::modulus) != 0);
    const auto state = [&](const std::string& row, const Condition& second,
                           const Condition& third) {
        state_example(facts, place + row, examine({images, line, second, third}));
    };
    state("two lines and a pin", other, images.pin());
    state("two lines and a point that two views see", other, seen_by_two);
    state("two lines and a point that one view sees", other, seen_by_one);
    state("the point is on the second line (last row of U17)", through, seen_by_two);
    const Condition degenerate{y1, y1, z1, z2};
    facts.state("control", "if both lines through an image are the same, the example is refused",
                !examine({images, line, other, degenerate}).all());
}

} // namespace

int main() {
    Facts facts;
    state_numbers(facts);
    state_examples(facts);
    std::cout << (facts.all() ? "All hold.\n" : "Some fail: Theorem U17 is not proved.\n");
    return facts.all() ? 0 : 1;
}
