// What lower and upper bounds together say of the degrees (FORMAT.md, section 10). Here theorems
// are applied, and only to classes that are proved minimal.
#pragma once

#include "checker/bounds/bounds_file.h"
#include "checker/degrees/degree_file.h"

#include <optional>
#include <variant>

namespace checker {
/// A bound by theorem, by its place among all rows.
struct TheoremRow {
    std::size_t row = 0;
    std::string_view theorem{};
    auto operator<=>(const TheoremRow&) const = default;
};

/// A record of a file of upper bounds (FORMAT.md, section 15).
struct ByForms {
    auto operator<=>(const ByForms&) const = default;
};

using BoundSource = std::variant<Registration, TheoremRow, ByForms>;

struct UpperBound {
    std::size_t solutions = 0; // at most
    BoundSource by{};

    bool by_theorem() const { return std::holds_alternative<TheoremRow>(by); }
};

/// What is known of the camera-degree of a constraint class.
struct DegreeBounds {
    std::size_t at_least = 0;
    std::optional<UpperBound> at_most{};
    bool complete = false; // no more than at_least, by evidence

    bool exact() const { return at_most && at_most->solutions == at_least; }
};

/// By constraint class. Classes of which nothing is known are absent.
using DegreeTable = std::map<Signature, DegreeBounds>;

/// Puts bounds together. Upper bounds are applied to the label classes that are `minimal`, by their
/// numbers. Theorems name classes by number too, in the list of all of them: of a list that ends
/// earlier, as tests have, the rows beyond its end say nothing.
DegreeTable combine(const Classification& classes, const std::vector<bool>& minimal,
                    const std::vector<LowerBound>& lower, const RegistrationBounds& upper);

/// What is known of the degree of a balanced signature.
DegreeBounds bounds_of(const DegreeTable& table, const Signature& signature);

/// In words, a class whose bounds contradict each other; none if there is none.
std::optional<std::string> contradiction(const DegreeTable& table);
} // namespace checker
