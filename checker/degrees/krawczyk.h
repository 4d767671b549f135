// Proofs that a system has a zero near a point, by Krawczyk's operator in ball arithmetic
// (proofs/degrees.md). They need the library Arb: without it nothing is proved.
#pragma once

#include "checker/degrees/camera_equations.h"

#include <functional>
#include <span>
#include <variant>

namespace checker {
/// The starting values of a solution: for each coordinate the real and the imaginary part, times
/// 2^bits. All imaginary parts of a real one are 0.
struct ApproximateSolution {
    std::size_t line = 0; // in the file
    bool real = true;
    int bits = 0;
    std::vector<std::array<std::int64_t, 2>> coordinates{};
};

/// A set of coordinates: intervals of their real and imaginary parts, in turn.
struct Box {
    std::vector<double> low{};
    std::vector<double> high{};
    unsigned tries = 1; // of proving something of it: each takes longer than the one before

    bool meets(const Box& other) const {
        for (std::size_t i = 0; i < low.size(); ++i)
            if (high[i] < other.low[i] || other.high[i] < low[i]) return false;
        return true;
    }

    Box conjugate() const {
        Box box = *this;
        for (std::size_t i = 1; i < low.size(); i += 2) {
            box.low[i] = -high[i];
            box.high[i] = -low[i];
        }
        return box;
    }
};

extern const bool has_arb; // whether this program was built with Arb

/// A box with one nondegenerate solution of the system, to which Newton steps from the starting
/// values lead. The solution is real if these are. Throws Refused without a proof.
Box certify(const CameraSystem& system, const ApproximateSolution& start);

/// Makes such a box from starting values. Throws Refused without a proof.
using Certify = std::function<Box(const ApproximateSolution&)>;

/// A box, or why there is none.
using Proof = std::variant<Box, Refused>;

/// What `certify` makes of each starting value. So many threads do it, side by side.
std::vector<Proof> certify_all(const Certify& certify, std::span<const ApproximateSolution> starts,
                               std::size_t threads);
} // namespace checker
