#include "checker/general_bounds/upright_views.h"

#include "checker/general_bounds/valuations.h"

#include <algorithm>
#include <array>
#include <random>

namespace checker {
namespace {
constexpr unsigned views = 3;
constexpr unsigned tries = 20;

/// What a view sees of a point.
enum class Sight { nothing, line, point };

using Sights = std::array<Sight, views>;

/// What views see of a point and the lines through it, or of a line.
struct Observed {
    Sights sights{};
    std::size_t pencils = 0; // lines through the point that all views see
    bool is_line = false;    // a line that all views see, and no more
};

bool sees_all(const Line& line) {
    return std::popcount(line.seen_by) == int{views};
}

Observed observed(const Problem& problem, const Point& point) {
    Observed result;
    for (const std::size_t line : point.lines)
        if (sees_all(problem.lines[line])) ++result.pencils;
    for (unsigned view = 0; view < views; ++view) {
        const auto sees = [&](Views seen_by) { return (seen_by >> view & 1) != 0; };
        if (sees(point.seen_by))
            result.sights[view] = Sight::point;
        else if (std::ranges::any_of(point.lines, [&](std::size_t line) {
                     return sees(problem.lines[line].seen_by);
                 }))
            result.sights[view] = Sight::line; // just one, or it would see the point
    }
    // Of a line in all views, one view may choose the point.
    result.is_line = result.pencils == 1 && std::ranges::count(result.sights, Sight::point) <= 1;
    return result;
}

/// How many conditions this puts on the cameras.
std::ptrdiff_t weight(const Observed& object) {
    if (object.is_line) return 2;
    const auto rays = std::ranges::count(object.sights, Sight::point);
    const auto planes = std::ranges::count(object.sights, Sight::line);
    const auto of_point = std::max(std::ptrdiff_t{0}, 2 * rays + planes - 3);
    return of_point + static_cast<std::ptrdiff_t>(object.pencils);
}

/// What puts conditions on the cameras.
std::vector<Observed> all_observed(const Problem& problem) {
    std::vector<Observed> all;
    for (const Point& point : problem.points)
        all.push_back(observed(problem, point));
    for (const Line& line : problem.lines)
        if (line.points.empty() && sees_all(line)) all.push_back({{}, 1, true});
    std::erase_if(all, [](const Observed& object) { return weight(object) == 0; });
    return all;
}

/// Three coordinates, along the isotropic directions and the vertical.
using Coordinates = std::array<Valued, 3>;
using Valuations = std::array<std::int64_t, 3>;

Valued one(std::int64_t valuation = 0) {
    return {{Exponents{}, valuation}};
}

Valued dot(const Coordinates& x, const Coordinates& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// The determinant, or what each of its six terms is.
Valued volume(const Coordinates& x, const Coordinates& y, const Coordinates& z) {
    Valued sum;
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        sum = sum + x[order[0]] * y[order[1]] * z[order[2]];
    } while (std::ranges::next_permutation(order).found);
    return sum;
}

/// The equations of section 1 of the page, for images with random valuations.
class Equations {
public:
    explicit Equations(unsigned seed) : random_(seed) {}

    /// The centres of the views, up to motions of space: before all that needs them.
    void add_centres() {
        for (std::size_t pair = 0; pair < 3; ++pair)
            for (std::size_t a = 0; a < 3; ++a)
                centres_[pair][a] = pair == 0 && a == 0 ? one() : unknown(); // of any size
        for (std::size_t a = 0; a < 3; ++a)
            first_.push_back({Role::relation, centres_[0][a] + centres_[1][a] + centres_[2][a]});
    }

    void add(const Observed& object) {
        const auto points = std::ranges::count(object.sights, Sight::point);
        const auto lines = std::ranges::count(object.sights, Sight::line);
        if (object.is_line)
            add_line();
        else if (points == 2 && lines == 0)
            add_two_rays(object.sights);
        else if (points == 1)
            add_ray_and_planes(object.sights);
        else
            add_point(object);
    }

    /// Three planes share a direction if they are those of one line: for each line of a point.
    void add_pencils(const Observed& object) {
        const std::array<Valuations, views> seen = valuations_by_view();
        for (std::size_t line = 0; line < object.pencils; ++line)
            add_pencil(planes_of_line(object.sights, seen));
    }

