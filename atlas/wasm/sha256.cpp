// The prover's digests where there is no OpenSSL: browsers have some, but for those one has to
// wait. A test compares what is drawn by them with what plprove draws.
#include "prover/system/sha256.h"

#include <array>
#include <bit>
#include <cstdint>

namespace plprove {

namespace {

using Words = std::array<std::uint32_t, 8>;

/// The first 32 bits of the fractional parts of the square roots of the first 8 primes,
constexpr Words start{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

/// and of the cube roots of the first 64.
constexpr std::array<std::uint32_t, 64> constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

/// Mixes a block of 64 bytes in.
void mix(Words& state, const std::string& text, std::size_t place) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
        w[i / 4] = w[i / 4] << 8U | static_cast<unsigned char>(text[place + i]);
    for (std::size_t i = 16; i < w.size(); ++i) {
        const std::uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + w[i - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3U) +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10U);
    }
    Words v = state;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const std::uint32_t a = v[0], e = v[4];
        const std::uint32_t first = v[7] + constants[i] + w[i] + ((e & v[5]) ^ (~e & v[6])) +
                                    (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25));
        const std::uint32_t second = ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2])) +
                                     (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22));
        v = {first + second, a, v[1], v[2], v[3] + first, e, v[5], v[6]};
    }
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += v[i];
}

} // namespace

std::string sha256(const std::string& content) {
    constexpr std::size_t block = 64, length = 8; // bytes
    std::string text = content + '\x80';
    text.resize((text.size() + length + block - 1) / block * block, '\0');
    std::uint64_t bits = std::uint64_t{content.size()} * 8;
    for (std::size_t i = 1; i <= length; ++i, bits >>= 8U)
        text[text.size() - i] = static_cast<char>(bits & 0xffU);
    Words state = start;
    for (std::size_t place = 0; place < text.size(); place += block)
        mix(state, text, place);
    std::string digest;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            digest += "0123456789abcdef"[word >> static_cast<unsigned>(shift) & 15U];
    return digest;
}

} // namespace plprove
