#include "prover/model/lifting/eliminant.h"

#include "prover/geometry/flint.h"
#include "prover/model/fields.h"

#include <flint/fmpq.h>

namespace plprove::model {

namespace {

class RealPolynomial {
public:
    RealPolynomial() { arb_poly_init(value_); }
    RealPolynomial(const RealPolynomial& other) : RealPolynomial() {
        arb_poly_set(value_, other.value_);
    }
    RealPolynomial(RealPolynomial&& other) noexcept : RealPolynomial() {
        arb_poly_swap(value_, other.value_);
    }
    RealPolynomial& operator=(RealPolynomial other) noexcept {
        arb_poly_swap(value_, other.value_);
        return *this;
    }
    ~RealPolynomial() { arb_poly_clear(value_); }

    arb_poly_struct* get() { return value_; }
    const arb_poly_struct* get() const { return value_; }
    void set(slong power, const arb_t x) { arb_poly_set_coeff_arb(value_, power, x); }

private:
    arb_poly_t value_;
};

/// The product of t - u over some solutions; and for each coordinate x the sum of x times the
/// product of the others.
struct Part {
    RealPolynomial product;
    std::vector<RealPolynomial> sums;
};

class Parts {
public:
    Parts(const std::vector<RefinedSolution>& solutions, const std::vector<int>& factors,
          slong bits)
        : solutions_(solutions), factors_(factors), bits_(bits) {}

    Part of(std::size_t first, std::size_t last) const {
        if (last - first == 1) return leaf(solutions_[first]);
        const std::size_t middle = (first + last) / 2;
        const Part a = of(first, middle), b = of(middle, last);
        Part result{product(a.product, b.product), {}};
        for (std::size_t k = 0; k < a.sums.size(); ++k) {
            result.sums.push_back(product(a.sums[k], b.product));
            arb_poly_add(result.sums[k].get(), result.sums[k].get(),
                         product(b.sums[k], a.product).get(), bits_);
        }
        return result;
    }

private:
    RealPolynomial product(const RealPolynomial& a, const RealPolynomial& b) const {
        RealPolynomial result;
        arb_poly_mul(result.get(), a.get(), b.get(), bits_);
        return result;
    }

    /// A coordinate with the error that Newton's method may have left.
    BigComplex with_error(const BigComplex& x, bool real) const {
        BigComplex result = x;
        arb_add_error_2exp_si(acb_realref(result.get()), -bits_ + uncertain_bits);
        if (!real) arb_add_error_2exp_si(acb_imagref(result.get()), -bits_ + uncertain_bits);
        return result;
    }

    Part leaf(const RefinedSolution& solution) const {
        std::vector<BigComplex> x;
        BigComplex u;
        for (std::size_t k = 0; k < factors_.size(); ++k) {
            x.push_back(with_error(solution.coordinates[k], solution.real));
            acb_addmul_si(u.get(), x.back().get(), factors_[k], bits_);
        }
        arb_t number;
        arb_init(number);
        Part part;
        // t - u; or (t - u) times its conjugate, and x (t - conj(u)) plus its conjugate.
        arb_one(number);
        part.product.set(solution.real ? 1 : 2, number);
        if (solution.real) {
            arb_neg(number, acb_realref(u.get()));
            part.product.set(0, number);
        } else {
            arb_mul_si(number, acb_realref(u.get()), -2, bits_);
            part.product.set(1, number);
            arb_sqr(number, acb_realref(u.get()), bits_);
            arb_addmul(number, acb_imagref(u.get()), acb_imagref(u.get()), bits_);
            part.product.set(0, number);
        }
        for (const BigComplex& coordinate : x) {
            RealPolynomial& sum = part.sums.emplace_back();
            arb_srcptr re = acb_realref(coordinate.get()), im = acb_imagref(coordinate.get());
            if (solution.real) {
                sum.set(0, re);
                continue;
            }
            arb_mul_2exp_si(number, re, 1);
            sum.set(1, number);
            arb_mul(number, re, acb_realref(u.get()), bits_);
            arb_addmul(number, im, acb_imagref(u.get()), bits_);
            arb_mul_si(number, number, -2, bits_);
            sum.set(0, number);
        }
        arb_clear(number);
        return part;
    }

    static constexpr slong uncertain_bits = 128;

    const std::vector<RefinedSolution>& solutions_;
    const std::vector<int>& factors_;
    slong bits_;
};

class Rational {
public:
    Rational() { fmpq_init(value_); }
    Rational(const Rational&) = delete;
    Rational& operator=(const Rational&) = delete;
    ~Rational() { fmpq_clear(value_); }

