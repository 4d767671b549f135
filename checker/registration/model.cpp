#include "checker/registration/model.h"

#include "checker/file/complaint.h"

#include <vector>

namespace checker {
namespace {
/// A condition on the camera, which is linear in its translation t: k · t + f = 0.
struct Condition {
    std::string direction{}, image{}; // the names of a ray's; empty of other conditions
    bool has_free_term = true;
    bool is_axis = false; // k is (0, 0, 1)
};

/// Writes the text of the model of a type of registration.
class Writer {
public:
    explicit Writer(const Registration& type) : type_(type) {
        for (std::size_t pins = 0; pins < type.stars.size(); ++pins)
            stars_.insert(stars_.end(), type.stars[pins], pins);
        for (std::size_t size = 0; size < type.groups.size(); ++size)
            groups_.insert(groups_.end(), type.groups[size], size);
        for (const std::size_t size : groups_)
            rays_ += size;
        two_lines_ = type.lines == 2 && rays_ == 2 && stars_.empty() && type.incidences == 0;
        points_ = type.lines == 0 && stars_.size() >= 2;
    }

    std::string text() {
        line("model ", name_of(type_));
        add_data();
        add_rotation();
        add_conditions();
        add_minors();
        add_equations();
        return std::move(text_);
    }

private:
    template <class... Parts> void line(const Parts&... parts) { text_ += say(parts..., '\n'); }

    bool axis() const { return type_.lines > 0 || points_; }

    /// Vectors of data, with names that end in the numbers from `first` to `last`.
    void vectors(std::string_view names, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i <= last; ++i) {
            std::string list;
            for (const char name : names)
                list += say(list.empty() ? "" : ", ", name, i, " : vector 3");
            line("data ", list);
        }
    }

    void add_data() {
        const std::size_t in_frame = points_ ? 2 : std::min<std::size_t>(stars_.size(), 1);
        if (points_) {
            line("data a1, b1, a2, b2, h2");
            line("let x1 = [a1, b1, 0]");
            line("let x2 = [a2, b2, 0]");
        } else {
            vectors("x", 1, in_frame);
        }
        vectors("Xx", in_frame + 1, stars_.size());
        std::size_t pins = 0;
        for (const std::size_t own : stars_)
            pins += own;
        vectors("Pp", 1, pins);
        if (two_lines_) {
            line("data l2 : vector 3, a, b, h");
            line("let D2 = [a, b, 0]");
        } else if (type_.lines > 0) {
            vectors("L", 1, 1);
            vectors("LDl", 2, type_.lines);
        }
        vectors("Yy", 1, type_.incidences);
        vectors("C", 1, groups_.size());
        vectors("Ee", 1, rays_);
    }

    void add_rotation() {
        if (!axis()) {
            line("unknown q : vector 3");
            line("let R = rotation(q)/(1 + norm2(q))");
            return;
        }
        line("unknown u, v");
        line("let n = 1/(1 + u^2)");
        line("let m = 1/(1 + v^2)");
        line("let c = (1 - u^2)*n");
        line("let s = 2*u*n");
        line("let d = (1 - v^2)*m");
        line("let t = 2*v*m");
        line("let R = [[c, -s*d, s*t], [s, c*d, -c*t], [0, t, d]]");
    }

    void add_condition(const Condition& condition, std::string_view k, std::string_view f) {
        conditions_.push_back(condition);
        line("let k", conditions_.size(), " = ", k);
        if (condition.has_free_term) line("let f", conditions_.size(), " = ", f);
    }

    /// The point X is on the image line k; X is the origin if it has no name.
    void add_incidence(std::string_view k, std::string_view X) {
        add_condition({.has_free_term = !X.empty()}, k,
                      say("dot(k", conditions_.size() + 1, ", R*", X, ")"));
    }

    /// The condition that distinguishes a frame of two circles.
    void add_axis(bool has_free_term) {
        add_condition({.has_free_term = has_free_term, .is_axis = true}, "[0, 0, 1]",
                      "dot(R[3], L1)");
    }

    void add_conditions() {
        if (points_) {
            add_axis(false);
            for (std::size_t i = 1; i <= 2; ++i)
                add_condition({.has_free_term = i == 2}, say("[-b", i, ", a", i, ", 0]"),
                              "h2*(a2*s - b2*c)");
        }
        for (std::size_t i = points_ ? 3 : 1; i <= stars_.size(); ++i) {
            const std::string x = say("x", i), X = i == 1 ? "" : say("X", i);
            add_incidence(say("[0, ", x, "[3], -", x, "[2]]"), X);
            add_incidence(say("[-", x, "[3], 0, ", x, "[1]]"), X);
        }
        if (type_.lines > 0) add_axis(!two_lines_);
        for (std::size_t i = 2; i <= type_.lines; ++i)
            add_incidence(say("l", i), two_lines_ ? "[0, 0, h]" : say("L", i));
        for (std::size_t i = 1; i <= type_.incidences; ++i)
            add_incidence(say("y", i), say("Y", i));
        std::size_t ray = 0;
        for (std::size_t group = 1; group <= groups_.size(); ++group)
            for (std::size_t i = 0; i < groups_[group - 1]; ++i) {
                const std::string E = say("E", ++ray), e = say("e", ray);
                add_condition({.direction = E, .image = e}, say("cross(R*", E, ", ", e, ")"),
                              say("dot(", e, ", R*cross(C", group, ", ", E, "))"));
            }
    }

