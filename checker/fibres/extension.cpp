#include "checker/fibres/extension.h"

#include "checker/file/complaint.h"

namespace checker {
static void trim(Polynomial& a) {
    while (!a.empty() && a.back() == Residue{})
        a.pop_back();
}

/// As below, with the quotient, if one is wanted.
static Polynomial remainder(Polynomial a, const Polynomial& b, Polynomial* quotient) {
    const Residue lead = b.back().inverse();
    if (quotient) quotient->assign(a.size() < b.size() ? 0 : a.size() - b.size() + 1, Residue{});
    for (trim(a); a.size() >= b.size(); trim(a)) {
        const Residue factor = a.back() * lead;
        const std::size_t shift = a.size() - b.size();
        for (std::size_t i = 0; i < b.size(); ++i)
            a[shift + i] = a[shift + i] - factor * b[i];
        if (quotient) (*quotient)[shift] = factor;
    }
    return a;
}

Polynomial remainder(Polynomial a, const Polynomial& b) {
    return remainder(std::move(a), b, nullptr);
}

/// The bytes of a coefficient in `packed`: they hold a sum of 2^14 products of residues, as 14 and
/// twice 61 bits are 136.
static constexpr std::size_t packed_bytes = 17;

/// The value of the polynomial at 2^136.
static mpz_class packed(const Polynomial& a) {
    std::vector<unsigned char> bytes(packed_bytes * a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 8; ++k)
            bytes[packed_bytes * i + k] = static_cast<unsigned char>(a[i].value >> (8 * k));
    mpz_class result;
    mpz_import(result.get_mpz_t(), bytes.size(), -1, 1, 0, 0, bytes.data());
    return result;
}

/// The polynomial with so many coefficients, less than 2^136, that has this value at 2^136.
static Polynomial unpacked(const mpz_class& value, std::size_t coefficients) {
    std::vector<unsigned char> bytes(packed_bytes * coefficients);
    mpz_export(bytes.data(), nullptr, -1, 1, 0, 0, value.get_mpz_t());
    Polynomial result(coefficients);
    for (std::size_t i = 0; i < coefficients; ++i) {
        std::array<std::uint64_t, 3> words{};
        for (std::size_t k = 0; k < packed_bytes; ++k)
            words[k / 8] |= std::uint64_t{bytes[packed_bytes * i + k]} << (8 * (k % 8));
        // 2^64 is 8 modulo q, and 2^128 is 64.
        result[i] = Residue::of(words[0]) + Residue::of(words[1]) * Residue{8} +
                    Residue::of(words[2]) * Residue{64};
    }
    return result;
}

/// By one product of integers, unless a factor is short.
static Polynomial product(const Polynomial& a, const Polynomial& b) {
    constexpr std::size_t is_short = 100; // term by term is as fast, as measured
    if (a.empty() || b.empty()) return {};
    const std::size_t size = a.size() + b.size() - 1;
    if (std::min(a.size(), b.size()) >= is_short) return unpacked(packed(a) * packed(b), size);
    Polynomial result(size);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size() && a[i] != Residue{}; ++j)
            result[i + j] = result[i + j] + a[i] * b[j];
    return result;
}

static Polynomial monic(Polynomial a) {
    trim(a);
    if (a.empty()) return a;
    const Residue lead = a.back().inverse();
    for (Residue& coefficient : a)
        coefficient = coefficient * lead;
    return a;
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
    for (trim(b); !b.empty(); trim(b))
        a = std::exchange(b, remainder(std::move(a), b));
    return monic(std::move(a));
}

Polynomial sum_of(Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i < b.size(); ++i)
        a[i] = a[i] + b[i];
    return a;
}

Polynomial difference_of(Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i < b.size(); ++i)
        a[i] = a[i] - b[i];
    return a;
}

bool is_zero(const Polynomial& a) {
    return std::ranges::all_of(a, [](Residue x) { return x == Residue{}; });
}

Polynomial derivative(const Polynomial& a) {
    Polynomial result;
    for (std::size_t i = 1; i < a.size(); ++i)
        result.push_back(Residue::of(i) * a[i]);
    return result;
}

Extension::Extension(Polynomial lower) : lower_(std::move(lower)) {
    // The terms s_k of the series: the sum of g_(N-i) s_(k-i) over i is 0 for k > 0.
    inverse_of_reversed_.push_back({1});
    while (inverse_of_reversed_.size() < degree()) {
        const std::size_t k = inverse_of_reversed_.size();
        Residue sum;
        for (std::size_t i = 1; i <= k; ++i)
            sum = sum + lower_[degree() - i] * inverse_of_reversed_[k - i];
        inverse_of_reversed_.push_back(-sum);
    }
}

