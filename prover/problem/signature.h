// Signatures: how often each of the 27 features occurs in a reduced problem in three views, with
// the relabeling of views and the swap of Corollary 1 acting on them.
#pragma once

#include "prover/problem/feature.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace plprove {

inline constexpr std::size_t feature_count = 27;

/// The multiplicities of the 27 features, in the authors' order.
using Signature = std::array<std::uint8_t, feature_count>;

/// The dimension of the space of three calibrated cameras modulo similarity.
inline constexpr int camera_dimension = 11;

/// The problem with the features of `signature` in the authors' order.
Features problem_of(const Signature& signature);

/// The signature of a problem that consists of standard features (pins named in any way), else
/// nothing.
std::optional<Signature> signature_of(const Features& problem);

/// The images of `signature` under the six permutations of the views, the signature itself first.
std::array<Signature, 6> relabelings(const Signature& signature);

/// The lexicographically largest relabeling: the signature that represents the label class.
Signature representative(const Signature& signature);

/// The pairs of features that a swap exchanges (Corollary 1 of the paper): (12,13), (14,15),
/// (16,17).
inline constexpr std::array<std::array<std::size_t, 2>, 3> swap_pairs{
    {{12, 13}, {14, 15}, {16, 17}}};

/// The pairs of features that put the same condition on the cameras (a ray meets the intersection
/// of two planes): P/a/a and Pab/b/a, and so on for the other views.
inline constexpr std::array<std::array<std::size_t, 2>, 3> exchange_pairs{
    {{21, 24}, {22, 25}, {23, 26}}};

/// The lexicographically largest signature of the swap&label class: it represents the class.
Signature swap_representative(const Signature& signature);

/// The lexicographically largest signature of the constraint class: the classes under relabeling,
/// swap and exchange, whose problems share their camera equations.
Signature constraint_representative(const Signature& signature);

/// How many features of each kind a signature has; a kind is what relabeling, swap and exchange
/// make one. Quick, and the same for all signatures of a constraint class.
using KindCounts = std::array<int, 13>;
KindCounts kind_counts(const Signature& signature);

/// All representatives of label classes of balanced signatures in decreasing lexicographic order:
/// the index in this list is the authors' number of the class. Made at the first call, in a few
/// milliseconds.
const std::vector<Signature>& label_classes();

/// The number of the class that `representative` represents: its index in `classes`, the list of
/// label_classes(). Assumes that it is there.
std::size_t class_number(const std::vector<Signature>& classes, const Signature& representative);

} // namespace plprove
