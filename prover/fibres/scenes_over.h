// The equations of cameras and depths (certs/FORMAT.md, section 14) at given integer images, over a
// field or an algebra, with their derivatives. Field is as in prover/fibres/cameras_over.h.
#pragma once

#include "prover/fibres/scene_equations.h"
#include "prover/fibres/vectors_over.h"

namespace plprove {

template <class Field>
class ScenesOver {
public:
    using Element = typename Field::Element;

    /// At these unknowns. All three must outlive this object.
    ScenesOver(const Field& field, const SceneEquations& scene,
               const std::vector<Element>& unknowns)
        : field_(field), scene_(scene), unknowns_(unknowns), zero_(field.constant(0)) {
        for (const SceneCamera& camera : scene.cameras)
            cameras_.push_back(at_point(camera.matrix));
    }

    /// Of each equation its value.
    std::vector<Element> values() const {
        std::vector<Element> result;
        for (const SceneEquation& equation : scene_.equations)
            result.push_back(along(seen_line(equation, camera(equation)), equation.place));
        return result;
    }

    /// Of each equation its derivatives by all unknowns.
    std::vector<std::vector<Element>> gradients() const {
        std::vector<std::vector<Matrix>> derivatives;
        for (const SceneCamera& camera : scene_.cameras) {
            derivatives.emplace_back();
            for (const auto& [unknown, matrix] : camera.derivatives)
                derivatives.back().push_back(at_point(matrix));
        }
        std::vector<std::vector<Element>> result;
        for (const SceneEquation& equation : scene_.equations)
            result.push_back(gradient(equation, derivatives[equation.view - 1]));
        return result;
    }

    /// Numbers that may not all vanish, in each of these groups (*What a checker must verify*, item
    /// 4): of each camera its minors, in each view from the second the image of each point, and the
    /// line through the images of the two places of each line.
    std::vector<std::vector<Element>> conditions() const {
        std::vector<std::vector<Element>> result;
        for (const Matrix& camera : cameras_) {
            result.push_back(minors(camera));
            for (const ScenePlace& place : scene_.points)
                result.push_back(as_group(image(camera, place)));
            for (const auto& [first, second] : scene_.lines)
                result.push_back(
                    as_group(cross(field_, image(camera, first), image(camera, second))));
        }
        return result;
    }

private:
    using Vector = VectorOver<Field>;
    using Matrix = CameraMatrix<Element>;
    /// l · [M | t], for a line l.
    using Line = std::array<Element, 4>;

    const Matrix& camera(const SceneEquation& equation) const {
        return cameras_[equation.view - 1];
    }

    Element at_point(const NumberPolynomial& polynomial) const {
        Element sum = zero_;
        for (const auto& [factors, coefficient] : polynomial.terms)
            sum = field_.sum(sum, term(factors, coefficient));
        return sum;
    }

    Element term(const std::vector<int>& factors, int coefficient) const {
        if (factors.empty()) return field_.constant(coefficient);
        Element product = unknowns_[static_cast<std::size_t>(factors.front())];
        for (std::size_t k = 1; k < factors.size(); ++k)
            product = field_.product(product, unknowns_[static_cast<std::size_t>(factors[k])]);
        return field_.scaled(product, coefficient);
    }

    Matrix at_point(const CameraMatrix<NumberPolynomial>& matrix) const {
        Matrix result;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                result[i][j] = at_point(matrix[i][j]);
        return result;
    }

    Line seen_line(const SceneEquation& equation, const Matrix& camera) const {
        Line result;
        for (std::size_t j = 0; j < 4; ++j) {
            result[j] = zero_;
            for (std::size_t i = 0; i < 3; ++i)
                result[j] = field_.sum(result[j], field_.scaled(camera[i][j], equation.l[i]));
        }
        return result;
    }

    /// The line times the place.
    Element along(const Line& line, const ScenePlace& place) const {
        Element depth = zero_;
        for (const auto& [unknown, factor] : place.depth)
            depth = field_.sum(depth, field_.scaled(unknowns_[unknown], factor));
        Element sum = field_.product(line[3], depth);
        for (std::size_t j = 0; j < 3; ++j)
            sum = field_.sum(sum, field_.scaled(line[j], place.x[j]));
        return sum;
    }

    /// By the derivatives of the camera of the equation's view.
    std::vector<Element> gradient(const SceneEquation& equation,
                                  const std::vector<Matrix>& derivatives) const {
        std::vector<Element> result(scene_.unknowns, zero_);
        const SceneCamera& camera = scene_.cameras[equation.view - 1];
        for (std::size_t k = 0; k < derivatives.size(); ++k)
            result[camera.derivatives[k].first] =
                along(seen_line(equation, derivatives[k]), equation.place);
        const Line line = seen_line(equation, this->camera(equation));
        for (const auto& [unknown, factor] : equation.place.depth)
            result[unknown] = field_.scaled(line[3], factor);
        return result;
    }

    static std::vector<Element> as_group(const Vector& x) { return {x.begin(), x.end()}; }

    Vector image(const Matrix& camera, const ScenePlace& place) const {
        return {along(camera[0], place), along(camera[1], place), along(camera[2], place)};
    }

    /// The determinants of three columns.
    std::vector<Element> minors(const Matrix& camera) const {
        std::vector<Element> result;
        const auto column = [&](std::size_t j) {
            return Vector{camera[0][j], camera[1][j], camera[2][j]};
        };
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            const Vector normal =
                cross(field_, column((left_out + 2) % 4), column((left_out + 3) % 4));
            result.push_back(dot(field_, column((left_out + 1) % 4), normal));
        }
        return result;
    }

    const Field& field_;
    const SceneEquations& scene_;
    const std::vector<Element>& unknowns_;
    Element zero_;
    std::vector<Matrix> cameras_; ///< of the views from the second
};

} // namespace plprove
