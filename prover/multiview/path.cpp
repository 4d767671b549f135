#include "prover/multiview/path.h"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <deque>
#include <thread>

namespace plprove::multiview {

namespace {

struct Settings {
    double prediction = 1e-3;  ///< relative error that the step size aims at
    double contraction = 0.05; ///< Newton's second correction is at most that much of the first
    double largest_step = 0.2;
    int most_steps = 2000;
};

Settings settings_for(Care care) {
    if (care == Care::usual) return {};
    return {.prediction = 1e-6, .contraction = 0.005, .largest_step = 0.05, .most_steps = 20000};
}

constexpr double noise = 1e-6; // smaller corrections may be rounding, near degenerate images
constexpr double first_step = 0.01;
constexpr double smallest_step = 1e-10;

struct Place {
    double time = 0;
    Point point, speed;
};

double relative_size(const Point& change, const Point& point) {
    return change.norm() / (1 + point.norm());
}

/// Hermite extrapolation from the last places, the newest first: of order 1, 3 or 5.
Point predicted(const std::deque<Place>& places, double time) {
    const Place& p = places[0];
    const double s = time - p.time;
    if (places.size() == 1) return p.point + s * p.speed;
    const Place& q = places[1];
    const double a = p.time - q.time;
    const Point slope = (p.point - q.point) / a;
    const Point d001 = (p.speed - slope) / a, d011 = (slope - q.speed) / a;
    const Point d0011 = (d001 - d011) / a;
    Point sum = p.point + s * p.speed + s * s * d001 + s * s * (s + a) * d0011;
    if (places.size() == 2) return sum;
    const Place& r = places[2];
    const double b = p.time - r.time, c = q.time - r.time;
    const Point slope12 = (q.point - r.point) / c;
    const Point d112 = (q.speed - slope12) / c, d122 = (slope12 - r.speed) / c;
    const Point d0112 = (d011 - d112) / b, d1122 = (d112 - d122) / c;
    const Point d00112 = (d0011 - d0112) / b, d01122 = (d0112 - d1122) / b;
    const Point d001122 = (d00112 - d01122) / b;
    const double w4 = s * s * (s + a) * (s + a);
    return sum + w4 * d00112 + w4 * (s + b) * d001122;
}

class Follower {
public:
    Follower(const System& system, const Images<Complex>& from, const Images<Complex>& to,
             const Settings& settings)
        : system_(system), from_(from), to_(to), settings_(settings) {}

    std::optional<Point> run(const Point& start) {
        Place place{0, start, {}};
        if (!correct(place)) return std::nullopt;
        places_.push_front(place);
        double step = first_step;
        for (int attempt = 0; attempt < settings_.most_steps && step > smallest_step; ++attempt) {
            place.time = std::min(1.0, places_[0].time + step);
            place.point = predicted(places_, place.time);
            const bool good = correct(place);
            step = std::min(settings_.largest_step, step * factor(good));
            if (!good) continue;
            places_.push_front(place);
            if (places_.size() > 3) places_.pop_back();
            if (place.time >= 1) return polished(place);
        }
        return std::nullopt;
    }

private:
    /// Two corrections by Newton's method; the speed is that after the first. Returns whether they
    /// are small enough.
    bool correct(Place& place) {
        const Images<Moving> images = on_the_way(from_, to_, place.time);
        first_ = newton(images, place);
        second_ = newton(images, place);
        place.speed = -lu_.solve(evaluation_.speeds);
        return first_ < 8 * settings_.prediction &&
               (second_ < noise || second_ < settings_.contraction * first_);
    }

    double newton(const Images<Moving>& images, Place& place) {
        system_.evaluate(images, place.point, evaluation_);
        lu_.compute(evaluation_.jacobian);
        const Point change = lu_.solve(evaluation_.values);
        place.point -= change;
        return relative_size(change, place.point);
    }

    /// How the step changes: both the prediction and the contraction are to stay in their limits.
    double factor(bool good) const {
        double ratio = settings_.prediction / (first_ + 1e-20);
        if (second_ >= noise) ratio = std::min(ratio, settings_.contraction * first_ / second_);
        if (!(ratio < 1e40)) ratio = good ? 1e40 : 0;
        const double order = places_.size() == 3 ? 6 : places_.size() == 2 ? 4 : 2;
        if (good) return std::clamp(0.9 * std::pow(ratio, 1 / order), 0.3, 2.5);
        return std::clamp(0.7 * std::pow(ratio, 1 / order), 0.1, 0.5);
    }

    std::optional<Point> polished(Place place) {
        const Images<Moving> images = on_the_way(from_, to_, 1);
        for (int step = 0; step < 3; ++step)
            if (newton(images, place) < 1e-14) break;
        if (!place.point.allFinite()) return std::nullopt;
        return place.point;
    }

    const System& system_;
    const Images<Complex>& from_;
    const Images<Complex>& to_;
    Settings settings_;
    std::deque<Place> places_;
    Evaluation evaluation_;
    Eigen::PartialPivLU<Eigen::MatrixXcd> lu_;
    double first_ = 0, second_ = 0;
};

} // namespace

std::optional<Point> follow(const System& system, const Images<Complex>& from,
                            const Images<Complex>& to, const Point& start, Care care) {
    return Follower(system, from, to, settings_for(care)).run(start);
}

std::vector<std::optional<Point>> follow_all(const System& system, const Images<Complex>& from,
                                             const Images<Complex>& to,
                                             const std::vector<Point>& starts, Care care,
                                             int threads) {
    std::vector<std::optional<Point>> ends(starts.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < starts.size(); i = next++)
            ends[i] = follow(system, from, to, starts[i], care);
    };
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < threads; ++thread)
        helpers.emplace_back(work);
    work();
    helpers.clear();
    return ends;
}

} // namespace plprove::multiview
