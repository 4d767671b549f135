// What the relations say about single degrees, and which degree is wrong where they fail.
#pragma once

#include "tests/laws/relations.h"

namespace laws {

/// A relation times a product y: the sum of coefficient times degree is 0.
struct Equation {
    struct Entry {
        std::size_t constraint_class = 0; ///< its index in DegreeForm::classes()
        std::int64_t coefficient = 0;
        auto operator<=>(const Entry&) const = default;
    };
    std::size_t relation = 0;   ///< its index
    std::vector<Entry> entries; ///< ascending, coefficients not 0
};

/// The equations that say anything, each once.
std::vector<Equation> equations(const std::vector<Relation>& relations, const DegreeForm& form);

/// The sum, which should be 0.
std::int64_t residual(const Equation& equation, const DegreeForm& form);

/// Indices of the equations that fail.
std::vector<std::size_t> failures(const std::vector<Equation>& equations, const DegreeForm& form);

/// A class, and the degree with which all equations that have it would hold.
struct Suspect {
    std::size_t constraint_class = 0;
    std::int64_t should_be = 0;
};

/// The classes of which a single wrong degree explains all failures, and that no equation which
/// holds contains. None, if more than one degree is wrong.
std::vector<Suspect> single_mistakes(const std::vector<Equation>& equations,
                                     const std::vector<std::size_t>& failed,
                                     const DegreeForm& form);

/// The classes in most of the equations that fail, the first of them in most; at most `most`.
std::vector<std::size_t> classes_in_most(const std::vector<Equation>& equations,
                                         const std::vector<std::size_t>& failed, std::size_t most);

/// For each class whether an equation contains it. Any single wrong degree of such a class makes an
/// equation fail.
std::vector<bool> guarded_by_equations(const std::vector<Equation>& equations, std::size_t classes);

} // namespace laws
