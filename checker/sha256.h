// The digest SHA-256 (FIPS 180-4) of bytes, in hexadecimal.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace checker {
using Sha256State = std::array<std::uint32_t, 8>;

/// The constants of the standard.
struct Sha256Constants {
    Sha256State start{};
    std::array<std::uint32_t, 64> rounds{};
};

/// The first 32 bits of the fractional part of a root of a prime; doubles are exact enough.
inline std::uint32_t root_bits(double root) {
    return static_cast<std::uint32_t>((root - std::floor(root)) * 4294967296.0);
}

inline Sha256Constants sha256_constants() {
    Sha256Constants constants;
    for (unsigned n = 2, found = 0; found < constants.rounds.size(); ++n) {
        unsigned divisor = 2;
        while (n % divisor != 0)
            ++divisor;
        if (divisor < n) continue; // not a prime
        if (found < constants.start.size()) constants.start[found] = root_bits(std::sqrt(n));
        constants.rounds[found++] = root_bits(std::cbrt(n));
    }
    return constants;
}

/// The message schedule of a block of 64 bytes.
inline std::array<std::uint32_t, 64> sha256_schedule(std::string_view block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
        w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
    for (std::size_t t = 16; t < 64; ++t) {
        const std::uint32_t x = w[t - 15];
        const std::uint32_t y = w[t - 2];
        const std::uint32_t small_0 = std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3;
        const std::uint32_t small_1 = std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10;
        w[t] = w[t - 16] + small_0 + w[t - 7] + small_1;
    }
    return w;
}

/// The state after a block of 64 bytes.
inline Sha256State after_block(const Sha256State& state, std::string_view block,
                               const Sha256Constants& constants) {
    const std::array<std::uint32_t, 64> w = sha256_schedule(block);
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
        const std::uint32_t large_1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t choice = (e & f) ^ (~e & g);
        const std::uint32_t first = h + large_1 + choice + constants.rounds[t] + w[t];
        const std::uint32_t large_0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t majority = (a & b) ^ (a & c) ^ (b & c);
        h = g;
        g = f;
        f = e;
        e = d + first;
        d = c;
        c = b;
        b = a;
        a = first + large_0 + majority;
    }
    const Sha256State round{a, b, c, d, e, f, g, h};
    Sha256State sum;
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = state[i] + round[i];
    return sum;
}

inline std::string sha256(std::string_view bytes) {
    const Sha256Constants constants = sha256_constants();
    Sha256State state = constants.start;
    const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (; bytes.size() >= 64; bytes.remove_prefix(64))
        state = after_block(state, bytes.substr(0, 64), constants);
    std::string end(bytes); // padded to one or two blocks
    end += '\x80';
    while (end.size() % 64 != 56)
        end += '\0';
    for (int shift = 56; shift >= 0; shift -= 8)
        end += static_cast<char>(bits >> shift & 0xff);
    for (std::size_t place = 0; place < end.size(); place += 64)
        state = after_block(state, std::string_view(end).substr(place, 64), constants);
    std::string text;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            text += "0123456789abcdef"[word >> shift & 15];
    return text;
}
} // namespace checker
