#include "prover/model/random_residues.h"

#include "prover/system/sha256.h"

namespace plprove::model {

namespace {

std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

} // namespace

RandomResidues::RandomResidues(const Model& model, std::uint64_t stream) {
    constexpr std::size_t digits = 16; // of 64 bits
    std::string text;
    for (const std::string& line : model.lines)
        text += line + '\n';
    state_ = mix(std::stoull(sha256(text).substr(0, digits), nullptr, 16) + mix(stream + 1));
}

std::uint64_t RandomResidues::bits() {
    return mix(state_ += 0x9e3779b97f4a7c15U);
}

Modular RandomResidues::residue() {
    while (true) {
        const std::uint64_t value = bits() & modulus;
        if (value < modulus) return Modular::of(value);
    }
}

std::vector<Modular> RandomResidues::residues(std::size_t count) {
    std::vector<Modular> result(count);
    for (Modular& value : result)
        value = residue();
    return result;
}

int RandomResidues::integer(int bound) {
    return static_cast<int>(bits() % (2 * static_cast<std::uint64_t>(bound) + 1)) - bound;
}

} // namespace plprove::model
