#include "checker/fibres/fibre.h"

#include "checker/algebra/dual.h"

namespace checker {
std::vector<Residue> read_residue_line(Reader& reader, std::string_view word, std::size_t count) {
    reader.take(word);
    std::vector<Residue> residues;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = reader.integer(0, static_cast<std::int64_t>(modulus) - 1);
        residues.push_back({static_cast<std::uint64_t>(value)});
    }
    reader.end_line();
    return residues;
}

Numbers read_numbers(Reader& reader, std::size_t count) {
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(reader.small_integer(-999'999, 999'999));
    return numbers;
}

std::size_t read_fibre_degree(Reader& reader) {
    reader.take("fibre");
    const auto degree = static_cast<std::size_t>(reader.integer(1, 10'000));
    reader.end_line();
    return degree;
}

Fibre read_fibre(Reader& reader, std::size_t degree, std::size_t unknowns, std::size_t separating) {
    Fibre fibre;
    fibre.lower = read_residue_line(reader, "polynomial", degree);
    for (std::size_t i = 0; i < unknowns; ++i)
        fibre.unknowns.push_back(read_residue_line(reader, "unknown", degree));
    reader.take("separated by");
    fibre.separated_by = read_numbers(reader, separating);
    reader.end_line();
    return fibre;
}

Polynomial combination_of(const Extension& extension, const Numbers& numbers,
                          const std::vector<Polynomial>& values) {
    Polynomial sum = extension.constant({});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        sum =
            sum_of(std::move(sum),
                   extension.multiply(extension.constant(in_ring<Residue>(numbers[i])), values[i]));
    return sum;
}

void require_separate_solutions(const Extension& extension, const Fibre& fibre) {
    const Polynomial g = extension.modulus_polynomial();
    if (common_divisor(g, derivative(g)).size() != 1)
        throw Refused("the polynomial has a multiple root");
    if (combination_of(extension, fibre.separated_by, fibre.unknowns) != extension.variable())
        throw Refused("the sum of `separated by` is not t");
}
} // namespace checker
