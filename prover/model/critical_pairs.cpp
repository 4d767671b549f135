#include "prover/model/critical_pairs.h"

#include <algorithm>

namespace plprove::model {

namespace {

bool coprime(const Monomial& a, const Monomial& b) {
    for (std::size_t i = 0; i < most_variables; ++i)
        if (a.exponents[i] != 0 && b.exponents[i] != 0) return false;
    return true;
}

} // namespace

/// The pairs of the new element with others: of pairs where one multiple divides another only the
/// former is needed, of pairs with one multiple only one; none if the leading monomials of that one
/// are coprime.
std::vector<CriticalPair> CriticalPairs::new_pairs(const Monomial& leading) const {
    const std::size_t added = leading_.size();
    std::vector<CriticalPair> all;
    for (std::size_t i = 0; i < added; ++i) {
        if (!minimal_[i]) continue;
        const Monomial multiple = least_common_multiple(leading_[i], leading);
        all.push_back({i, added, multiple, multiple.degree()});
    }
    // Of equal multiples a coprime pair comes first.
    std::ranges::stable_sort(all, [&](const CriticalPair& a, const CriticalPair& b) {
        if (a.multiple != b.multiple) return grevlex_less(a.multiple, b.multiple);
        return coprime(leading_[a.first], leading) && !coprime(leading_[b.first], leading);
    });
    std::vector<CriticalPair> kept;
    for (const CriticalPair& pair : all)
        if (std::ranges::none_of(kept, [&](const CriticalPair& other) {
                return other.multiple.divides(pair.multiple);
            }))
            kept.push_back(pair);
    std::erase_if(kept,
                  [&](const CriticalPair& pair) { return coprime(leading_[pair.first], leading); });
    return kept;
}

void CriticalPairs::add_element(const Monomial& leading) {
    const std::vector<CriticalPair> added = new_pairs(leading);
    std::erase_if(pairs_, [&](const CriticalPair& pair) {
        return leading.divides(pair.multiple) &&
               least_common_multiple(leading_[pair.first], leading) != pair.multiple &&
               least_common_multiple(leading_[pair.second], leading) != pair.multiple;
    });
    pairs_.insert(pairs_.end(), added.begin(), added.end());
    bool minimal = true;
    for (std::size_t i = 0; i < leading_.size(); ++i) {
        if (minimal_[i] && leading_[i].divides(leading)) minimal = false;
        if (leading.divides(leading_[i])) minimal_[i] = false;
    }
    leading_.push_back(leading);
    minimal_.push_back(minimal);
}

std::vector<CriticalPair> CriticalPairs::take_least() {
    const int least = std::ranges::min(pairs_, {}, &CriticalPair::degree).degree;
    std::vector<CriticalPair> taken;
    for (const CriticalPair& pair : pairs_)
        if (pair.degree == least) taken.push_back(pair);
    std::erase_if(pairs_, [&](const CriticalPair& pair) { return pair.degree == least; });
    return taken;
}

} // namespace plprove::model
