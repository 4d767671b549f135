// The camera equations (certs/FORMAT.md, section 9) at given integer images, over a field or an
// algebra, with their derivatives. Field has a type Element and functions constant(int), sum,
// difference, product, and scaled(Element, integer).
#pragma once

#include "prover/fibres/camera_images.h"
#include "prover/fibres/vectors_over.h"

namespace plprove {

template <class Field>
class CamerasOver {
public:
    using Element = typename Field::Element;
    using Vector = VectorOver<Field>;

    /// At these camera coordinates, 11 of them, which must outlive this object, as the images must.
    CamerasOver(const Field& field, const CameraImages& images,
                const std::vector<Element>& coordinates)
        : field_(field), images_(images), coordinates_(coordinates) {
        centres_[0].fill(field.constant(0));
        centres_[1] = {field.constant(1), coordinates[6], coordinates[7]};
        centres_[2] = {coordinates[8], coordinates[9], coordinates[10]};
        const Quaternion second(field, quaternion_of(1)), third(field, quaternion_of(2));
        for (std::size_t n = 0; n < images.vectors.size(); ++n) {
            const IntegerVector& x = images.vectors[n];
            turned_.push_back(view(n) == 0 ? fixed(x) : turned(view(n) == 1 ? second : third, x));
        }
    }

    /// Of each equation its value.
    std::vector<Element> values() const {
        std::vector<Element> result;
        for (const CameraEquation& equation : images_.system.equations)
            result.push_back(value(equation));
        return result;
    }

    /// Of each equation its derivatives by the 11 coordinates.
    std::vector<std::vector<Element>> gradients() {
        changes_.clear();
        for (std::size_t n = 0; n < images_.vectors.size(); ++n)
            changes_.push_back(view(n) == 0 ? Changes{}
                                            : changes(quaternion_of(view(n)), images_.vectors[n]));
        std::vector<std::vector<Element>> result;
        for (const CameraEquation& equation : images_.system.equations)
            result.push_back(gradient(equation));
        return result;
    }

private:
    Element value(const CameraEquation& equation) const {
        const auto& [a, b, c] = equation.vectors;
        switch (equation.kind) {
        case EquationKind::epipolar:
            return dot(base(b, a), cross(at(a), at(b)));
        case EquationKind::pencil:
            return dot(at(a), cross(at(b), at(c)));
        case EquationKind::incidence:
            break;
        }
        return field_.difference(field_.product(dot(at(b), base(a, b)), dot(at(c), at(a))),
                                 field_.product(dot(at(c), base(a, c)), dot(at(b), at(a))));
    }

    std::vector<Element> gradient(const CameraEquation& equation) {
        row_.assign(camera_dimension, field_.constant(0));
        const auto& [a, b, c] = equation.vectors;
        if (equation.kind == EquationKind::epipolar) {
            const Vector normal = cross(at(a), at(b));
            add_by_vector(a, cross(at(b), base(b, a)));
            add_by_vector(b, cross(base(b, a), at(a)));
            add_by_centre(b, normal);
            add_by_centre(a, scaled(field_.constant(-1), normal));
        } else if (equation.kind == EquationKind::pencil) {
            add_by_vector(a, cross(at(b), at(c)));
            add_by_vector(b, cross(at(c), at(a)));
            add_by_vector(c, cross(at(a), at(b)));
        } else {
            const Vector to_b = base(a, b), to_c = base(a, c);
            const Element b_apart = dot(at(b), to_b), b_ray = dot(at(b), at(a));
            const Element c_apart = dot(at(c), to_c), c_ray = dot(at(c), at(a));
            const Vector by_b = scaled(c_ray, at(b)), by_c = scaled(b_ray, at(c));
            add_by_vector(a, minus(scaled(b_apart, at(c)), scaled(c_apart, at(b))));
            add_by_vector(b, minus(scaled(c_ray, to_b), scaled(c_apart, at(a))));
            add_by_vector(c, minus(scaled(b_apart, at(a)), scaled(b_ray, to_c)));
            add_by_centre(a, minus(by_b, by_c));
            add_by_centre(b, scaled(field_.constant(-1), by_b));
            add_by_centre(c, by_c);
        }
        return std::move(row_);
    }