    std::optional<std::size_t> solutions() const {
        std::vector<Condition> system = first_;
        std::vector<Condition> middle = middle_;
        std::ranges::stable_sort(middle, [](const Condition& f, const Condition& g) {
            return f.polynomial.size() < g.polynomial.size();
        });
        system.insert(system.end(), middle.begin(), middle.end());
        system.insert(system.end(), last_.begin(), last_.end());
        return solutions_by_valuations(unknowns_, system);
    }

private:
    Valued unknown() { return {{Exponents{{unknowns_++, 1}}, 0}}; }

    Valuations valuations() {
        Valuations all;
        for (std::int64_t& valuation : all)
            valuation = static_cast<std::int64_t>(random_() % 1'000'003);
        return all;
    }

    std::array<Valuations, views> valuations_by_view() {
        std::array<Valuations, views> all;
        for (Valuations& of_view : all)
            of_view = valuations();
        return all;
    }

    /// By how much a view is turned, to a power; the first is not.
    static Valued turned(unsigned view, int power) {
        return view == 0 || power == 0 ? one() : Valued{{Exponents{{view - 1, power}}, 0}};
    }

    /// The direction of a ray.
    static Coordinates ray(unsigned view, const Valuations& v) {
        return {one(v[0]) * turned(view, 1), one(v[1]), one(v[2]) * turned(view, -1)};
    }

    /// The normal of a plane.
    static Coordinates plane(unsigned view, const Valuations& v) {
        return {one(v[0]) * turned(view, -1), one(v[1]), one(v[2]) * turned(view, 1)};
    }

    /// The normal of a plane through a ray: of three numbers that sum to 0 two are as small as any,
    /// and the third is another one in each view.
    Coordinates plane_through(unsigned view, const Valuations& of_ray) {
        Valuations v{-of_ray[0], -of_ray[1], -of_ray[2]};
        v[view] += valuations()[0];
        return plane(view, v);
    }

    /// The planes of a line through a point: a view that does not see the point has seen the plane.
    std::array<Coordinates, views> planes_of_line(const Sights& sights,
                                                  const std::array<Valuations, views>& seen) {
        std::array<Coordinates, views> planes;
        for (unsigned view = 0; view < views; ++view)
            planes[view] = sights[view] == Sight::point ? plane_through(view, seen[view])
                                                        : plane(view, seen[view]);
        return planes;
    }

    void add_pencil(const std::array<Coordinates, views>& planes, Role role = Role::equation) {
        middle_.push_back({role, volume(planes[0], planes[1], planes[2])});
    }

    /// From the centre of one view to that of another.
    const Coordinates& between(unsigned i, unsigned j) const { return centres_[i + j - 1]; }

    static std::vector<unsigned> views_with(const Sights& sights, Sight sight) {
        std::vector<unsigned> found;
        for (unsigned view = 0; view < views; ++view)
            if (sights[view] == sight) found.push_back(view);
        return found;
    }

    void add_two_rays(const Sights& sights) {
        const auto seen = views_with(sights, Sight::point);
        const Coordinates first = ray(seen[0], valuations());
        const Coordinates second = ray(seen[1], valuations());
        middle_.push_back({Role::equation, volume(between(seen[0], seen[1]), first, second)});
    }

    /// A ray meets the line that two planes share.
    void add_ray_and_planes(const Sights& sights) {
        const unsigned i = views_with(sights, Sight::point)[0];
        const unsigned j = views_with(sights, Sight::line)[0];
        const unsigned k = views_with(sights, Sight::line)[1];
        const Coordinates d = ray(i, valuations());
        const Coordinates m = plane(j, valuations());
        const Coordinates n = plane(k, valuations());
        Valued sum;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                sum = sum + m[a] * n[b] *
                                (a == b ? d[a] * between(j, k)[a]
                                        : between(i, j)[a] * d[b] + between(i, k)[b] * d[a]);
        middle_.push_back({Role::equation, sum});
    }

