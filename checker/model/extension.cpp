#include "checker/model/extension.h"

namespace checker {
static void trim(Polynomial& a) {
    while (!a.empty() && a.back() == Residue{})
        a.pop_back();
}

/// The remainder of a by b, which is trimmed and not 0; and the quotient, if one is wanted.
static Polynomial remainder(Polynomial a, const Polynomial& b, Polynomial* quotient = nullptr) {
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

static Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1);
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

Polynomial Extension::multiply(const Polynomial& a, const Polynomial& b) const {
    Polynomial full = product(a, b);
    for (std::size_t top = full.size(); top-- > degree();) {
        const Residue factor = full[top];
        if (factor == Residue{}) continue;
        for (std::size_t i = 0; i < degree(); ++i)
            full[top - degree() + i] = full[top - degree() + i] - factor * lower_[i];
    }
    full.resize(degree());
    return full;
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

DualExtension::Element DualExtension::unknown(Polynomial value, std::size_t number) const {
    Element result{std::move(value), {}};
    result.change.resize(number + 1, extension_.constant({}));
    result.change.back() = extension_.constant({1});
    return result;
}

DualExtension::Element DualExtension::add(const Element& a, const Element& b) const {
    Element sum{sum_of(a.value, b.value), a.change};
    sum.change.resize(std::max(a.change.size(), b.change.size()), extension_.constant({}));
    for (std::size_t i = 0; i < b.change.size(); ++i)
        sum.change[i] = sum_of(std::move(sum.change[i]), b.change[i]);
    return sum;
}

DualExtension::Element DualExtension::multiply(const Element& a, const Element& b) const {
    Element result{extension_.multiply(a.value, b.value), {}};
    result.change.resize(std::max(a.change.size(), b.change.size()), extension_.constant({}));
    for (std::size_t i = 0; i < a.change.size(); ++i)
        result.change[i] = extension_.multiply(a.change[i], b.value);
    for (std::size_t i = 0; i < b.change.size(); ++i)
        result.change[i] =
            sum_of(std::move(result.change[i]), extension_.multiply(a.value, b.change[i]));
    return result;
}

DualExtension::Element DualExtension::inverse(const Element& a) const {
    if (a.value[0] == Residue{}) throw Refused("the model divides by the constant 0");
    return {extension_.constant(a.value[0].inverse()), {}};
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
