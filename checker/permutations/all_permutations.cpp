#include "checker/permutations/all_permutations.h"

#include "checker/permutations/general_pairs.h"

namespace checker {
namespace {
/// What is left to choose of a feature's images when all else is fixed: proofs/all_permutations.md
/// calls these conditions free.
struct FreeConditions {
    std::array<std::size_t, 3> epipolar{}; // by the pairs of `view_pairs`
    /// Of features `a/P/Pa`, by the view that does not see the point: places of trifocal features.
    std::array<std::vector<std::size_t>, 3> image{};
    std::array<std::size_t, 3> incidence{}; // of features `P/a/a`, by the view that sees the point

    std::size_t incidences() const { return incidence[0] + incidence[1] + incidence[2]; }
    std::size_t count() const {
        std::size_t sum = incidences();
        for (std::size_t i = 0; i < 3; ++i)
            sum += epipolar[i] + image[i].size();
        return sum;
    }
};

/// A feature that fixes a trifocal tensor.
struct TrifocalFeature {
    std::vector<Motion> conditions{}; // those that are not free
    std::vector<Motion> image{}; // how the image of its point moves where a free one asks for it
};

std::array<std::size_t, 2> views_of(std::size_t pair) {
    return {pair == 2 ? 1U : 0U, pair == 0 ? 1U : 2U};
}

/// The steps of the proof, for one problem.
class Proof {
public:
    explicit Proof(const Signature& signature) : signature_(signature) {}

    bool succeeds() {
        return place_core() && place_pins() && place_lines_with_two_points() &&
               place_points_in_two_views() && free_.count() > 0 && pairs_are_irreducible() &&
               free_conditions_are_independent() && solutions_differ();
    }

private:
    using Normals = std::array<ResidueVector, 3>;

    /// Calls a function for each feature, as often as it occurs, until one fails.
    template <class Accept, class Place> bool for_each(Accept accept, Place place) {
        for (std::size_t f = 0; f < feature_count; ++f)
            for (unsigned i = 0; accept(features[f]) && i < signature_[f]; ++i)
                if (!place(features[f])) return false;
        return true;
    }

    static bool is_star(const Feature& feature) { return feature.point == all_views; }
    static bool is_seen_twice(const Feature& feature) { return std::popcount(feature.point) == 2; }
    static bool is_line_with_two_points(const Feature& feature) {
        return is_seen_twice(feature) && feature.pins == 1 && feature.pin[0] == all_views;
    }

    bool cut(std::vector<Motion>& conditions, const Motion& one, const Motion& other) {
        conditions.push_back(one);
        return cameras_.cut(one, other);
    }

    bool keep(std::vector<Motion>& conditions, const Motion& condition) {
        conditions.push_back(condition);
        return cameras_.add(condition);
    }

    /// Points with their images, and free lines: section 3.
    bool place_core() {
        const auto is_line = [](const Feature& feature) { return feature.free_line; };
        std::vector<std::pair<ResidueVector, Normals>> lines;
        const bool directions = for_each(is_line, [&](const Feature&) {
            const ResidueVector point = drawn_.vector();
            const Normals normals = views_.planes(drawn_, point);
            lines.emplace_back(point, normals);
            // Another plane of view 3 that is parallel to the line.
            Normals others = normals;
            others[2] = drawn_.normal_to(cross(normals[0], normals[1]));
            return cut(trifocal_.emplace_back().conditions,
                       MovingViews::pencil(normals).derivatives,
                       MovingViews::pencil(others).derivatives);
        });
        if (!directions) return false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto& [point, normals] = lines[i];
            const Equation meet =
                views_.incidence(views_.ray(0, point), {1, normals[1]}, {2, normals[2]});
            if (!keep(trifocal_[i].conditions, meet.derivatives)) return false;
        }
        return for_each(is_star, [&](const Feature& feature) {
            const ResidueVector point = drawn_.vector();
            stars_.push_back({point, trifocal_.size(), feature.pins});
            auto& conditions = trifocal_.emplace_back().conditions;
            const Seen first = views_.ray(0, point);
            return keep(conditions, views_.epipolar(first, views_.ray(1, point)).derivatives) &&
                   keep(conditions, views_.epipolar(first, views_.ray(2, point)).derivatives) &&
                   keep(conditions, views_
                                        .incidence(first, views_.plane(drawn_, 1, point),
                                                   views_.plane(drawn_, 2, point))
                                        .derivatives);
        });
    }

