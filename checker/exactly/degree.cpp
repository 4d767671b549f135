#include "checker/exactly/degree.h"

#include "checker/degrees/constraint_class.h"
#include "checker/exactly/many_pins.h"

#include <charconv>
#include <stdexcept>

namespace checker::exactly {
/// The signature of a sum of features of the table.
static Signature signature_of(std::string_view problem) {
    constexpr std::string_view plus = " + ";
    Signature signature{};
    while (!problem.empty()) {
        std::string_view summand = problem.substr(0, problem.find(plus));
        problem.remove_prefix(std::min(summand.size() + plus.size(), problem.size()));
        unsigned count = 1;
        if (const std::size_t star = summand.find('*'); star != std::string_view::npos) {
            std::from_chars(summand.data(), summand.data() + star, count);
            summand.remove_prefix(star + 1);
        }
        signature.at(index_of(summand)) += count;
    }
    return signature;
}

std::map<Signature, Row> rows_by_class(std::span<const Row> list) {
    std::map<Signature, Row> by_class;
    for (const Row& row : list)
        if (!by_class.emplace(constraint_class(signature_of(row.problem)), row).second)
            throw std::logic_error("two rows for " + std::string(row.problem));
    return by_class;
}

static unsigned most_pins(const Signature& signature) {
    unsigned most = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if (signature[i] > 0) most = std::max(most, features[i].pins);
    return most;
}

/// A minimal problem has a solution: no integral is 0.
static std::size_t positive(std::int64_t integral) {
    if (integral <= 0) throw std::logic_error("the degree of a minimal problem is not positive");
    return static_cast<std::size_t>(integral);
}

std::optional<Degree> Degrees::compute(const Signature& key) {
    if (const auto row = rows_.find(key); row != rows_.end())
        return Degree{row->second.solutions, row->second.theorem};
    if (!integrals_) integrals_.emplace();
    const unsigned pins = most_pins(key);
    if (pins <= 3) return Degree{positive(integrals_->over_third_blow_up(key)), "C"};
    if (!theorem_k_applies(key)) return std::nullopt;
    const std::int64_t degree =
        pins == 4 ? integrals_->over_third_blow_up(key) : integrals_->over_second_blow_up(key);
    return Degree{positive(degree), "K"};
}

std::optional<Degree> Degrees::of(const Signature& key) {
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    return known_[key] = compute(key);
}
} // namespace checker::exactly
