#include "checker/fibres/frobenius.h"

#include "checker/file/complaint.h"

#include <algorithm>
#include <numeric>

namespace checker {
bool is_prime(std::size_t n) {
    for (std::size_t d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n > 1;
}

std::size_t points_of(const CycleType& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), std::size_t{0});
}

bool is_even(const CycleType& lengths) {
    return (points_of(lengths) - lengths.size()) % 2 == 0;
}

bool has_prime_cycle(const CycleType& lengths, std::size_t least, std::size_t most) {
    return std::ranges::any_of(lengths, [&](std::size_t p) {
        const auto is_multiple = [&](std::size_t length) { return length % p == 0; };
        return least <= p && p <= most && is_prime(p) &&
               std::ranges::count_if(lengths, is_multiple) == 1;
    });
}

/// t^q modulo g.
static Polynomial frobenius_of_variable(const Extension& extension) {
    Polynomial product = extension.constant({1});
    for (int bit = 60; bit >= 0; --bit) {
        product = extension.multiply(product, product);
        if ((modulus >> bit) & 1) product = extension.multiply(product, extension.variable());
    }
    return product;
}

// The divisor of g and t^(q^n) - t is the product of the factors whose degree divides n. What is
// left when no two factors of degree n or more have room is one factor.
CycleType cycle_type_of(const Polynomial& lower) {
    const Extension extension(lower);
    const Polynomial t = extension.variable(), g = extension.modulus_polynomial();
    std::vector<Polynomial> images{extension.constant({1})}; // (t^k)^q
    const Polynomial image = frobenius_of_variable(extension);
    while (images.size() < extension.degree())
        images.push_back(extension.multiply(images.back(), image));
    CycleType lengths;
    Polynomial power = image; // t^(q^n)
    std::size_t left = extension.degree();
    for (std::size_t n = 1; left >= 2 * n; ++n) {
        std::size_t degree = common_divisor(g, difference_of(power, t)).size() - 1;
        for (const std::size_t length : lengths)
            if (n % length == 0) degree -= length;
        lengths.insert(lengths.end(), degree / n, n);
        left -= degree;
        Polynomial next = extension.constant({}); // q-th powers are taken term by term
        for (std::size_t k = 0; k < power.size(); ++k)
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] = next[i] + power[k] * images[k][i];
        power = std::move(next);
    }
    if (left > 0) lengths.push_back(left);
    return lengths;
}

std::vector<CycleType> cycle_types_of(const std::vector<Polynomial>& fibres,
                                      const std::function<void(std::uint64_t)>& spend) {
    std::size_t degree = 0;
    for (const Polynomial& lower : fibres)
        degree = std::max(degree, lower.size());
    std::vector<CycleType> cycle_types;
    if (std::ranges::count(fibres, degree, &Polynomial::size) < 2) return cycle_types;
    for (const Polynomial& lower : fibres) {
        if (lower.size() != degree) continue;
        spend((5 * std::uint64_t{degree} + 300) * degree * degree / 100'000);
        cycle_types.push_back(cycle_type_of(lower));
    }
    return cycle_types;
}

/// Which sums parts of the lengths have, up to a number.
static std::vector<bool> sums_of_parts(const CycleType& lengths, std::size_t most) {
    std::vector<bool> sums(most + 1);
    sums[0] = true;
    for (const std::size_t length : lengths)
        for (std::size_t sum = most; sum >= length; --sum)
            if (sums[sum - length]) sums[sum] = true;
    return sums;
}

/// Whether no set of points, but for none and all, may be kept by permutations with these cycles.
static bool is_transitive(const std::vector<CycleType>& cycle_types, std::size_t points) {
    std::vector<bool> orbit(points + 1, true); // which sizes one may have
    for (const CycleType& lengths : cycle_types) {
        const std::vector<bool> sums = sums_of_parts(lengths, points);
        for (std::size_t size = 0; size <= points; ++size)
            orbit[size] = orbit[size] && sums[size];
    }
    return std::ranges::count(orbit, true) == 2;
}

/// Whether a cycle may run through n blocks of so many points, with others that fill them: each has
/// in each of these blocks as many points, its length divided by n.
static bool fits_in_blocks(const CycleType& lengths, std::size_t cycle, std::size_t n,
                           std::size_t block) {
    const std::size_t length = lengths[cycle];
    if (length % n != 0 || length / n > block) return false;
    CycleType others; // what they have in a block
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (i != cycle && lengths[i] % n == 0) others.push_back(lengths[i] / n);
    const std::size_t room = block - length / n;
    return sums_of_parts(others, room)[room];
}

/// Whether a permutation with these cycles may permute blocks of so many points.
static bool may_keep_blocks(const CycleType& lengths, std::size_t block) {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (i > 0 && lengths[i] == lengths[i - 1]) continue;
        bool fits = false;
        for (std::size_t n = 1; n <= lengths[i] && !fits; ++n)
            fits = fits_in_blocks(lengths, i, n, block);
        if (!fits) return false;
    }
    return true;
}

/// Whether no blocks of points may be kept by permutations with these cycles.
static bool is_primitive(const std::vector<CycleType>& cycle_types, std::size_t points) {
    for (std::size_t block = 2; block < points; ++block)
        if (points % block == 0 && std::ranges::all_of(cycle_types, [&](const CycleType& lengths) {
                return may_keep_blocks(lengths, block);
            }))
            return false;
    return true;
}

std::string group_shown_by(const std::vector<CycleType>& cycle_types, std::size_t solutions,
                           Orbits orbits) {
    std::vector<CycleType> whole; // permutations of all solutions
    for (const CycleType& lengths : cycle_types)
        if (points_of(lengths) == solutions) whole.push_back(lengths);
    // By Jordan's theorems a primitive group with such a cycle contains all even permutations.
    const auto has_cycle = [&](const CycleType& lengths) {
        return has_prime_cycle(lengths, 2, std::max<std::size_t>(solutions, 6) - 3);
    };
    const auto differs = [&](const CycleType& lengths) { return lengths != whole.front(); };
    if (std::ranges::none_of(whole, has_cycle) || std::ranges::none_of(whole, differs) ||
        (orbits == Orbits::unknown && !is_transitive(whole, solutions)) ||
        !is_primitive(whole, solutions))
        return {};
    const auto even = std::ranges::count_if(whole, is_even);
    const bool both_signs = even > 0 && even < std::ssize(whole);
    return say(both_signs ? "S" : ">=A", solutions);
}
} // namespace checker
