// Vectors of three residues, and determinants of three vectors over any ring.
#pragma once

#include "checker/algebra/vector3.h"
#include "proofs/computations/residue_matrices.h"

namespace residue_vectors {

using Vector = checker::Vector3<checker::Residue>;

inline Vector random_vector(proofs::Residues& random) {
    return {random.next(), random.next(), random.next()};
}

template <class T>
T determinant(const checker::Vector3<T>& a, const checker::Vector3<T>& b,
              const checker::Vector3<T>& c) {
    return checker::dot(a, checker::cross(b, c));
}

} // namespace residue_vectors
