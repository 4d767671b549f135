#include "prover/model/monomial.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace plprove::model {

int Monomial::degree() const {
    return std::accumulate(exponents.begin(), exponents.end(), 0);
}

bool Monomial::divides(const Monomial& other) const {
    for (std::size_t i = 0; i < most_variables; ++i)
        if (exponents[i] > other.exponents[i]) return false;
    return true;
}

Monomial operator*(const Monomial& a, const Monomial& b) {
    Monomial result;
    unsigned int overflow = 0;
    for (std::size_t i = 0; i < most_variables; ++i) {
        const unsigned int sum = unsigned{a.exponents[i]} + b.exponents[i];
        overflow |= sum >> 8U;
        result.exponents[i] = static_cast<std::uint8_t>(sum);
    }
    if (overflow != 0) throw TooLarge("a polynomial has a degree of more than 255");
    return result;
}

Monomial operator/(const Monomial& a, const Monomial& b) {
    Monomial result;
    for (std::size_t i = 0; i < most_variables; ++i)
        result.exponents[i] = static_cast<std::uint8_t>(a.exponents[i] - b.exponents[i]);
    return result;
}

Monomial variable_monomial(std::size_t variable) {
    if (variable >= most_variables)
        throw TooLarge("there are more than " + std::to_string(most_variables) + " unknowns");
    Monomial result;
    result.exponents[variable] = 1;
    return result;
}

Monomial least_common_multiple(const Monomial& a, const Monomial& b) {
    Monomial result;
    for (std::size_t i = 0; i < most_variables; ++i)
        result.exponents[i] = std::max(a.exponents[i], b.exponents[i]);
    return result;
}

bool grevlex_less(const Monomial& a, const Monomial& b) {
    const int difference = a.degree() - b.degree();
    if (difference != 0) return difference < 0;
    for (std::size_t i = most_variables; i-- > 0;)
        if (a.exponents[i] != b.exponents[i]) return a.exponents[i] > b.exponents[i];
    return false;
}

std::size_t HashOfMonomial::operator()(const Monomial& monomial) const {
    std::array<std::uint64_t, most_variables / 8> words;
    std::memcpy(words.data(), monomial.exponents.data(), most_variables);
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

} // namespace plprove::model
