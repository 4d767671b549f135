// The catalogue: everything that is known of each of the 143,494 label classes, as plain values.
//
// Verdicts are the prover's, read off the obstruction of the signature; what makes them theorems is
// the record of the same class in certs/classification.plc, which plcheck replays.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/catalogue/groups.h"
#include "prover/minimal/families.h"

namespace plprove {

/// How many points and lines a problem has, and what the views of the class's representative see of
/// them.
struct Counts {
    int points = 0;
    int pins = 0;
    int free_lines = 0;
    int most_pins = 0; ///< the largest number of pins of a point
    std::array<int, 3> points_in_view{};
    std::array<int, 3> lines_in_view{};
    std::array<int, 3> shared_points{}; ///< by the pairs 12, 13, 23 of views
    int complete_views = 0;             ///< how many views see every point and every line

    int lines() const { return pins + free_lines; }
};

/// The counts of a problem in three views made of the 27 features.
Counts counts(const Signature& signature);

/// One label class.
struct Entry {
    std::size_t number = 0; ///< the authors' number
    Signature signature{};  ///< of the representative
    Obstruction obstruction;
    std::size_t swap_class = 0;       ///< the number of its first member
    std::size_t constraint_class = 0; ///< the number of its first member
    Counts counts;
    /// Of a class that is not minimal only pl0p and at_most_one_pin: the other families consist of
    /// minimal problems.
    Families families;
    std::optional<int> degree;       ///< of a minimal class
    std::optional<GroupOnFile> group; ///< of a minimal class, where it is known

    bool minimal() const { return obstruction.deficiency() == 0; }
    int rank() const { return camera_dimension - obstruction.deficiency(); }
    std::optional<int> width() const { return group ? std::optional(group->width) : std::nullopt; }
    /// Whether the class stands for its terminal problem: the first member of a minimal swap class.
    bool terminal() const { return minimal() && swap_class == number; }
};

/// Why a class is not minimal: `none`, `epipolar`, `star` or `epipolar and star`.
std::string_view obstruction_name(const Obstruction& obstruction);

/// All label classes, ascending.
std::vector<Entry> catalogue();

} // namespace plprove
