#include "checker/permutations/five_shared_points.h"

#include "checker/minimal/obstruction.h"
#include "checker/permutations/general_pairs.h"

namespace checker {
namespace {
/// Two views whose relative pose is known, and the third one.
struct Pair {
    std::size_t i = 0, j = 0, u = 0;
};

Pair pair_of(Views views) {
    const auto place = [](Views some) { return static_cast<std::size_t>(std::countr_zero(some)); };
    return {place(views), place(views & (views - 1)), place(all_views ^ views)};
}

/// What the images say of the third camera, if the pose of the two others is known: the table of
/// section 1 of the page.
struct ThirdView {
    std::vector<unsigned> points{}; // known points with their images: how many pins
    unsigned lines = 0;             // known lines with their images
    unsigned incidences = 0; // images of lines through known points, or of points of known lines
    std::array<unsigned, 2> epipolar = {}; // images of points that view i sees, or view j
};

ThirdView third_view(const Signature& signature, const Pair& pair) {
    ThirdView result;
    for (std::size_t f = 0; f < feature_count; ++f)
        for (unsigned n = 0; n < signature[f]; ++n) {
            const Feature& feature = features[f];
            const bool seen_by_u = has_view(feature.point, pair.u);
            const bool shared = has_view(feature.point, pair.i) && has_view(feature.point, pair.j);
            const bool line_in_all = feature.pins == 1 && feature.pin[0] == all_views;
            if (feature.free_line)
                ++result.lines;
            else if (feature.point == all_views)
                result.points.push_back(feature.pins);
            else if (std::popcount(feature.point) == 1)
                ++result.incidences;
            else if (shared && feature.pins == 1)
                ++(line_in_all ? result.lines : result.incidences);
            else if (seen_by_u && feature.pins == 1)
                result.points.push_back(line_in_all ? 1 : 0);
            else if (seen_by_u)
                ++result.epipolar[has_view(feature.point, pair.i) ? 0 : 1];
        }
    return result;
}

/// The steps of the proof, for one problem.
class ProofForThirdView {
public:
    ProofForThirdView(const Pair& pair, const ThirdView& third) : pair_(pair), third_(third) {
        cameras_.add_all(views_.relative_pose(pair.i, pair.j));
    }

    bool succeeds() {
        const std::size_t points = third_.points.size(), lines = third_.lines;
        const bool core = 2 * points + lines <= 3 || (points == 2 && lines == 0);
        return one_camera_fits() && core && place_lines() && place_points() &&
               pairs_are_irreducible() && free_conditions_are_independent();
    }

private:
    /// Whether only one camera has the images of all conditions, and of the free ones whatever is
    /// known of it: the whole camera; or its essential matrices with both views, or with one, and a
    /// line or two objects besides (Proposition P1).
    bool one_camera_fits() const {
        std::size_t objects = third_.points.size();
        for (const unsigned pins : third_.points)
            objects += pins;
        const auto& [first, second] = third_.epipolar;
        return third_.incidences > 0 || (first > 0 && second > 0) ||
               (first + second > 0 && (third_.lines > 0 || objects > 1));
    }

    /// The image of a known point is on a line.
    Motion image_of(const ResidueVector& point) {
        return views_
            .incidence(views_.ray(pair_.i, point), views_.plane(drawn_, pair_.j, point),
                       views_.plane(drawn_, pair_.u, point))
            .derivatives;
    }

    bool place_lines() {
        std::vector<Motion> meets;
        for (unsigned n = 0; n < third_.lines; ++n) {
            const ResidueVector point = drawn_.vector();
            const auto normals = views_.planes(drawn_, point);
            auto others = normals; // another plane of view u that is parallel to the line
            others[pair_.u] = drawn_.normal_to(cross(normals[pair_.i], normals[pair_.j]));
            if (!cameras_.cut(MovingViews::pencil(normals).derivatives,
                              MovingViews::pencil(others).derivatives))
                return false;
            meets.push_back(views_
                                .incidence(views_.ray(pair_.i, point), {pair_.j, normals[pair_.j]},
                                           {pair_.u, normals[pair_.u]})
                                .derivatives);
        }
        return cameras_.add_all(meets) == meets.size();
    }

    bool place_points() {
        std::vector<ResidueVector> points;
        for (std::size_t n = 0; n < third_.points.size(); ++n) {
            const ResidueVector& point = points.emplace_back(drawn_.vector());
            if (!cameras_.add(image_of(point)) || !cameras_.add(image_of(point))) return false;
        }
        for (std::size_t n = 0; n < points.size(); ++n)
            for (unsigned pin = 0; pin < third_.points[n]; ++pin) {
                const std::array normals{views_.plane(drawn_, pair_.u, points[n]).vector,
                                         views_.plane(drawn_, pair_.u, points[n]).vector};
                if (!known_pin_is_general(normals, pair_.u, cameras_, drawn_) ||
                    !cameras_.add(
                        MovingViews::pencil(views_.planes(drawn_, points[n])).derivatives))
                    return false;
            }
        return true;
    }

    std::size_t partner(std::size_t t) const { return t == 0 ? pair_.i : pair_.j; }

    bool pairs_are_irreducible() {
        const Motion motion = cameras_.motion(drawn_);
        // An axis that is isotropic would not do (Lemma P2).
        const ResidueVector turn = minus(turn_of(pair_.u, motion), turn_of(pair_.i, motion));
        if (dot(turn, turn) == Residue{}) return false;
        for (std::size_t t = 0; t < 2; ++t)
            if (third_.epipolar[t] > 0 &&
                !epipolar_form_is_general(views_, partner(t), pair_.u, motion))
                return false;
        return true;
    }

    /// As in Theorem S, for conditions that do not know the whole camera.
    bool free_conditions_are_independent() const {
        for (unsigned chosen = 1; chosen < 4; ++chosen) {
            Echelon known = cameras_;
            std::size_t count = 0;
            for (std::size_t t = 0; t < 2; ++t) {
                if (!has_view(chosen, t) || third_.epipolar[t] == 0) continue;
                known.add_all(views_.relative_pose(partner(t), pair_.u));
                count += third_.epipolar[t];
            }
            const bool all = count == third_.epipolar[0] + third_.epipolar[1] + third_.incidences;
            if (count > 0 && !all && known.size() - cameras_.size() <= count) return false;
        }
        return true;
    }

    const Pair& pair_;
    const ThirdView& third_;
    Drawn drawn_{};
    MovingViews views_{drawn_};
    Echelon cameras_{}; // the conditions that are not free
};
} // namespace

std::optional<Views> views_with_five_points(const Signature& signature) {
    std::optional<Views> found;
    for (const Views views : view_pairs) {
        if (shared_points(signature, views) != 5) continue;
        if (found) return std::nullopt;
        found = views;
    }
    return found;
}

bool has_all_permutations_of_third_cameras(const Signature& signature) {
    const std::optional<Views> views = views_with_five_points(signature);
    if (!views) return false;
    const Pair pair = pair_of(*views);
    const ThirdView third = third_view(signature, pair);
    return ProofForThirdView(pair, third).succeeds();
}
} // namespace checker