    /// A point that all views see, or two, and the third a line through it.
    void add_point(const Observed& object) {
        const std::array<Valuations, views> seen = valuations_by_view();
        const std::array<Coordinates, views> planes = planes_of_line(object.sights, seen);
        std::array<Coordinates, views> to_point;
        std::array<Coordinates, views> rays;
        for (unsigned view = 0; view < views; ++view) {
            if (object.sights[view] == Sight::point) {
                rays[view] = ray(view, seen[view]);
                const Valued depth = unknown();
                for (std::size_t a = 0; a < 3; ++a)
                    to_point[view][a] = depth * rays[view][a];
            } else {
                for (Valued& coordinate : to_point[view])
                    coordinate = unknown();
            }
        }
        add_triangles(object.sights, to_point, rays);
        for (const unsigned view : views_with(object.sights, Sight::line))
            last_.push_back({Role::equation, dot(planes[view], to_point[view])});
        if (object.pencils > 0) add_pencil(planes);
    }

    /// A point and two centres: those of two rays first. That two rays meet is a consequence.
    void add_triangles(const Sights& sights, const std::array<Coordinates, views>& to_point,
                       const std::array<Coordinates, views>& rays) {
        for (const bool both_seen : {true, false})
            for (unsigned i = 0; i < views; ++i)
                for (unsigned j = i + 1; j < views; ++j) {
                    if (both_seen != (sights[i] == Sight::point && sights[j] == Sight::point))
                        continue;
                    for (std::size_t a = 0; a < 3; ++a)
                        last_.push_back(
                            {Role::relation, between(i, j)[a] + to_point[i][a] + to_point[j][a]});
                    if (both_seen)
                        middle_.push_back(
                            {Role::consequence, volume(between(i, j), rays[i], rays[j])});
                }
    }

    /// Three planes share a line if multiples of their equations sum to 0: the normals do, and so
    /// do the constants.
    void add_line() {
        std::array<Coordinates, views> planes;
        for (unsigned view = 0; view < views; ++view) {
            planes[view] = plane(view, valuations());
            const Valued multiple = view == 0 ? one() : unknown();
            for (Valued& coordinate : planes[view])
                coordinate = multiple * coordinate;
        }
        add_pencil(planes, Role::consequence);
        Valued sum;
        for (std::size_t a = 0; a < 3; ++a) {
            last_.push_back({Role::relation, planes[0][a] + planes[1][a] + planes[2][a]});
            const Valued constant = unknown();
            // Seen from the third centre, and from the second.
            last_.push_back({Role::relation, constant + planes[0][a] * between(0, 2)[a] +
                                                 planes[1][a] * between(1, 2)[a]});
            last_.push_back({Role::relation, constant + planes[0][a] * between(0, 1)[a] +
                                                 planes[2][a] * between(1, 2)[a]});
            sum = sum + constant;
        }
        last_.push_back({Role::equation, sum});
    }

    std::mt19937_64 random_;
    std::size_t unknowns_ = 2; // the turns of two views
    std::array<Coordinates, 3> centres_{};
    // In the order in which a search takes them.
    std::vector<Condition> first_{};
    std::vector<Condition> middle_{};
    std::vector<Condition> last_{};
};
} // namespace

std::optional<std::size_t> degree_in_upright_views(const Problem& problem) {
    const auto is_joined = [](const Line& line) { return line.points.size() > 1; };
    if (problem.cameras->name != "upright" || problem.view_count() != int{views} ||
        std::ranges::any_of(problem.lines, is_joined))
        return std::nullopt;
    const std::vector<Observed> all = all_observed(problem);
    std::ptrdiff_t weights = 0;
    std::size_t pencils = 0;
    for (const Observed& object : all) {
        weights += weight(object);
        pencils += object.pencils;
    }
    if (weights != 7) return std::nullopt;
    // Two pencils fix how the views are turned; the centres solve linear equations.
    const bool turns_only = pencils == 2;
    for (unsigned seed = 1; seed <= tries && pencils <= 2; ++seed) {
        Equations equations(seed);
        if (!turns_only) equations.add_centres();
        for (const Observed& object : all)
            turns_only ? equations.add_pencils(object) : equations.add(object);
        if (const auto solutions = equations.solutions()) return solutions;
    }
    return std::nullopt;
}
} // namespace checker
