// A straight way between two images, ready for the path tracker.
#pragma once

#include "prover/many_views/system.h"
#include "prover/many_views/tracking/tracked_way.h"

#include <deque>

namespace plprove::many_views {

/// The equations of a system for images that move from `from` to `to`, in the plain arrays of the
/// tracker.
class Way {
public:
    Way(const System& system, const Images<Complex>& from, const Images<Complex>& to);
    Way(const Way&) = delete;
    Way& operator=(const Way&) = delete;

    const TrackedWay& tracked() const { return way_; }

private:
    using Coefficients = std::vector<std::array<double, 2>>;

    void add_entries(const CameraModel& model);
    void add_camera(const System& system, std::size_t view);
    TrackedPolynomial add(const Polynomial& polynomial);
    int place_of(const Incidence<Polynomial>& equation);

    TrackedWay way_;
    std::vector<TrackedEntry> entries_;
    std::vector<TrackedCamera> cameras_;
    std::vector<TrackedPlace> places_;
    std::vector<std::pair<Vector<Polynomial>, std::vector<Polynomial>>> known_places_;
    // What the plain arrays point to: the elements of a deque stay where they are.
    std::deque<Coefficients> coefficients_;
    std::deque<NumberPolynomial> polynomials_;
    std::deque<std::vector<TrackedMonomial>> monomials_;
    std::deque<std::vector<TrackedEquation>> equations_;
    std::deque<std::vector<TrackedBasisEntry>> bases_;
    std::deque<std::vector<int>> unknowns_;
    std::deque<std::vector<TrackedPolynomial>> factors_;
};

} // namespace plprove::many_views
