#include "prover/solver/registration_equations.h"

#include <Eigen/QR>

namespace plprove {

namespace {

/// linear · t + free = 0
template <class Scalar>
struct Condition {
    Vector<Scalar> linear;
    Scalar free;
};

/// Collects conditions and the values of equations in the order of FORMAT.
template <class Scalar>
class Values {
public:
    using V = Vector<Scalar>;
    using Scene = KnownScene<Scalar>;

    Values(const Scene& scene, bounds::Frame frame, const Eigen::Matrix<Scalar, 3, 3>& rotation)
        : scene_(scene), frame_(frame), rotation_(rotation) {
        for (std::size_t i = 0; i < scene.stars.size(); ++i)
            add(scene.stars[i], i);
        for (std::size_t i = 0; i < scene.lines.size(); ++i)
            add(scene.lines[i], i);
        for (const auto& incidence : scene.incidences)
            add_incidence(incidence.point, incidence.image);
        for (const auto& group : scene.groups)
            add(group);
    }

    const std::vector<Condition<Scalar>>& conditions() const { return conditions_; }

    std::vector<Scalar> take() {
        if (frame_ == bounds::Frame::lines) add_reduced_minor();
        for (std::size_t l = 0; l < conditions_.size(); ++l)
            for (std::size_t k = 0; k < l; ++k)
                for (std::size_t j = 0; j < k; ++j)
                    for (std::size_t i = 0; i < j; ++i)
                        values_.push_back(minor(i, j, k, l));
        return std::move(values_);
    }

private:
    /// l · R x
    Scalar turned(const V& l, const V& x) const { return bilinear<Scalar>(l, rotation_ * x); }

    void add_incidence(const V& point, const V& image) {
        conditions_.push_back({image, turned(image, point)});
    }

    void add(const typename Scene::Star& star, std::size_t index) {
        const V& x = star.image;
        if (frame_ == bounds::Frame::points && index < 2) {
            if (index == 0) add_incidence(star.point, V(0, 0, 1));
            add_incidence(star.point, V(-x[1], x[0], 0));
        } else {
            add_incidence(star.point, V(0, x[2], -x[1]));
            add_incidence(star.point, V(-x[2], 0, x[0]));
        }
        for (const auto& pin : star.pins)
            values_.push_back(turned(pin.image, pin.direction));
    }

    void add(const typename Scene::Line& line, std::size_t index) {
        add_incidence(line.point, line.image);
        const bool fixes_frame =
            index == 0 && (frame_ == bounds::Frame::line || frame_ == bounds::Frame::lines);
        if (!fixes_frame)
            values_.push_back(turned(line.image, line.direction));
        else if (frame_ == bounds::Frame::line && scene_.stars.size() >= 2)
            add_distance(line);
    }

    void add(const typename Scene::Group& group) {
        const std::size_t first = conditions_.size();
        for (const auto& ray : group.rays)
            conditions_.push_back(
                {bilinear_cross<Scalar>(rotation_ * ray.direction, ray.image),
                 turned(ray.image, bilinear_cross<Scalar>(group.point, ray.direction))});
        for (std::size_t k = first; k < conditions_.size(); ++k)
            for (std::size_t j = first; j < k; ++j)
                for (std::size_t i = first; i < j; ++i)
                    values_.push_back(linear_minor(i, j, k));
    }

    /// Of two stars and a line: the known distance of the stars.
    void add_distance(const typename Scene::Line& line) {
        const V& x = scene_.stars[0].image;
        const V& y = scene_.stars[1].image;
        const V& point = scene_.stars[1].point;
        const Scalar depth = (rotation_ * line.point)[2];
        const Scalar difference = (rotation_ * point)[2] - depth;
        const V between = difference * x[2] * y + depth * y[2] * x;
        const Scalar factor = x[2] * y[2];
        values_.push_back(bilinear<Scalar>(between, between) -
                          factor * factor * bilinear<Scalar>(point, point));
    }

    /// Item 2 of the equations of FORMAT.
    void add_reduced_minor() {
        const auto& line = scene_.lines[1];
        const Scalar a = line.direction[0], b = line.direction[1], h = line.point[2];
        const V& l = line.image;
        const auto [D, x, E, y] = two_rays();
        const Scalar c = rotation_(0, 0), s = rotation_(1, 0);
        const Scalar s2 = rotation_(2, 1), c2 = rotation_(2, 2);
        const Scalar along = l[0] * c + l[1] * s;
        const Scalar g = h * E[1] * (b * (l[0] * s - l[1] * c) - a * along * c2) +
                         h * E[2] * (b * l[2] + a * along * s2);
        const V xy = bilinear_cross<Scalar>(x, y);
        const V ED = bilinear_cross<Scalar>(E, D);
        values_.push_back(g * turned(xy, D) - b * y[2] * conditions_[1].free * turned(x, ED) -
                          b * conditions_[2].free * linear_minor(0, 1, 3) +
                          b * conditions_[3].free * linear_minor(0, 1, 2));
    }

    /// The direction and image of the first ray, then those of the second.
    std::array<V, 4> two_rays() const {
        const auto& first = scene_.groups.front().rays.front();
        const auto& second = scene_.groups.back().rays.back();
        return {first.direction, first.image, second.direction, second.image};
    }

    Scalar linear_minor(std::size_t i, std::size_t j, std::size_t k) const {
        return determinant<Scalar>(conditions_[i].linear, conditions_[j].linear,
                                   conditions_[k].linear);
    }

    Scalar minor(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
        return conditions_[l].free * linear_minor(i, j, k) -
               conditions_[k].free * linear_minor(i, j, l) +
               conditions_[j].free * linear_minor(i, k, l) -
               conditions_[i].free * linear_minor(j, k, l);
    }

    const Scene& scene_;
    bounds::Frame frame_;
    Eigen::Matrix<Scalar, 3, 3> rotation_;
    std::vector<Condition<Scalar>> conditions_;
    std::vector<Scalar> values_;
};

} // namespace

template <class Scalar>
std::vector<Scalar> equation_values(const KnownScene<Scalar>& scene, bounds::Frame frame,
                                    const Eigen::Matrix<Scalar, 3, 3>& rotation) {
    return Values<Scalar>(scene, frame, rotation).take();
}

template std::vector<double> equation_values(const KnownScene<double>&, bounds::Frame,
                                             const Eigen::Matrix3d&);
template std::vector<Complex> equation_values(const KnownScene<Complex>&, bounds::Frame,
                                              const Eigen::Matrix3cd&);

Eigen::Vector3cd translation(const KnownScene<Complex>& scene, const Eigen::Matrix3cd& rotation) {
    const Values<Complex> values(scene, bounds::Frame::general, rotation);
    const auto rows = static_cast<Eigen::Index>(values.conditions().size());
    Eigen::MatrixX3cd linear(rows, 3);
    Eigen::VectorXcd free(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto& condition = values.conditions()[static_cast<std::size_t>(row)];
        const double size = condition.linear.norm();
        linear.row(row) = condition.linear.transpose() / size;
        free[row] = condition.free / size;
    }
    return linear.colPivHouseholderQr().solve(-free);
}

} // namespace plprove
