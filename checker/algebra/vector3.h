// Vectors of three numbers, over any ring.
#pragma once

#include <gmpxx.h>

#include <array>

namespace checker {
template <class T> using Vector3 = std::array<T, 3>;
using IntegerVector = Vector3<mpz_class>;

template <class T> T dot(const Vector3<T>& a, const Vector3<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T> Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T> Vector3<T> times(const T& s, const Vector3<T>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

template <class T> Vector3<T> plus(const Vector3<T>& a, const Vector3<T>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class T> Vector3<T> minus(const Vector3<T>& a, const Vector3<T>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
} // namespace checker
