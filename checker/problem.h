// Problems (FORMAT.md, sections 1 and 4): the 27 features, signatures, their classes, obstructions.
// All follows from what each view sees of a feature: only the list of names is taken on trust.
#pragma once

#include <array>
#include <bit>
#include <string>
#include <vector>

namespace checker {

inline constexpr std::size_t feature_count = 27, camera_unknowns = 11;

using Views = unsigned; // the set of views 1, 2, 3 is 0b111
inline constexpr std::array<Views, 3> view_pairs{0b011, 0b101, 0b110}; // 12, 13, 23

/// A point with pins; or, if no view sees the point, a free line, which is its one pin.
struct Feature {
    std::string_view notation;
    Views point = 0, views = 0; // those that see the point; that see anything
    std::array<Views, 7> pin{}; // those that see each pin
    unsigned pins = 0;
    unsigned equations = 0; // degrees of freedom in the images, rows of the Jacobian

    constexpr unsigned point_unknowns() const { return point == 0 ? 2 : 3; }
    constexpr unsigned unknowns() const { return point_unknowns() + 2 * pins; } // in space
    constexpr unsigned weight() const { return equations - unknowns(); }
};
extern const std::array<Feature, feature_count> features;

/// The multiplicity of each feature.
using Signature = std::array<unsigned, feature_count>;

/// The signature in notation, as in `2*Pa/Pa/Pa + P/P/P`.
std::string notation(const Signature& signature);

/// The number of points that both views of a pair see.
unsigned shared_points(const Signature& signature, Views pair);

/// How the relabelings of the views and all swaps at once act: s becomes the t with t[i] =
/// s[map[i]].
using Map = std::array<std::size_t, feature_count>;
extern const std::array<Map, 6> relabelings;
extern const Map swaps;

/// The balanced signatures, up to relabeling the views and up to swaps.
struct Classification {
    std::size_t signatures = 0;
    std::vector<Signature> representatives{}; // by class number, lexicographically decreasing
    std::vector<std::size_t> swap_class{};    // the first class of the same swap&label class
};
Classification classify();

/// Why a problem is not minimal at any point (section 4).
struct Obstruction {
    std::array<unsigned, 3> excess{}; // of the pairs 12, 13, 23
    unsigned star = 0;                // S

    unsigned epipolar() const { return excess[0] + excess[1] + excess[2]; } // E
    unsigned deficiency() const { return epipolar() > star ? epipolar() : star; }
    bool minimal() const { return deficiency() == 0; }
};

/// The obstruction of a balanced signature.
Obstruction obstruction(const Signature& signature);

} // namespace checker
