// The cubic forms in the depths of a scene that vanish where some camera sees the scene as an image
// shows it (proofs/fixed_forms.md). To find this camera is called resection.
#pragma once

#include "checker/general_bounds/small_field.h"
#include "checker/general_degrees/scene_system.h"

#include <array>

namespace checker {
/// Image coordinates modulo the prime.
Row3 residues(const ImageCoordinates& vector);

/// The depths of all places of a system, whose own depths are these.
SmallRow place_depths(const SceneSystem& system, const SmallRow& own);

/// What one image says of its camera [M | t] modulo the prime: the rows of N(D) t = 0.
class Resection {
public:
    /// Of a camera of the system. Throws Refused where the image is special.
    Resection(const SceneSystem& system, std::size_t camera);

    /// How many minors of size 3 N(D) has.
    std::size_t minors() const {
        const std::size_t rows = eliminations_.size();
        return rows * (rows - 1) * (rows - 2) / 6;
    }

    /// The cubic minors of N(D), at a scene whose places have these depths.
    SmallRow cubics(const SmallRow& depths) const;

    /// Whether all minors vanish at D, and if `twice`, to order 2 in z on curves D + D' z + ...
    bool vanish(const SmallRow& depths, const SmallRow& directions, bool twice) const;

private:
    struct Seen {
        Row3 line{};
        std::size_t place = 0;
    };

    /// N(D).
    std::vector<Row3> matrix(const SmallRow& depths) const;

    std::vector<Seen> incidences_{};
    std::vector<SmallRow> eliminations_{}; // combinations of the incidences in which M is missing
};
} // namespace checker
