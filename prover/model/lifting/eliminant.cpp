#include "prover/model/lifting/eliminant.h"

#include "prover/geometry/flint.h"
#include "prover/model/fields.h"

#include <algorithm>
#include <cmath>
#include <flint/fmpq.h>
#include <flint/fmpz_lll.h>

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

/// The product of t - u over some solutions; and for each of some coordinates x the sum of x times
/// the product of the others.
struct Part {
    RealPolynomial product;
    std::vector<RealPolynomial> sums;
};

constexpr slong every = WORD_MAX;

class Parts {
public:
    /// With so many first coefficients of each polynomial, and sums of these coordinates.
    Parts(const std::vector<RefinedSolution>& solutions, const std::vector<int>& factors,
          std::vector<std::size_t> sums, slong coefficients, slong bits)
        : solutions_(solutions), factors_(factors), sums_(std::move(sums)),
          coefficients_(coefficients), bits_(bits) {}

    Part all() const { return of(0, solutions_.size()); }

private:
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

    RealPolynomial product(const RealPolynomial& a, const RealPolynomial& b) const {
        RealPolynomial result;
        arb_poly_mullow(result.get(), a.get(), b.get(), coefficients_, bits_);
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
        const auto coordinate = [&](std::size_t k) {
            return with_error(solution.coordinates[k], solution.real);
        };
        BigComplex u;
        for (std::size_t k = 0; k < factors_.size(); ++k)
            if (factors_[k] != 0) acb_addmul_si(u.get(), coordinate(k).get(), factors_[k], bits_);
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
        for (const std::size_t k : sums_) {
            RealPolynomial& sum = part.sums.emplace_back();
            const BigComplex x = coordinate(k);
            arb_srcptr re = acb_realref(x.get()), im = acb_imagref(x.get());
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
    std::vector<std::size_t> sums_;
    slong coefficients_;
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

/// Polynomials whose coefficients are rational numbers, modulo q.
class Reduction {
public:
    /// Finds the denominators that do not divide this one, too.
    Reduction(slong bits, Integer denominator) : bits_(bits), common_(std::move(denominator)) {}

    /// Nothing where so many bits do not determine the coefficients.
    std::optional<Univariate> modulo_q(const RealPolynomial& polynomial) {
        const slong length = arb_poly_length(polynomial.get());
        std::vector<Modular> coefficients;
        arb_t x;
        arb_init(x);
        bool known = true;
        for (slong i = 0; i < length && known; ++i) {
            arb_poly_get_coeff_arb(x, polynomial.get(), i);
            known = read(x) && fmpz_fdiv_ui(common_.get(), modulus) != 0;
            if (known) coefficients.push_back(residue(numerator_) * residue(common_).inverse());
        }
        arb_clear(x);
        if (!known) return std::nullopt;
        return Univariate(coefficients);
    }

private:
    static Modular residue(const Integer& x) { return Modular::of(fmpz_fdiv_ui(x.get(), modulus)); }

    /// The number, if it is determined, is `numerator_` over `common_`.
    bool read(arb_t x) {
        constexpr slong near = -40; // an integer, surely, with an error below this power of two
        arb_mul_fmpz(x, x, common_.get(), bits_);
        const bool exact = arb_is_exact(x) || MAG_EXP(arb_radref(x)) < near;
        if (exact && arb_get_unique_fmpz(numerator_.get(), x)) return true;
        Rational rational;
        if (arb_is_exact(x) || !simplest_in(rational, x)) return false;
        fmpz_mul(common_.get(), common_.get(), rational.denominator());
        fmpz_set(numerator_.get(), fmpq_numref(rational.get()));
        return true;
    }

    slong bits_;
    Integer common_, numerator_;
};

/// The least common denominator of some rational numbers, from intervals; nothing where it is no
/// surprise that these have one, so that it may be another one.
///
/// It makes a short vector of a lattice (Lenstra, Lenstra and Lovász 1982, section 1): n numbers
/// that are no integers determine it by 1 + 1/n times as many bits as it has.
std::optional<Integer> common_denominator(arb_srcptr begin, arb_srcptr end) {
    constexpr slong surprise = 64;
    std::vector<arb_srcptr> numbers;
    slong bits = WORD_MAX; // that all numbers have after the binary point
    for (arb_srcptr x = begin; x != end; ++x) {
        if (arb_is_exact(x)) continue;
        const slong own = -fmpz_get_si(MAG_EXPREF(arb_radref(x)));
        if (own < surprise) return std::nullopt;
        if (arb_contains_int(x)) continue;
        bits = std::min(bits, own);
        numbers.push_back(x);
    }
    Integer result;
    fmpz_one(result.get());
    if (numbers.empty()) return result;
    const auto count = static_cast<slong>(numbers.size());
    IntegerMatrix lattice(static_cast<int>(count + 1), static_cast<int>(count + 1));
    fmpz_one(lattice.at(0, static_cast<int>(count)));
    for (int n = 0; n < count; ++n) {
        arf_t scaled;
        arf_init(scaled);
        arf_mul_2exp_si(scaled, arb_midref(numbers[static_cast<std::size_t>(n)]), bits);
        arf_get_fmpz(lattice.at(0, n), scaled, ARF_RND_NEAR);
        arf_clear(scaled);
        fmpz_one_2exp(lattice.at(n + 1, n), static_cast<ulong>(bits));
    }
    fmpz_lll_t context;
    fmpz_lll_context_init_default(context);
    fmpz_lll(lattice.get(), nullptr, context);
    fmpz_abs(result.get(), lattice.at(0, static_cast<int>(count)));
    const auto size = static_cast<slong>(fmpz_bits(result.get()));
    if (size == 0 || (count + 1) * size + surprise > count * bits) return std::nullopt;
    return result;
}

/// All coordinates but the one that is t itself, if one is.
std::vector<std::size_t> coordinates_beside(const std::vector<int>& factors) {
    std::vector<std::size_t> result;
    const bool one_alone = std::ranges::count(factors, 0) + 1 == std::ssize(factors);
    for (std::size_t k = 0; k < factors.size(); ++k)
        if (!one_alone || factors[k] != 1) result.push_back(k);
    return result;
}

/// The factors of a sum that is this coordinate.
std::vector<int> alone(std::size_t coordinate, std::size_t of) {
    std::vector<int> result(of);
    result[coordinate] = 1;
    return result;
}

/// No coefficient of the product of t - u over all solutions has more bits before the binary point;
/// nor, but for few, one of a sum of products without a factor.
slong bits_before_point(const std::vector<int>& factors,
                        const std::vector<RefinedSolution>& solutions) {
    constexpr slong few = 64;
    double result = 0;
    for (const RefinedSolution& solution : solutions) {
        BigComplex u;
        for (std::size_t k = 0; k < factors.size(); ++k)
            acb_addmul_si(u.get(), solution.coordinates[k].get(), factors[k], few);
        const double size = std::hypot(arf_get_d(arb_midref(acb_realref(u.get())), ARF_RND_NEAR),
                                       arf_get_d(arb_midref(acb_imagref(u.get())), ARF_RND_NEAR));
        result += (solution.real ? 1 : 2) * std::log2(1 + size);
    }
    return static_cast<slong>(result);
}

} // namespace

/// Whether it is known.
bool Eliminants::find_denominator(const std::vector<int>& factors) {
    constexpr slong first = 6; // coefficients: more cost more, and say little more
    const auto [entry, is_new] = denominators_.try_emplace(factors);
    if (is_new) {
        const slong bits = refinement_.bits();
        const Part part = Parts(refinement_.solutions(), factors, {}, first, bits).all();
        arb_srcptr coefficients = part.product.get()->coeffs;
        entry->second = common_denominator(
            coefficients, coefficients + std::min(first, arb_poly_length(part.product.get())));
    }
    return entry->second.has_value();
}

/// Of the sum of a coordinate: it may have, beside the denominators of u, those of the coordinate.
Integer Eliminants::denominator_of_sum(const std::vector<int>& factors,
                                       std::size_t coordinate) const {
    Integer result;
    fmpz_lcm(result.get(), denominators_.at(factors)->get(),
             denominators_.at(alone(coordinate, factors.size()))->get());
    return result;
}

std::optional<slong> Eliminants::bits_for(const std::vector<int>& factors) {
    constexpr slong spare = 512; // errors add up, and further coefficients may have more factors
    const std::vector<std::size_t> others = coordinates_beside(factors);
    for (const std::size_t k : others)
        if (!find_denominator(alone(k, factors.size()))) return std::nullopt;
    if (!find_denominator(factors)) return std::nullopt;
    ulong largest = fmpz_bits(denominators_.at(factors)->get());
    for (const std::size_t k : others)
        largest = std::max(largest, fmpz_bits(denominator_of_sum(factors, k).get()));
    return static_cast<slong>(largest) + bits_before_point(factors, refinement_.solutions()) +
           spare;
}

std::optional<Solutions> Eliminants::of(const std::vector<int>& factors) const {
    const slong bits = refinement_.bits();
    const std::vector<std::size_t> others = coordinates_beside(factors);
    const Part part = Parts(refinement_.solutions(), factors, others, every, bits).all();
    Integer denominator;
    fmpz_set(denominator.get(), denominators_.at(factors)->get());
    const auto g = Reduction(bits, std::move(denominator)).modulo_q(part.product);
    if (!g || nmod_poly_is_squarefree(g->get()) == 0) return std::nullopt;
    const Algebra algebra(*g);
    Univariate slope;
    nmod_poly_derivative(slope.get(), g->get());
    const Univariate inverse = algebra.inverse(slope);
    const Univariate t = algebra.reduced(Univariate({Modular(0), Modular(1)}));
    Solutions result{*g, std::vector<Univariate>(factors.size(), t)};
    for (std::size_t n = 0; n < others.size(); ++n) {
        const auto numerator =
            Reduction(bits, denominator_of_sum(factors, others[n])).modulo_q(part.sums[n]);
        if (!numerator) return std::nullopt;
        result.unknowns[others[n]] = algebra.product(*numerator, inverse);
    }
    return result;
}

std::optional<ExactSolutions> exact_solutions(Refinement refinement,
                                              const std::vector<std::vector<int>>& forms,
                                              slong most_bits,
                                              const std::function<void(long)>& progress) {
    while (refinement.bits() < most_bits) {
        refinement.add_digits();
        if (progress) progress(refinement.bits());
        Eliminants eliminants(refinement);
        for (const std::vector<int>& form : forms) {
            const std::optional<slong> bits = eliminants.bits_for(form);
            if (!bits) continue;
            refinement.add_digits_up_to(*bits);
            if (auto solutions = eliminants.of(form))
                return ExactSolutions{form, std::move(*solutions)};
        }
    }
    return std::nullopt;
}

} // namespace plprove::model
