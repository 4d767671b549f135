// The degree of a problem in three calibrated views, by theorem (proofs/three_views/): Theorems C
// and K give it as an integral, which is computed here; nine classes have a row each. The
// problem is assumed to be minimal.
#pragma once

#include "checker/exactly/integrals.h"
#include "checker/exactly/rows.h"

#include <map>
#include <span>

namespace checker::exactly {
/// How many camera solutions a minimal problem has exactly, and by which theorem.
struct Degree {
    std::size_t solutions = 0;
    std::string_view theorem{};
};

/// By constraint class. Throws std::logic_error if a class has two rows.
std::map<Signature, Row> rows_by_class(std::span<const Row> list);

/// Degrees by constraint class, computed where they are asked for, once each. Classes that follow
/// each other in order take about a millisecond each; the first one takes longer.
class Degrees {
public:
    /// Of a minimal constraint class, by the signature that stands for it; none if no theorem
    /// speaks of it.
    std::optional<Degree> of(const Signature& key);

private:
    std::optional<Degree> compute(const Signature& key);

    std::map<Signature, Row> rows_ = rows_by_class(rows);
    std::optional<Integrals> integrals_{};
    std::map<Signature, std::optional<Degree>> known_{};
};
} // namespace checker::exactly
