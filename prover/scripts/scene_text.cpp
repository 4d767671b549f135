#include "prover/scripts/scene_text.h"

#include "prover/problem/notation.h"
#include "prover/scripts/scene_names.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace plprove {

namespace {

class SceneWriter {
public:
    SceneWriter(ModelText& text, const Problem& problem, std::string matrix)
        : text_(text), problem_(problem), matrix_(std::move(matrix)),
          features_(features_of(problem)), places_(problem.points.size()),
          images_(problem.points.size()) {}

    void run() {
        const int points = static_cast<int>(problem_.points.size());
        int key = 0;
        for (int point = 0; point < points;) {
            const int next = after_equal_points(point);
            write_points(point, {std::to_string(++key), next - point});
            point = next;
        }
        int shared = 0;
        for (const Line& line : problem_.lines)
            if (line.points.size() > 1) write_shared_line(line, "L" + std::to_string(++shared));
        std::vector<ViewSet> free;
        for (const Line& line : problem_.lines)
            if (line.points.empty()) free.push_back(line.seen);
        for (auto first = free.begin(); first != free.end();) {
            const auto next =
                std::find_if(first, free.end(), [&](ViewSet views) { return views != *first; });
            write_free_lines(*first, {std::to_string(++key), static_cast<int>(next - first)});
            first = next;
        }
    }

private:
    const Line& line(int index) const { return problem_.lines[static_cast<std::size_t>(index)]; }
    ViewSet views_of_point(int point) const {
        return problem_.points[static_cast<std::size_t>(point)];
    }
    bool sees(int view, int point) const { return contains(views_of_point(point), view); }
    ScenePoint& place(int point) { return places_[static_cast<std::size_t>(point)]; }

    /// The views of the pins of a point, which no other point is on.
    std::vector<ViewSet> pins(int point) const {
        std::vector<ViewSet> result;
        for (const int index : lines_through(problem_, point))
            if (line(index).points.size() == 1) result.push_back(line(index).seen);
        std::ranges::sort(result);
        return result;
    }

    bool is_local(int point) const {
        return pins(point).size() == lines_through(problem_, point).size();
    }

    int after_equal_points(int first) const {
        int next = first + 1;
        const int points = static_cast<int>(problem_.points.size());
        while (is_local(first) && next < points && is_local(next) &&
               views_of_point(next) == views_of_point(first) && pins(next) == pins(first))
            ++next;
        return next;
    }

    /// The image of a place, up to a factor.
    std::string image(int view, const ScenePoint& at) const {
        if (view == 0) return at.vector;
        const std::string n = view_number(view);
        std::string turned = matrix_ + n;
        turned += "*" + in_brackets(at.vector);
        if (at.weight == "0") return turned;
        return turned + " + " + (at.weight == "1" ? "" : in_brackets(at.weight) + "*") + "t" + n;
    }

    void title(int feature, const FeatureGroup& group) {
        text_.line("");
        const std::string notation =
            plprove::notation(features_[static_cast<std::size_t>(feature)]);
        text_.comment((group.count == 1 ? "" : std::to_string(group.count) + "*") + notation);
    }

    void data(const std::string& name, const FeatureGroup& group) {
        text_.line("data " + name + group.list() + " : vector 3");
    }

    void write_points(int point, const FeatureGroup& group) {
        title(point, group);
        image_data(point, group);
        if (is_epipolar(point)) return write_epipolar(point, group);
        place_point(point, group);
        std::vector<Pin> kept;
        char letter = 'a';
        for (const int index : lines_through(problem_, point))
            if (line(index).points.size() == 1)
                if (const auto pin = placed_pin(point, line(index), group, letter++))
                    kept.push_back(*pin);
        const bool loop = group.count > 1;
        if (loop) text_.begin_loop("i", "1.." + std::to_string(group.count));
        point_equations(point);
        for (const Pin& pin : kept)
            pin_equations(point, pin, group);
        if (loop) text_.end_loop();
    }

    /// Of a point, whether two views, the first and another one, see it and put one condition.
    bool is_epipolar(int point) const {
        const ViewSet views = views_of_point(point);
        return is_local(point) && contains(views, 0) && seen_by_two(views) &&
               std::ranges::all_of(pins(point), [&](ViewSet pin) { return pin == views; });
    }

