// The digest SHA-256 (FIPS 180-4) of bytes, in hexadecimal.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace checker {
/// The first 32 bits of the fractional part of a root of a prime; doubles are exact enough.
inline std::uint32_t root_bits(double root) {
    return static_cast<std::uint32_t>((root - std::floor(root)) * 4294967296.0);
}

inline std::string sha256(std::string_view bytes) {
    std::array<std::uint32_t, 8> hash{};
    std::array<std::uint32_t, 64> k{}, w{};
    for (unsigned n = 2, found = 0; found < 64; ++n) {
        unsigned divisor = 2;
        while (n % divisor != 0) ++divisor;
        if (divisor < n) continue;
        if (found < 8) hash[found] = root_bits(std::sqrt(n));
        k[found++] = root_bits(std::cbrt(n));
    }
    // Whole blocks are read in place; the padded end is one or two more.
    const std::size_t whole = bytes.size() / 64 * 64;
    std::string end(bytes.substr(whole));
    end += '\x80';
    end.append((120 - end.size()) % 64, '\0');
    for (int shift = 56; shift >= 0; shift -= 8)
        end += static_cast<char>(std::uint64_t{bytes.size()} * 8 >> shift);
    for (std::size_t start = 0; start < whole + end.size(); start += 64) {
        const char* block = start < whole ? &bytes[start] : &end[start - whole];
        for (std::size_t t = 0; t < 16; ++t, block += 4)
            for (int i = 0; i < 4; ++i) w[t] = w[t] << 8 | static_cast<unsigned char>(block[i]);
        for (std::size_t t = 16; t < 64; ++t) {
            const std::uint32_t x = w[t - 15], y = w[t - 2];
            w[t] = w[t - 16] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) + w[t - 7] +
                   (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
        }
        auto [a, b, c, d, e, f, g, h] = hash;
        for (std::size_t t = 0; t < 64; ++t) {
            const std::uint32_t first = h +
                                        (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                        ((e & f) ^ (~e & g)) + k[t] + w[t];
            const std::uint32_t second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) +
                                         ((a & b) ^ (a & c) ^ (b & c));
            h = g, g = f, f = e, e = d + first;
            d = c, c = b, b = a, a = first + second;
        }
        const std::array round{a, b, c, d, e, f, g, h};
        for (std::size_t i = 0; i < 8; ++i) hash[i] += round[i];
    }
    std::string text;
    for (const std::uint32_t word : hash)
        for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 15];
    return text;
}
} // namespace checker
