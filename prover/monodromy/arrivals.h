// The solutions at the integer images of a certificate, as they arrive there: each real one once,
// and one of each two that are conjugate.
#pragma once

#include "prover/monodromy/solution_set.h"
#include "prover/monodromy/starting_values.h"

#include <utility>

namespace plprove {

/// A Point is a range of complex numbers.
template <class Point>
class Arrivals {
public:
    /// `seen` says when two approximations are of one solution; it is empty.
    explicit Arrivals(SolutionSet<Point> seen) : seen_(std::move(seen)) {}

    bool has(const Point& point) const { return seen_.find(point).has_value(); }

    /// Adds a solution that it has not yet.
    void add(Point point, bool real) {
        if (real)
            for (std::complex<double>& x : point)
                x = x.real();
        seen_.add(point);
        if (!real) seen_.add(conjugate(point));
        found_.push_back({std::move(point), real});
    }

    /// How many there are; one that is not real counts twice.
    int size() const { return seen_.size(); }

    /// The starting values of all, in the order of their first coordinates. `coordinates` of a
    /// point are those in the file; `bits_of` says of each of some points how many bits after the
    /// binary point are enough. Where it says 0, the solution is left out.
    template <class Coordinates, class BitsOf>
    std::vector<StartingValues> written(const Coordinates& coordinates, const BitsOf& bits_of) {
        std::ranges::sort(found_, {}, [&](const Found& solution) {
            const std::complex<double> first = coordinates(solution.point)[0];
            return std::pair(first.real(), std::abs(first.imag()));
        });
        std::vector<Point> points;
        for (const Found& solution : found_)
            points.push_back(solution.point);
        const std::vector<int> bits = bits_of(points);
        std::vector<StartingValues> result;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (bits[i] > 0)
                result.push_back(starting_values(coordinates(points[i]), found_[i].real, bits[i]));
        return result;
    }

private:
    struct Found {
        Point point;
        bool real = false;
    };

    static Point conjugate(Point point) {
        for (std::complex<double>& x : point)
            x = std::conj(x);
        return point;
    }

    SolutionSet<Point> seen_;
    std::vector<Found> found_;
};

} // namespace plprove
