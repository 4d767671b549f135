// The critical pairs of a growing Gröbner basis, without those that the criteria of Gebauer and
// Möller make superfluous.
#pragma once

#include "prover/model/monomial.h"

#include <vector>

namespace plprove::model {

/// Two elements of the basis, by number, and the least common multiple of their leading monomials.
struct CriticalPair {
    std::size_t first = 0;
    std::size_t second = 0;
    Monomial multiple;
    int degree = 0;
};

class CriticalPairs {
public:
    /// Adds an element with this leading monomial; the elements are numbered as they come. Elements
    /// whose leading monomial it divides need no longer be in the basis.
    void add_element(const Monomial& leading);

    bool empty() const { return pairs_.empty(); }
    /// All pairs of the least degree, which are taken out.
    std::vector<CriticalPair> take_least();

    const std::vector<Monomial>& leading() const { return leading_; }
    /// Whether no later element has a leading monomial that divides that of this one.
    bool is_minimal(std::size_t element) const { return minimal_[element]; }

private:
    std::vector<CriticalPair> new_pairs(const Monomial& leading) const;

    std::vector<Monomial> leading_;
    std::vector<bool> minimal_;
    std::vector<CriticalPair> pairs_;
};

} // namespace plprove::model
