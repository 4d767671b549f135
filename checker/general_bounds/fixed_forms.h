// The space of all forms in the depths of a scene, of one degree, that vanish at base points as
// products of `cubics` cubic forms do (proofs/fixed_forms.md). It is the same for all
// images that view 1 shows alike.
#pragma once

#include "checker/general_bounds/base_scenes.h"

namespace checker {
/// Scenes up to motions that fix camera 1: these change all depths D by a linear form of the image
/// vectors, so three depths can be 0.
class SceneCoordinates {
public:
    /// Which three, is chosen so that few base points are hard to describe. Throws Refused where no
    /// three image vectors are independent.
    SceneCoordinates(const SceneSystem& system, const std::vector<FewDepths>& base);

    /// The depths that are not made 0.
    const std::vector<std::size_t>& kept() const { return kept_; }

    /// Their values after the motion.
    SmallRow of(SmallRow own) const;

    /// All own depths of the scene with these.
    SmallRow scene(const SmallRow& kept) const;

private:
    std::vector<Row3> x_{}; // the image vector of each own depth
    std::array<std::size_t, 3> zero_{};
    std::vector<std::size_t> kept_{};
};

/// How products of cubic forms and of linear ones vanish.
struct Powers {
    int cubics = 1;
    int linear = 1;

    int degree() const { return 3 * cubics + linear; }
};

/// A monomial in the coordinates.
using Monomial = std::vector<int>;

/// All monomials that forms may have which vanish where only some coordinates are not 0. Throws
/// Refused if there are more than 10,000.
std::vector<Monomial> monomials_that_fit(const BaseScenes& base,
                                         const SceneCoordinates& coordinates, const Powers& powers);

/// How many conditions the other base scenes put on their coefficients, at least, for generic image
/// vectors of view 1.
std::size_t rank_of_conditions(const std::vector<Monomial>& monomials, const Problem& problem,
                               const SceneSystem& system, const BaseScenes& base,
                               const SceneCoordinates& coordinates, const Powers& powers,
                               Choices& choices);
} // namespace checker