    void write_epipolar(int point, const FeatureGroup& group) {
        const int view = std::bit_width(views_of_point(point)) - 1;
        const std::string n = view_number(view), x = "x" + group.key + "_";
        if (!pins(point).empty())
            text_.comment("Two images of a line say nothing of the cameras: the lines are left "
                          "out.");
        if (essential_.insert(view).second) {
            text_.line("let E" + n + " = skew(t" + n + ")*" + matrix_ + n);
            // Else all images that two views take from one place would do.
            if (view > 1)
                text_.line("nonzero t" + n + "[1]", "the cameras are in different places");
        }
        const bool loop = group.count > 1;
        if (loop) text_.begin_loop("i", "1.." + std::to_string(group.count));
        text_.line("equation dot(" + x + n + group.item() + ", E" + n + "*" + x + "1" +
                   group.item() + ") = 0");
        if (loop) text_.end_loop();
    }

    /// The first two points before this one that the view sees on its carrier.
    std::optional<std::pair<int, int>> seen_before(int point, int view) const {
        const std::optional<int> on = carrier(problem_, point);
        if (!on) return std::nullopt;
        std::vector<int> seen;
        for (const int other : line(*on).points)
            if (other < point && sees(view, other)) seen.push_back(other);
        if (seen.size() < 2) return std::nullopt;
        return std::pair{seen[0], seen[1]};
    }

    /// The images of a point: any, or on the line through two other images.
    void image_data(int point, const FeatureGroup& group) {
        for (int view = 0; view < problem_.views; ++view) {
            if (!sees(view, point)) continue;
            const std::string tag = group.key + "_" + view_number(view);
            images_[static_cast<std::size_t>(point)][view] = "x" + tag + group.item();
            if (const auto pair = seen_before(point, view)) {
                text_.line("data c" + tag, "the place on a line in view " + view_number(view));
                text_.line("let x" + tag + " = " + seen_at(pair->first, view) + " + c" + tag + "*" +
                           seen_at(pair->second, view));
            } else {
                data("x" + tag, group);
            }
        }
    }

    const std::string& seen_at(int point, int view) const {
        return images_[static_cast<std::size_t>(point)].at(view);
    }

    /// Where the point is in space.
    void place_point(int point, const FeatureGroup& group) {
        const std::string& key = group.key;
        if (const std::optional<int> on = carrier(problem_, point))
            return place_on_line(point, line(*on), key);
        if (sees(0, point)) {
            text_.line("unknown w" + key + group.list());
            place(point) = {seen_at(point, 0), "w" + key + group.item()};
            on_ray_.insert(point);
        } else {
            text_.line("unknown X" + key + group.list() + " : vector 3");
            place(point) = {"X" + key + group.item(), "1"};
        }
    }

    void place_on_line(int point, const Line& on, const std::string& key) {
        const int a = on.points[0], b = on.points[1];
        const auto combination = [&](const std::string& first, const std::string& factor,
                                     const std::string& second) {
            return first + " + " + factor + "*" + second;
        };
        const std::string w = "w" + key;
        if (seen_before(point, 0) == std::pair{a, b} && is_on_ray(a) && is_on_ray(b)) {
            on_ray_.insert(point);
            text_.line("let " + w + " = " +
                       combination(place(a).weight, "c" + key + "_1", place(b).weight));
            place(point) = {seen_at(point, 0), w};
            return;
        }
        const std::string c = "c" + key, x = "X" + key;
        text_.line("unknown " + c, "the place on a line");
        text_.line("let " + x + " = " + combination(place(a).vector, c, place(b).vector));
        text_.line("let " + w + " = " + combination(place(a).weight, c, place(b).weight));
        place(point) = {x, w};
    }

    /// Whether the vector of the place is the image in view 1.
    bool is_on_ray(int point) const { return on_ray_.contains(point); }

    void point_equations(int point) {
        for (int view = 0; view < problem_.views; ++view) {
            if (!sees(view, point)) continue;
            if (view == 0 && is_on_ray(point)) continue;
            const std::string x = seen_at(point, view), found = image(view, place(point));
            if (seen_before(point, view))
                text_.line("equation dot(cross(" + x + ", [1, 0, 0]), " + found + ") = 0");
            else
                text_.line("equation " + found + " ~ " + x);
        }
    }

    /// A line through one point: its name, who sees it, and another point of it.
    struct Pin {
        std::string key;
        ViewSet views = 0;
        std::optional<ScenePoint> other; ///< none where two views alone see the line
    };

    /// The line through a point, after its data and unknowns are written; nothing if it is left
    /// out. Two planes through the point have a line in common: so what two views see of the line
    /// says no more than that the point is in the planes.
    std::optional<Pin> placed_pin(int point, const Line& on, const FeatureGroup& group,
                                  char letter) {
        Pin pin{group.key + letter, on.seen, {}};
        if (seen_by_two(on.seen) && (on.seen & ~views_of_point(point)) == 0) {
            text_.comment("Two images of a line say nothing of the cameras: it is left out.");
            return std::nullopt;
        }
        const bool in_two = seen_by_two(on.seen);
        for (int view = 0; view < problem_.views; ++view)
            if (contains(on.seen, view) && !(in_two && sees(view, point)))
                data((sees(view, point) ? "y" : "l") + pin.key + "_" + view_number(view), group);
        if (in_two) return pin;
        if (contains(on.seen, 0) && sees(0, point)) {
            text_.line("unknown w" + pin.key + group.list());
            pin.other = {"y" + pin.key + "_1" + group.item(), "w" + pin.key + group.item()};
        } else {
            pin.other = direction(pin.key, group);
        }
        return pin;
    }

