// Numbers of a ring T, the integers or residues, that know how they change, to first order, when
// the unknowns do; and the numbers of a record, from which such numbers are made.
#pragma once

#include "checker/algebra/modular.h"
#include "checker/algebra/vector3.h"

#include <span>
#include <vector>

namespace checker {
/// A value, and its derivatives by the unknowns 0, 1, ...; those that are left out at the end are
/// 0.
template <class T> struct Dual {
    T value{};
    std::vector<T> change{};
};

template <class T> Dual<T> constant(T value) {
    return {std::move(value), {}};
}

/// a x + b y of derivatives x and y.
template <class T>
std::vector<T> combination(const T& a, const std::vector<T>& x, const T& b,
                           const std::vector<T>& y) {
    std::vector<T> sum(std::max(x.size(), y.size()));
    for (std::size_t i = 0; i < x.size(); ++i)
        sum[i] = a * x[i];
    for (std::size_t i = 0; i < y.size(); ++i)
        sum[i] = sum[i] + b * y[i];
    return sum;
}

template <class T> Dual<T> operator+(const Dual<T>& a, const Dual<T>& b) {
    return {a.value + b.value, combination<T>(T{1}, a.change, T{1}, b.change)};
}

template <class T> Dual<T> operator-(const Dual<T>& a, const Dual<T>& b) {
    return {a.value - b.value, combination<T>(T{1}, a.change, -T{1}, b.change)};
}

template <class T> Dual<T> operator*(const Dual<T>& a, const Dual<T>& b) {
    return {a.value * b.value, combination<T>(b.value, a.change, a.value, b.change)};
}

/// An integer of a record in the ring.
template <class T> T in_ring(int number);
template <> inline mpz_class in_ring(int number) {
    return number;
}
template <> inline Residue in_ring(int number) {
    const auto size = static_cast<std::uint64_t>(number < 0 ? -number : number);
    return number < 0 ? -Residue{size} : Residue{size};
}

/// The numbers of a record, in order. The unknowns, the columns of J, are numbered as they come. If
/// only values are asked for, no number knows how it changes.
template <class T> class Source {
public:
    explicit Source(bool only_values = false) : only_values_(only_values) {}

    void read(std::span<const int> numbers) { numbers_ = numbers; }

    Dual<T> fixed() {
        const int number = numbers_.front();
        numbers_ = numbers_.subspan(1);
        return constant<T>(in_ring<T>(number));
    }

    Dual<T> unknown() { return varied(fixed().value); }

    /// The next unknown, with this value.
    Dual<T> varied(T value) {
        if (only_values_) return constant(std::move(value));
        Dual<T> result{std::move(value), std::vector<T>(unknowns_ + 1)};
        result.change[unknowns_++] = T{1};
        return result;
    }

    std::size_t unknowns() const { return unknowns_; }

private:
    bool only_values_;
    std::span<const int> numbers_{};
    std::size_t unknowns_ = 0;
};
} // namespace checker