    /// (1, q), with the products of two coordinates of q, and 1 - q·q.
    struct Quaternion {
        Quaternion(const Field& field, const Element* coordinates)
            : q(coordinates), rest(field.constant(1)) {
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t k = 0; k < i; ++k)
                    products[i][k] = products[k][i] = field.product(q[i], q[k]);
                products[i][i] = field.product(q[i], q[i]);
                rest = field.difference(rest, products[i][i]);
            }
        }

        const Element* q;
        std::array<Vector, 3> products;
        Element rest;
    };

    /// The derivatives of a vector R^T x by the three coordinates of the quaternion.
    using Changes = std::array<Vector, 3>;

    static std::size_t index(int n) { return static_cast<std::size_t>(n); }
    int view(std::size_t n) const { return images_.system.vectors[n].view; }
    int view(int n) const { return view(index(n)); }
    const Element* quaternion_of(int view) const { return &coordinates_[view == 1 ? 0 : 3]; }
    const Vector& at(int n) const { return turned_[index(n)]; }
    /// From the centre of the view of vector b to that of a.
    Vector base(int a, int b) const {
        return minus(centres_[index(view(a))], centres_[index(view(b))]);
    }

    Vector fixed(const IntegerVector& x) const {
        return {field_.constant(x[0]), field_.constant(x[1]), field_.constant(x[2])};
    }

    /// R^T x = 2 (q·x) q + (1 - q·q) x + 2 x × q.
    Vector turned(const Quaternion& quaternion, const IntegerVector& x) const {
        const Element* q = quaternion.q;
        Vector result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            Element& sum = result[i];
            sum = field_.scaled(quaternion.rest, x[i]);
            for (std::size_t n = 0; n < 3; ++n)
                sum = field_.sum(sum, field_.scaled(quaternion.products[n][i], 2 * x[n]));
            sum = field_.sum(sum, field_.scaled(q[k], 2 * x[j]));
            sum = field_.difference(sum, field_.scaled(q[j], 2 * x[k]));
        }
        return result;
    }

    /// By q_n: 2 x_n q_i + (if i = n) 2 q·x - 2 q_n x_i + 2 (x × e_n)_i.
    Changes changes(const Element* q, const IntegerVector& x) const {
        Element along = field_.constant(0);
        for (std::size_t k = 0; k < 3; ++k)
            along = field_.sum(along, field_.scaled(q[k], 2 * x[k]));
        Changes result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            for (std::size_t n = 0; n < 3; ++n) {
                Element change =
                    field_.difference(field_.scaled(q[i], 2 * x[n]), field_.scaled(q[n], 2 * x[i]));
                if (n == i) change = field_.sum(change, along);
                if (n == k) change = field_.sum(change, field_.constant(2 * x[j]));
                if (n == j) change = field_.difference(change, field_.constant(2 * x[k]));
                result[n][i] = std::move(change);
            }
        }
        return result;
    }

    Element dot(const Vector& a, const Vector& b) const { return plprove::dot(field_, a, b); }
    Vector cross(const Vector& a, const Vector& b) const { return plprove::cross(field_, a, b); }
    Vector minus(const Vector& a, const Vector& b) const {
        return {field_.difference(a[0], b[0]), field_.difference(a[1], b[1]),
                field_.difference(a[2], b[2])};
    }
    Vector scaled(const Element& factor, const Vector& a) const {
        return {field_.product(factor, a[0]), field_.product(factor, a[1]),
                field_.product(factor, a[2])};
    }

    void add(std::size_t column, const Element& change) {
        row_[column] = field_.sum(row_[column], change);
    }
    void add_by_vector(int n, const Vector& by) {
        if (view(n) == 0) return;
        for (std::size_t k = 0; k < 3; ++k)
            add(3 * (index(view(n)) - 1) + k, dot(by, changes_[index(n)][k]));
    }
    void add_by_centre(int n, const Vector& by) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (view(n) == 1 && k > 0) add(5 + k, by[k]);
            if (view(n) == 2) add(8 + k, by[k]);
        }
    }

    const Field& field_;
    const CameraImages& images_;
    const std::vector<Element>& coordinates_;
    std::array<Vector, 3> centres_;
    std::vector<Vector> turned_;   ///< the vectors R^T x
    std::vector<Changes> changes_; ///< of each
    std::vector<Element> row_;
};

} // namespace plprove