    /// A point at infinity.
    ScenePoint direction(const std::string& key, const FeatureGroup& group) {
        const std::string name = "d" + key;
        text_.line("unknown " + name + group.list() + " : vector 2", "of the direction");
        const std::string item = name + group.item();
        return {"[" + item + "[1], " + item + "[2], 1]", "0"};
    }

    void pin_equations(int point, const Pin& pin, const FeatureGroup& group) {
        for (int view = 0; view < problem_.views; ++view) {
            if (!contains(pin.views, view)) continue;
            const std::string tag = pin.key + "_" + view_number(view) + group.item();
            if (!sees(view, point)) on_image_line("l" + tag, view, place(point));
            if (!pin.other) continue;
            if (!sees(view, point))
                on_image_line("l" + tag, view, *pin.other);
            else if (view > 0)
                on_join(seen_at(point, view), "y" + tag, view, *pin.other);
        }
    }

    void on_image_line(const std::string& l, int view, const ScenePoint& at) {
        text_.line("equation dot(" + l + ", " + image(view, at) + ") = 0");
    }

    void on_join(const std::string& x, const std::string& y, int view, const ScenePoint& at) {
        text_.line("equation dot(cross(" + x + ", " + y + "), " + image(view, at) + ") = 0");
    }

    /// A line with two points or more says something to a view that sees at most one of them.
    void write_shared_line(const Line& on, const std::string& key) {
        const int a = on.points[0], b = on.points[1];
        bool begun = false;
        for (int view = 0; view < problem_.views; ++view) {
            const std::vector<int> seen = seen_points(problem_, on, view);
            if (!contains(on.seen, view) || seen.size() > 1) continue;
            if (!begun) {
                text_.line("");
                text_.comment("A line with " + std::to_string(on.points.size()) +
                              " points, for views that see at most one of them");
                begun = true;
            }
            const std::string tag = key + "_" + view_number(view);
            data((seen.empty() ? "l" : "y") + tag, {});
            if (seen.empty())
                for (const int point : {a, b})
                    on_image_line("l" + tag, view, place(point));
            else
                on_join(seen_at(seen[0], view), "y" + tag, view, place(seen[0] == a ? b : a));
        }
    }

    void write_free_lines(ViewSet views, const FeatureGroup& group) {
        title(next_free_line_, group);
        next_free_line_ += group.count;
        if (seen_by_two(views))
            return text_.comment("Two images of a line say nothing of the cameras: no equation.");
        const std::string &key = group.key, item = group.item();
        std::vector<ScenePoint> points;
        if (contains(views, 0)) {
            data("y" + key + "_1", group);
            data("z" + key + "_1", group);
            text_.line("unknown w" + key + group.list() + ", u" + key + group.list());
            points = {{"y" + key + "_1" + item, "w" + key + item},
                      {"z" + key + "_1" + item, "u" + key + item}};
        } else {
            text_.line("unknown a" + key + group.list() + " : vector 2", "of a point");
            points = {{"[a" + key + item + "[1], a" + key + item + "[2], 0]", "1"},
                      direction(key, group)};
        }
        for (int view = 1; view < problem_.views; ++view)
            if (contains(views, view)) data("l" + key + "_" + view_number(view), group);
        const bool loop = group.count > 1;
        if (loop) text_.begin_loop("i", "1.." + std::to_string(group.count));
        for (int view = 1; view < problem_.views; ++view)
            if (contains(views, view))
                for (const ScenePoint& at : points)
                    on_image_line("l" + key + "_" + view_number(view) + item, view, at);
        if (loop) text_.end_loop();
    }

    ModelText& text_;
    const Problem& problem_;
    std::string matrix_;
    Features features_;
    std::vector<ScenePoint> places_;
    std::vector<std::map<int, std::string>> images_; // of points, by view
    std::set<int> on_ray_;                           // points whose vector is their image in view 1
    std::set<int> essential_;                        // views whose matrix E has been written
    int next_free_line_ = static_cast<int>(problem_.points.size());
};

} // namespace

void append_scene(ModelText& text, const Problem& problem, const std::string& matrix) {
    SceneWriter(text, problem, matrix).run();
}

} // namespace plprove