    bool place_pins() {
        for (const auto& [point, place, pins] : stars_)
            for (unsigned pin = 0; pin < pins; ++pin) {
                std::array<std::array<ResidueVector, 2>, 3> normals;
                for (std::size_t view = 0; view < 3; ++view)
                    for (ResidueVector& normal : normals[view])
                        normal = views_.plane(drawn_, view, point).vector;
                if (!pin_is_general(normals, cameras_, drawn_)) return false;
                const Equation pencil = MovingViews::pencil(views_.planes(drawn_, point));
                if (!keep(trifocal_[place].conditions, pencil.derivatives)) return false;
            }
        return true;
    }

    /// The point of `a/Pa/Pa` and `a/P/Pa`, in the two views that see it.
    bool place_point(std::vector<Motion>& conditions, const ResidueVector& point, std::size_t i,
                     std::size_t j) {
        const Seen first = views_.ray(i, point), second = views_.ray(j, point);
        // Another point of view j on the epipolar line.
        const Seen other{j, plus(second.vector, times(drawn_.number(), views_.baseline(i, j)))};
        return cut(conditions, views_.epipolar(first, second).derivatives,
                   views_.epipolar(first, other).derivatives);
    }

    /// The bilinear form of the directions that views i and j see of a line through the point,
    /// where view u sees this line.
    BilinearForm form_of_line(const ResidueVector& point, std::size_t i, std::size_t j,
                              std::size_t u, const ResidueVector& seen) {
        BilinearForm form;
        const ResidueVector first[2] = {views_.plane(drawn_, i, point).vector,
                                        views_.plane(drawn_, i, point).vector};
        const ResidueVector second[2] = {views_.plane(drawn_, j, point).vector,
                                         views_.plane(drawn_, j, point).vector};
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b) {
                Normals normals;
                normals[u] = seen;
                normals[i] = first[a];
                normals[j] = second[b];
                form[a][b] = MovingViews::pencil(normals);
            }
        return form;
    }

    bool place_lines_with_two_points() {
        return for_each(is_line_with_two_points, [&](const Feature& feature) {
            const auto [i, j, u] = seen_and_unseen(feature);
            const ResidueVector point = drawn_.vector();
            const Normals line = views_.planes(drawn_, point);
            auto& conditions = trifocal_.emplace_back().conditions;
            const Seen auxiliary = views_.plane(drawn_, j, point);
            return place_point(conditions, point, i, j) &&
                   cut(conditions,
                       views_.incidence(views_.ray(i, point), auxiliary, {u, line[u]}).derivatives,
                       views_
                           .incidence(views_.ray(i, point), auxiliary,
                                      views_.plane(drawn_, u, point))
                           .derivatives) &&
                   line_is_general(form_of_line(point, i, j, u, line[u]), cameras_, drawn_) &&
                   keep(conditions, MovingViews::pencil(line).derivatives);
        });
    }

    bool place_points_in_two_views() {
        const auto accept = [](const Feature& feature) {
            return is_seen_twice(feature) && feature.pins == 1 && !is_line_with_two_points(feature);
        };
        const bool placed = for_each(accept, [&](const Feature& feature) {
            const auto [i, j, u] = seen_and_unseen(feature);
            const ResidueVector point = drawn_.vector();
            const Seen auxiliary = views_.plane(drawn_, j, point);
            const auto image = [&, ray = views_.ray(i, point), u = u] {
                return views_.incidence(ray, auxiliary, views_.plane(drawn_, u, point)).derivatives;
            };
            free_.image[u].push_back(trifocal_.size());
            auto& [conditions, moves] = trifocal_.emplace_back();
            moves = {image(), image()};
            return place_point(conditions, point, i, j);
        });
        for (std::size_t f = 0; f < feature_count; ++f) {
            const Feature& feature = features[f];
            for (std::size_t pair = 0; pair < 3; ++pair)
                if (feature.point == view_pairs[pair] && feature.pins == 0)
                    free_.epipolar[pair] += signature_[f];
            if (!feature.free_line && std::popcount(feature.point) == 1)
                free_.incidence[first_of(feature.point)] += signature_[f];
        }
        return placed;
    }