Polynomial Extension::constant(Residue value) const {
    Polynomial result(degree());
    result[0] = value;
    return result;
}

Polynomial Extension::modulus_polynomial() const {
    Polynomial g = lower_;
    g.push_back({1});
    return g;
}

Polynomial Extension::variable() const {
    if (degree() == 1) return {-lower_[0]};
    Polynomial t = constant({});
    t[1] = {1};
    return t;
}

/// With reversed coefficients, the quotient by g is the product with the inverse power series.
Polynomial Extension::multiply(const Polynomial& a, const Polynomial& b) const {
    Polynomial full = product(a, b);
    if (full.size() > degree()) {
        const std::size_t size = full.size() - degree(); // of the quotient
        const Polynomial high(full.rbegin(), full.rbegin() + std::ptrdiff_t(size));
        const auto inverse = inverse_of_reversed_.begin();
        Polynomial quotient = product(high, Polynomial(inverse, inverse + std::ptrdiff_t(size)));
        quotient.resize(size);
        std::reverse(quotient.begin(), quotient.end());
        Polynomial multiple = product(quotient, lower_);
        multiple.resize(degree());
        full = difference_of(std::move(full), multiple);
    }
    full.resize(degree());
    return full;
}

bool Extension::is_unit(const Polynomial& a) const {
    return common_divisor(modulus_polynomial(), a).size() == 1;
}

std::optional<Polynomial> Extension::inverse(const Polynomial& a) const {
    // s_i a has the remainder r_i modulo g, down to the common divisor.
    Polynomial r0 = modulus_polynomial(), r1 = a, s0{}, s1{{1}};
    for (trim(r1); !r1.empty(); trim(r1)) {
        Polynomial quotient;
        Polynomial next = remainder(std::move(r0), r1, &quotient);
        Polynomial s = product(quotient, s1);
        s.resize(std::max(s.size(), s0.size()));
        for (std::size_t i = 0; i < s.size(); ++i)
            s[i] = (i < s0.size() ? s0[i] : Residue{}) - s[i];
        r0 = std::exchange(r1, std::move(next));
        s0 = std::exchange(s1, std::move(s));
    }
    if (r0.size() != 1) return std::nullopt;
    const Residue scale = r0[0].inverse();
    for (Residue& coefficient : s0)
        coefficient = coefficient * scale;
    s0.resize(std::max(s0.size(), degree()));
    return multiply(s0, constant({1}));
}

Polynomial minimal_polynomial(const Extension& extension, const Polynomial& x, std::size_t most) {
    const std::size_t size = extension.degree();
    std::vector<std::pair<std::size_t, Polynomial>> echelon; // its pivots, and rows
    Polynomial power = extension.constant({1});
    for (std::size_t k = 0; k <= most; ++k) {
        Polynomial row = power; // after its `size` coefficients: which powers it is the sum of
        row.resize(size + most + 1);
        row[size + k] = {1};
        for (const auto& [pivot, other] : echelon) {
            const Residue factor = row[pivot];
            for (std::size_t i = 0; i < row.size() && factor != Residue{}; ++i)
                row[i] = row[i] - factor * other[i];
        }
        const auto sums = row.begin() + std::ptrdiff_t(size);
        const auto found =
            std::find_if(row.begin(), sums, [](Residue c) { return c != Residue{}; });
        if (found == sums) return {sums, sums + std::ptrdiff_t(k)};
        const Residue scale = found->inverse();
        const auto pivot = static_cast<std::size_t>(found - row.begin());
        for (Residue& coefficient : row)
            coefficient = coefficient * scale;
        echelon.emplace_back(pivot, std::move(row));
        power = extension.multiply(power, x);
    }
    return {};
}

bool is_regular(const Extension& extension, std::vector<std::vector<Polynomial>> matrix) {
    const std::size_t size = matrix.size();
    for (std::size_t c = 0; c < size; ++c) {
        std::size_t place = c;
        std::optional<Polynomial> inverse;
        bool all_zero = true;
        for (; place < size && !inverse; ++place) {
            all_zero &= is_zero(matrix[place][c]);
            inverse = extension.inverse(matrix[place][c]);
        }
        if (!inverse && all_zero) return false;
        if (!inverse) throw Refused("the Jacobian needs a pivot that has a common factor with g");
        std::swap(matrix[c], matrix[place - 1]);
        for (std::size_t r = c + 1; r < size; ++r) {
            if (is_zero(matrix[r][c])) continue;
            const Polynomial factor = extension.multiply(matrix[r][c], *inverse);
            for (std::size_t k = c; k < size; ++k)
                matrix[r][k] = difference_of(std::move(matrix[r][k]),
                                             extension.multiply(factor, matrix[c][k]));
        }
    }
    return true;
}
} // namespace checker
