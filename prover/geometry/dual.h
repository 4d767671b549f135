// Numbers that move: a value and its derivative, over any ring.
#pragma once

namespace plprove {

template <class T>
struct Dual {
    T value{};
    T slope{};

    static Dual constant(int value) { return {T(value), T{}}; }

    friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.value + b.value, a.slope + b.slope};
    }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.value - b.value, a.slope - b.slope};
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.value * b.value, a.value * b.slope + a.slope * b.value};
    }
};

} // namespace plprove