    const Condition& condition(std::size_t i) const { return conditions_[i - 1]; }
    bool is_ray(std::size_t i) const { return !condition(i).image.empty(); }

    /// det(k_i, k_j, k_h), in a form that has the smallest degree in R.
    std::string minor(std::size_t i, std::size_t j, std::size_t h) const {
        const auto &E = condition(j).direction, &e = condition(j).image;
        const auto &F = condition(h).direction, &f = condition(h).image;
        if (is_ray(i)) {
            const auto &D = condition(i).direction, &x = condition(i).image;
            return say("dot(", x, ", R*cross(", F, ", ", D, "))*dot(R*", E, ", cross(", e, ", ", f,
                       ")) + dot(R*", D, ", cross(", x, ", ", f, "))*dot(", e, ", R*cross(", E,
                       ", ", F, "))");
        }
        if (condition(i).is_axis && is_ray(j))
            return say("dot(R[3], ", F, ")*dot(R*", E, ", cross(", e, ", ", f, ")) + ", f,
                       "[3]*dot(", e, ", R*cross(", E, ", ", F, "))");
        return say("det([k", i, ", k", j, ", k", h, "])");
    }

    void add_minors() {
        for (std::size_t h = 3; h <= conditions_.size(); ++h)
            for (std::size_t j = 2; j < h; ++j)
                for (std::size_t i = 1; i < j; ++i)
                    line("let d", i, j, h, " = ", minor(i, j, h));
    }

    void add_equations() {
        std::size_t pin = 0;
        for (std::size_t i = 1; i <= stars_.size(); ++i)
            for (std::size_t own = 0; own < stars_[i - 1]; ++own) {
                ++pin;
                line("equation dot(cross(x", i, ", p", pin, "), R*P", pin, ") = 0");
            }
        for (std::size_t i = 2; i <= type_.lines; ++i)
            line("equation dot(l", i, ", R*D", i, ") = 0");
        if (type_.lines > 0 && stars_.size() >= 2) add_distance();
        add_groups();
        if (two_lines_) add_reduced_determinant();
        for (std::size_t l = 4; l <= conditions_.size(); ++l)
            for (std::size_t h = 3; h < l; ++h)
                for (std::size_t j = 2; j < h; ++j)
                    for (std::size_t i = 1; i < j; ++i)
                        add_determinant(i, j, h, l);
    }

    /// The first line determines the depths of two stars, hence their distance.
    void add_distance() {
        line("let w = dot(R[3], X2 - L1)*x1[3]*x2 + dot(R[3], L1)*x2[3]*x1");
        line("equation norm2(w) = (x1[3]*x2[3])^2*norm2(X2)");
    }

    void add_groups() {
        std::size_t before = conditions_.size() - rays_;
        for (const std::size_t size : groups_) {
            for (std::size_t h = before + 3; h <= before + size; ++h)
                for (std::size_t j = before + 2; j < h; ++j)
                    for (std::size_t i = before + 1; i < j; ++i)
                        line("equation d", i, j, h, " = 0");
            before += size;
        }
    }

    /// A multiple of the determinant of all conditions, of a smaller degree.
    void add_reduced_determinant() {
        line("let w = l2[1]*c + l2[2]*s");
        line("let g = h*E2[2]*(b*(l2[1]*s - l2[2]*c) - a*w*d) + h*E2[3]*(b*l2[3] + a*w*t)");
        line("equation g*dot(cross(e1, e2), R*E1) - b*e2[3]*f2*dot(e1, R*cross(E2, E1)) - "
             "b*f3*d124 + b*f4*d123 = 0");
    }

    void add_determinant(std::size_t i, std::size_t j, std::size_t h, std::size_t l) {
        std::string sum;
        const std::array<std::size_t, 4> all{i, j, h, l};
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            if (!condition(all[left_out]).has_free_term) continue;
            const bool minus = left_out % 2 == 1;
            sum += sum.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
            sum += say("f", all[left_out], "*d");
            for (std::size_t k = 0; k < 4; ++k)
                if (k != left_out) sum += say(all[k]);
        }
        line("equation ", sum, " = 0");
    }

    const Registration& type_;
    std::vector<std::size_t> stars_{};  // the pins of each
    std::vector<std::size_t> groups_{}; // the rays of each
    std::size_t rays_ = 0;
    bool two_lines_ = false, points_ = false; // which frame
    std::vector<Condition> conditions_{};
    std::string text_{};
};
} // namespace

std::string name_of(const Registration& type) {
    std::string name = "registration_s";
    for (std::size_t pins = 0; pins < type.stars.size(); ++pins)
        for (unsigned i = 0; i < type.stars[pins]; ++i)
            name += say(pins);
    name += say("_l", type.lines, "_i", type.incidences, "_r");
    for (std::size_t size = 0; size < type.groups.size(); ++size)
        for (unsigned i = 0; i < type.groups[size]; ++i)
            name += say(size);
    return name;
}

std::string model_of(const Registration& type) {
    return Writer(type).text();
}
} // namespace checker