    bool pairs_are_irreducible() {
        const Motion motion = cameras_.motion(drawn_);
        for (std::size_t pair = 0; pair < 3; ++pair) {
            const auto [i, j] = views_of(pair);
            if (free_.epipolar[pair] > 0 && !epipolar_form_is_general(views_, i, j, motion))
                return false;
        }
        for (std::size_t view = 0; view < 3; ++view)
            if (free_.incidence[view] > 0 && !tensor_is_general(views_, view, motion, drawn_))
                return false;
        return true;
    }

    /// Adds what the chosen free conditions know of the cameras. Returns how many these are.
    std::size_t add_free(Echelon& known, unsigned pairs,
                         const std::array<std::size_t, 3>& images) const {
        std::size_t count = 0;
        for (std::size_t pair = 0; pair < 3; ++pair) {
            if (!has_view(pairs, pair) || free_.epipolar[pair] == 0) continue;
            const auto [i, j] = views_of(pair);
            known.add_all(views_.relative_pose(i, j));
            count += free_.epipolar[pair];
        }
        for (std::size_t view = 0; view < 3; ++view)
            for (std::size_t k = 0; k < images[view]; ++k) {
                known.add_all(trifocal_[free_.image[view][k]].image);
                ++count;
            }
        return count;
    }

    /// Some free conditions, but not all, know more numbers of the cameras than they are (Theorem
    /// S, condition b). Conditions P/a/a know all.
    bool free_conditions_are_independent() const {
        std::array<std::size_t, 3> images{};
        for (unsigned pairs = 0; pairs < 8; ++pairs)
            for (images[0] = 0; images[0] <= free_.image[0].size(); ++images[0])
                for (images[1] = 0; images[1] <= free_.image[1].size(); ++images[1])
                    for (images[2] = 0; images[2] <= free_.image[2].size(); ++images[2]) {
                        Echelon known = cameras_;
                        const std::size_t count = add_free(known, pairs, images);
                        const bool proper = count > 0 && count < free_.count();
                        if (proper && known.size() - cameras_.size() <= count) return false;
                    }
        return true;
    }

    /// No two cameras agree in all that the free conditions know (Lemma 7).
    bool solutions_differ() const {
        const bool all_pairs =
            free_.epipolar[0] > 0 && free_.epipolar[1] > 0 && free_.epipolar[2] > 0;
        if (free_.incidences() > 0 || all_pairs) return true;
        return std::ranges::any_of(trifocal_,
                                   [&](const auto& feature) { return is_determined(feature); });
    }

    /// Whether what is known without this feature determines the cameras, up to finitely many.
    bool is_determined(const TrifocalFeature& without) const {
        Echelon known;
        for (const TrifocalFeature& feature : trifocal_) {
            if (&feature == &without) continue;
            known.add_all(feature.conditions);
            known.add_all(feature.image);
        }
        add_free(known, all_views, {});
        return known.size() == camera_unknowns;
    }

    static std::size_t first_of(Views views) {
        return static_cast<std::size_t>(std::countr_zero(views));
    }

    /// The two views that see the point, and the one that does not.
    static std::array<std::size_t, 3> seen_and_unseen(const Feature& feature) {
        const std::size_t first = first_of(feature.point);
        return {first, first_of(feature.point & (feature.point - 1)),
                first_of(all_views ^ feature.point)};
    }

    struct Star {
        ResidueVector point{};
        std::size_t place = 0; // among the trifocal features
        unsigned pins = 0;
    };

    const Signature& signature_;
    Drawn drawn_{};
    MovingViews views_{drawn_};
    Echelon cameras_{}; // the conditions that are not free
    std::vector<Star> stars_{};
    std::vector<TrifocalFeature> trifocal_{};
    FreeConditions free_{};
};
} // namespace

bool has_all_permutations(const Signature& signature) {
    return Proof(signature).succeeds();
}
} // namespace checker
