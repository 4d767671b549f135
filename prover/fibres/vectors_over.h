// Products of vectors of three over a field or an algebra, as in prover/fibres/cameras_over.h.
#pragma once

#include <array>
#include <cstddef>

namespace plprove {

template <class Field>
using VectorOver = std::array<typename Field::Element, 3>;

template <class Field>
typename Field::Element dot(const Field& field, const VectorOver<Field>& a,
                            const VectorOver<Field>& b) {
    return field.sum(field.sum(field.product(a[0], b[0]), field.product(a[1], b[1])),
                     field.product(a[2], b[2]));
}

template <class Field>
VectorOver<Field> cross(const Field& field, const VectorOver<Field>& a,
                        const VectorOver<Field>& b) {
    VectorOver<Field> result;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = field.difference(field.product(a[j], b[k]), field.product(a[k], b[j]));
    }
    return result;
}

} // namespace plprove