    fmpq* get() { return value_; }
    fmpz* denominator() { return fmpq_denref(value_); }

private:
    fmpq_t value_;
};

/// The simplest rational number in an interval; false if that is no surprise, so that it may be
/// another one.
bool simplest_in(Rational& result, const arb_t interval) {
    constexpr slong surprise = 64;
    Integer low, high, exponent;
    Rational from, to;
    arb_get_interval_fmpz_2exp(low.get(), high.get(), exponent.get(), interval);
    fmpq_set_fmpz(from.get(), low.get());
    fmpq_set_fmpz(to.get(), high.get());
    const slong shift = fmpz_get_si(exponent.get());
    for (Rational* end : {&from, &to})
        if (shift < 0)
            fmpq_div_2exp(end->get(), end->get(), static_cast<ulong>(-shift));
        else
            fmpq_mul_2exp(end->get(), end->get(), static_cast<ulong>(shift));
    fmpq_simplest_between(result.get(), from.get(), to.get());
    return 2 * static_cast<slong>(fmpz_bits(result.denominator())) + surprise <
           -fmpz_get_si(MAG_EXPREF(arb_radref(interval)));
}

/// The polynomial modulo q, whose coefficients are rational numbers.
std::optional<Univariate> modulo_q(const RealPolynomial& polynomial, slong bits) {
    constexpr slong near = -40; // an integer, surely, with an error below this power of two
    const slong length = arb_poly_length(polynomial.get());
    Integer common, integer;
    Rational rational;
    fmpz_one(common.get());
    arb_t x;
    arb_init(x);
    std::vector<Modular> coefficients(static_cast<std::size_t>(length));
    std::vector<ulong> residues(coefficients.size()), denominators(coefficients.size());
    bool known = true;
    for (slong i = 0; i < length && known; ++i) {
        arb_poly_get_coeff_arb(x, polynomial.get(), i);
        arb_mul_fmpz(x, x, common.get(), bits);
        const bool exact = arb_is_exact(x) || MAG_EXP(arb_radref(x)) < near;
        if (!exact || !arb_get_unique_fmpz(integer.get(), x)) {
            known = !arb_is_exact(x) && simplest_in(rational, x);
            fmpz_mul(common.get(), common.get(), rational.denominator());
            fmpz_set(integer.get(), fmpq_numref(rational.get()));
        }
        residues[static_cast<std::size_t>(i)] = fmpz_fdiv_ui(integer.get(), modulus);
        denominators[static_cast<std::size_t>(i)] = fmpz_fdiv_ui(common.get(), modulus);
        known = known && denominators[static_cast<std::size_t>(i)] != 0;
    }
    arb_clear(x);
    if (!known) return std::nullopt;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        coefficients[i] = Modular::of(residues[i]) * Modular::of(denominators[i]).inverse();
    return Univariate(coefficients);
}

/// Whether so many bits seem to determine the coefficients: they do for the constant one of g.
bool suffice(const std::vector<RefinedSolution>& solutions, const Parts& parts, slong bits) {
    RealPolynomial product;
    arb_poly_one(product.get());
    for (std::size_t n = 0; n < solutions.size(); ++n)
        arb_poly_mullow(product.get(), product.get(), parts.of(n, n + 1).product.get(), 1, bits);
    return modulo_q(product, bits).has_value();
}

} // namespace

std::optional<Solutions> eliminant(const std::vector<RefinedSolution>& solutions,
                                   const std::vector<int>& factors, slong bits) {
    const Parts parts(solutions, factors, bits);
    if (!suffice(solutions, parts, bits)) return std::nullopt;
    const Part part = parts.of(0, solutions.size());
    auto g = modulo_q(part.product, bits);
    if (!g) return std::nullopt;
    if (nmod_poly_is_squarefree(g->get()) == 0) return std::nullopt;
    const Algebra algebra(*g);
    Univariate slope;
    nmod_poly_derivative(slope.get(), g->get());
    const Univariate inverse = algebra.inverse(slope);
    Solutions result{*g, {}};
    for (const RealPolynomial& sum : part.sums) {
        const auto numerator = modulo_q(sum, bits);
        if (!numerator) return std::nullopt;
        result.unknowns.push_back(algebra.product(*numerator, inverse));
    }
    return result;
}

} // namespace plprove::model
