#include "prover/many_views/incidences.h"

namespace plprove::many_views {

namespace {

template <class Scalar>
Vector<Scalar> cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A line through the image point and another one, which is always the same.
template <class Scalar>
Vector<Scalar> line_through(const Vector<Scalar>& point, const Vector<Complex>& other) {
    return cross(point, {Scalar(other[0]), Scalar(other[1]), Scalar(other[2])});
}

constexpr Vector<Complex> first_other{Complex(0.61, 0.32), Complex(-0.24, 0.55),
                                      Complex(0.38, -0.17)};
constexpr Vector<Complex> second_other{Complex(-0.13, 0.44), Complex(0.52, 0.29),
                                       Complex(0.21, 0.63)};

/// Where in space points are, as view 1 shows it.
template <class Scalar>
struct Places {
    std::vector<Vector<Scalar>> x;
    std::vector<std::vector<Scalar>> depth;
};

template <class Scalar>
class Equations {
public:
    Equations(const Problem& problem, const Images<Scalar>& images)
        : problem_(problem), images_(images), depths_(unknown_depths(problem)) {
        place_points();
    }

    std::vector<Incidence<Scalar>> take() {
        for (std::size_t view = 1; view < images_.size(); ++view) {
            const auto seen = image_vectors(problem_, images_[view]);
            for (std::size_t p = 0; p < seen.size(); ++p)
                add_point(view, p, seen[p]);
            std::size_t unknown = first_of_lines_;
            for (std::size_t line = 0; line < problem_.lines.size(); ++line)
                unknown += add_line(view, line, seen, unknown);
        }
        return std::move(incidences_);
    }

private:
    std::vector<Scalar> one_depth(std::size_t unknown) const {
        std::vector<Scalar> depth(depths_);
        depth[unknown] = Scalar(Complex(1));
        return depth;
    }

    void place_points() {
        places_.x = image_vectors(problem_, images_[0]);
        for (std::size_t p = 0; p < places_.x.size(); ++p) {
            const auto carrier = plprove::carrier(problem_, static_cast<int>(p));
            if (!carrier) {
                places_.depth.push_back(one_depth(first_of_lines_++));
                continue;
            }
            const auto& on_it = problem_.lines[static_cast<std::size_t>(*carrier)].points;
            const auto& a = places_.depth[static_cast<std::size_t>(on_it[0])];
            const auto& b = places_.depth[static_cast<std::size_t>(on_it[1])];
            const Vector<Scalar>& factors = images_[0].points[p];
            std::vector<Scalar> depth(depths_);
            for (std::size_t k = 0; k < depths_; ++k)
                depth[k] = factors[0] * a[k] + factors[1] * b[k];
            places_.depth.push_back(depth);
        }
    }

    /// The view sees the point at y: two equations, or one where the line through it that two
    /// earlier points fix is seen as well.
    void add_point(std::size_t view, std::size_t p, const Vector<Scalar>& y) {
        const auto add = [&](const Vector<Complex>& other) {
            incidences_.push_back({view, line_through(y, other), places_.x[p], places_.depth[p]});
        };
        add(first_other);
        if (!carrier(problem_, static_cast<int>(p))) add(second_other);
    }

    /// The view sees the line. Returns how many depths are its own.
    std::size_t add_line(std::size_t view, std::size_t line,
                         const std::vector<Vector<Scalar>>& seen, std::size_t unknown) {
        const auto& points = problem_.lines[line].points;
        if (points.size() >= 2) return 0;
        const auto& in_view = images_[view].lines[line];
        const auto& in_first = images_[0].lines[line];
        if (points.size() == 1) {
            const Vector<Scalar> l =
                cross(seen[static_cast<std::size_t>(points.front())], in_view[1]);
            incidences_.push_back({view, l, in_first[1], one_depth(unknown)});
            return 1;
        }
        const Vector<Scalar> l = cross(in_view[0], in_view[1]);
        incidences_.push_back({view, l, in_first[0], one_depth(unknown)});
        incidences_.push_back({view, l, in_first[1], one_depth(unknown + 1)});
        return 2;
    }

    const Problem& problem_;
    const Images<Scalar>& images_;
    std::size_t depths_;
    std::size_t first_of_lines_ = 0; // of the depths that belong to lines
    Places<Scalar> places_;
    std::vector<Incidence<Scalar>> incidences_;
};

} // namespace

std::size_t unknown_depths(const Problem& problem) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        count += carrier(problem, static_cast<int>(p)) ? 0 : 1;
    for (const Line& line : problem.lines)
        count += static_cast<std::size_t>(own_points(line));
    return count;
}

std::vector<Incidence<Moving>> incidences(const Problem& problem, const Images<Moving>& images) {
    return Equations(problem, images).take();
}

std::vector<Incidence<Polynomial>> incidences(const Problem& problem,
                                              const Images<Polynomial>& images) {
    return Equations(problem, images).take();
}

} // namespace plprove::many_views
