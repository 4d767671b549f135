// Upper bounds of camera-degrees (FORMAT.md, section 10). Where two views share five points, their
// relative pose has finitely many values, and what is left is to register the third camera: six
// conditions on a rotation and a translation. A template of their type is a square matrix whose
// determinant, not being 0, bounds the number of solutions.
#include "checker/record.h"
#include "checker/rotation_ring.h"

#include <optional>

namespace checker {
namespace {
/// Where a type has the number of its stars without pins (those with some follow), of its lines, of
/// its incidences, and, in the places after these, of its groups of 1, 2, ... rays.
enum Constraint : std::size_t { star = 0, line = 8, incidence = 9, rays = 9 };

/// The relative pose of two views that share five points: one camera, and five rays of the other.
constexpr Registration relative_pose{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};

/// What is left of a problem when the relative pose of two views is known.
Registration registration(const Signature& signature, Views pair) {
    Registration type{};
    const Views third = 0b111 & ~pair;
    std::array<unsigned, 5> group{}; // by view of the pair: rays that the third sees as points
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        const Views seeing = feature.point & pair;
        bool located = seeing == pair;  // the pair determines the point
        unsigned known = 0, others = 0; // pins that the third view sees: known lines; and others
        for (unsigned pin = 0; pin < feature.pins; ++pin) {
            located |= seeing != 0 && (feature.pin[pin] & pair & ~seeing) != 0;
            if (feature.pin[pin] & third) ++((feature.pin[pin] & pair) == pair ? known : others);
        }
        if (feature.point & third && !located && seeing != 0)
            group[seeing] += signature[i];
        else if (feature.point & third)
            type[located ? star + known : rays + 1] += signature[i];
        else if (known + others > 0)
            type[known > 0 ? line : incidence] += signature[i];
    }
    for (const unsigned count : group)
        if (count > 0) ++type[rays + count];
    return type;
}

/// An equation in the rotation R and the translation t: its coefficients at t, and the rest.
struct Condition {
    std::optional<Bidegree> degree; // of the rest, for arbitrary data; none if it is 0
    bool ray;                       // the coefficients have the degree of R, else 0
    bool axis;                      // they are those of the line that the frame distinguishes
    std::array<Polynomial, 4> row{};
};

/// A polynomial that vanishes at the solutions, and its degree for arbitrary data.
struct Equation {
    Polynomial polynomial{};
    Bidegree degree{};
};

Residue residue(const mpz_class& x) {
    return {mpz_fdiv_ui(x.get_mpz_t(), modulus)};
}

/// The constraints of a template, in a frame, and the equations that they put on the rotation.
struct Constraints {
    bool line, aligned, paired; // the frame: line, points, lines
    RotationRing ring{!line && !aligned && !paired};
    std::array<Polynomial, 9> turn = ring.matrix();
    Registration type{};
    std::vector<Condition> conditions{};
    std::vector<Equation> equations{};
    unsigned weight = 0, stars = 0, lines = 0;
    std::array<Vector, 2> points{}, images{};  // of the first two stars
    std::vector<std::array<Vector, 3>> seen{}; // lines: point, direction, image
    std::vector<std::array<Vector, 2>> met{};  // directions of lines, image points
    std::string flaw{};

    void read(Reader& reader) {
        for (; reader.comes("star"); weight += 2) read_star(reader);
        for (; reader.comes("line"); weight += 2) read_line(reader);
        for (; reader.comes("incidence"); ++weight) {
            ++type[incidence];
            const auto [x, l] = take<2>(reader, "incidence point @ @ @ line @ @ @ $");
            incident(x, l, ring.unit());
        }
        while (reader.comes("transversals")) read_group(reader);
        const bool four = lines == 2 && conditions.size() == 4 && conditions[2].ray;
        if ((line && lines == 0) || (aligned && stars < 2) || (paired && !four))
            flaw = "the frame does not fit the constraints";
        else if (paired)
            add_reduced_minor();
        add_determinants(4, 0);
        if (weight != 6 && type != relative_pose)
            flaw = say("the constraints have weight ", weight);
    }

private:
    /// Takes the words, and the numbers among them as vectors.
    template <std::size_t count>
    std::array<Vector, count> take(Reader& reader, std::string_view words) const {
        if (weight > 5) reader.fail("more", "constraints of weight 6");
        const Numbers numbers = reader.take(words);
        std::array<Vector, count> vectors;
        for (std::size_t i = 0; i < 3 * count; ++i) vectors[i / 3][i % 3] = numbers[i];
        return vectors;
    }

    /// l · R x
    Polynomial turned(const Vector& l, const Vector& x) const {
        Polynomial sum;
        for (std::size_t i = 0; i < 9; ++i)
            ring.add(sum, turn[i], {{{}, {1}}}, residue(l[i / 3] * x[i % 3]));
        return sum;
    }

    /// The point x lies on the image line l: l · (R x + t) = 0.
    void incident(const Vector& x, const Vector& l, std::optional<Bidegree> degree,
                  bool axis = false) {
        Condition& condition = conditions.emplace_back(Condition{degree, false, axis});
        for (std::size_t i = 0; i < 3; ++i) condition.row[i][{}] = residue(l[i]);
        if (degree) condition.row[3] = turned(l, x);
    }

    void read_star(Reader& reader) {
        const auto [point, x] = take<2>(reader, "star point @ @ @ image @ @ @");
        const bool first = stars++ == 0, on_axis = aligned && stars <= 2;
        if (stars <= 2) points[stars - 1] = point, images[stars - 1] = x;
        const auto degree = first ? std::nullopt : std::optional(ring.unit());
        if (first && point != Vector{}) flaw = "the first star is not at the origin";
        if (on_axis && (point[1] != 0 || point[2] != 0 || x[2] != 0))
            flaw = "a star is not on the axis";
        if (!on_axis) incident(point, {0, x[2], -x[1]}, degree);
        if (!on_axis) incident(point, {-x[2], 0, x[0]}, degree);
        if (on_axis && first) incident(point, {0, 0, 1}, {}, true); // the second star's, too
        if (on_axis) incident(point, {-x[1], x[0], 0}, first ? degree : Bidegree{1, 0});
        unsigned pins = 0;
        for (; reader.comes("pin"); ++pins, ++weight) {
            const auto [direction, toward] = take<2>(reader, "pin @ @ @ toward @ @ @");
            equations.push_back({turned(cross(x, toward), direction), ring.unit()});
        }
        ++type[star + pins];
        reader.end_line();
    }

    void read_line(Reader& reader) {
        const auto [point, direction, l] =
            take<3>(reader, "line point @ @ @ direction @ @ @ image @ @ @ $");
        const bool first = lines++ == 0, axis = first && (line || paired);
        if (axis && (direction != Vector{1, 0, 0} || l != Vector{0, 0, 1}))
            flaw = "the first line is not the axis";
        if (paired && (point[0] != 0 || point[1] != 0 || (first ? point : direction)[2] != 0))
            flaw = "the third axis is not the common perpendicular";
        seen.push_back({point, direction, l});
        const Bidegree degree = axis ? Bidegree{0, 1} : ring.unit();
        incident(point, l, axis && paired ? std::nullopt : std::optional(degree), axis);
        if (!axis) equations.push_back({turned(l, direction), ring.unit()});
        if (axis && line && stars >= 2) add_distance(point);
        ++type[Constraint::line];
    }

    /// The first line, through this point, determines the depths of two stars, so their distance.
    void add_distance(const Vector& point) {
        const mpz_class a = images[0][2], b = images[1][2];
        Polynomial all;
        for (std::size_t i = 0; i < 3; ++i) { // a b R (points[1] - points[0]) = w
            const mpz_class x = b * images[0][i] - a * images[1][i], y = a * images[1][i];
            Polynomial w = turned({0, 0, x}, point);
            ring.add(w, turned({0, 0, y}, points[1]), {{{}, {1}}}, {1});
            ring.add(all, w, w, {1});
            ring.add(all, {}, -residue(points[1][i] * points[1][i] * a * a * b * b));
        }
        equations.push_back({all, {0, 2}});
    }

    void read_group(Reader& reader) {
        const auto [point] = take<1>(reader, "transversals point @ @ @");
        const std::size_t first = conditions.size();
        for (; conditions.size() == first || !reader.at_end(); ++weight) {
            const auto [direction, x] = take<2>(reader, "direction @ @ @ image @ @ @");
            met.push_back({direction, x});
            // The ray of x meets the line: x · ((R point + t) × R direction) = 0.
            Condition& condition = conditions.emplace_back(Condition{ring.unit(), true, false});
            condition.row[3] = turned(x, cross(point, direction));
            for (std::size_t i = 0; i < 3; ++i)
                condition.row[i] = turned(cross(x, {i == 0, i == 1, i == 2}), direction);
        }
        reader.end_line();
        ++type[rays + conditions.size() - first];
        add_determinants(3, first);
    }

    /// Of two lines and two rays: a multiple of the determinant, of a smaller degree (FORMAT.md).
    void add_reduced_minor() {
        const auto& [point, direction, l] = seen[1];
        const auto& [d, x] = met[0];
        const auto& [e, y] = met[1];
        const mpz_class &a = direction[0], &b = direction[1], &h = point[2];
        const Vector first{1, 0, 0}, across{-b * e[1] * h * l[1], b * e[1] * h * l[0], 0};
        const Vector around{0, a * e[2] * h, -a * e[1] * h};
        Polynomial all, g = turned(across, first);
        g[{}] = residue(b * e[2] * h * l[2]);
        ring.add(g, turned(l, first), turned({0, 0, 1}, around), {1});
        ring.add(all, g, turned(cross(x, y), d), {1});
        ring.add(all, conditions[1].row[3], turned(x, cross(e, d)), -residue(b * y[2]));
        ring.add(all, conditions[2].row[3], determinant(0b1011), -residue(b));
        ring.add(all, conditions[3].row[3], determinant(0b0111), residue(b));
        equations.push_back({all, {2, 2}});
    }

    /// The determinant of a set of conditions, by bits: of three (coefficients at t), or of four.
    Polynomial determinant(unsigned set) const {
        if (set == 0) return {{{}, {1}}};
        const auto last = static_cast<std::size_t>(std::popcount(set) - 1);
        Residue sign = last % 2 == 0 ? -Residue{1} : Residue{1};
        Polynomial sum; // expanded by the last column
        for (std::size_t i = 0; i < conditions.size(); ++i)
            if (const unsigned rest = set & ~(1U << i); rest != set)
                ring.add(sum, conditions[i].row[last], determinant(rest), sign = -sign);
        return sum;
    }

    /// Its degree for arbitrary data.
    Bidegree degree(unsigned set) const {
        Bidegree most{};
        unsigned rays = 0, axes = 0;
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            const unsigned rest = set & ~(1U << i);
            if (rest == set) continue;
            rays += conditions[i].ray;
            axes += conditions[i].axis;
            for (std::size_t d = 0; d < 2 && std::popcount(rest) == 3; ++d)
                if (const auto& free = conditions[i].degree)
                    most[d] = std::max(most[d], (*free)[d] + degree(rest)[d]);
        }
        if (std::popcount(set) == 4) return most;
        // Where R becomes infinite, the coefficients of rays are orthogonal to one isotropic
        // vector, hence three dependent; so are those of the axis if the first degree does.
        return {(rays - (rays + axes == 3 && rays > 1)) * ring.unit()[0],
                (rays - (rays == 3)) * ring.unit()[1]};
    }

    /// Adds the determinants of so many conditions, from this one on. Numbers put sets of bits of
    /// one size into colexicographic order.
    void add_determinants(int size, std::size_t first) {
        for (unsigned set = 0; set >> conditions.size() == 0; set += 1U << first)
            if (std::popcount(set) == size) equations.push_back({determinant(set), degree(set)});
    }
};

/// Takes a template, which bounds the solutions of its type. Throws Refused unless it holds.
std::pair<Registration, std::size_t> read_template(Reader& reader) {
    reader.take("template");
    const std::string_view frame = reader.word();
    if (frame != "general" && frame != "line" && frame != "points" && frame != "lines")
        reader.fail(frame, "`general`, `line`, `points` or `lines`");
    reader.take("degree");
    Bidegree most{static_cast<unsigned>(reader.integer(1, 6)), 0};
    if (frame != "general") most[1] = static_cast<unsigned>(reader.integer(1, 6));
    reader.end_line();
    Constraints given{frame == "line", frame == "points", frame == "lines"};
    given.read(reader);
    reader.take("basis");
    const std::vector<Exponents> columns = given.ring.monomials(most);
    const Numbers basis = read_ascending(reader, std::ssize(columns));
    reader.end_line();
    std::map<Exponents, std::size_t> place; // of a column in the square matrix
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (!std::binary_search(basis.begin(), basis.end(), std::int64_t(i + 1)))
            place.emplace(columns[i], place.size());
        else if (!fits(given.ring.degree(columns[i]), given.ring.unit(), most))
            given.flaw = say("monomial ", i + 1, " is of too large a degree for the basis");
    std::vector<std::vector<Residue>> matrix;
    for (std::int64_t number = 0; number == 0 || reader.comes("rows"); reader.end_line()) {
        reader.take("rows");
        number = reader.integer(number + 1, std::ssize(given.equations));
        const Equation& equation = given.equations[static_cast<std::size_t>(number - 1)];
        for (const std::int64_t monomial : read_ascending(reader, std::ssize(columns))) {
            const Exponents& factor = columns[static_cast<std::size_t>(monomial - 1)];
            if (!fits(equation.degree, given.ring.degree(factor), most))
                given.flaw = say("equation ", number, " times monomial ", monomial,
                                 " is of too large a degree");
            Polynomial multiple;
            given.ring.add(multiple, equation.polynomial, {{factor, {1}}}, {1});
            auto& entries = matrix.emplace_back(place.size());
            for (const auto& [e, coefficient] : multiple)
                if (place.contains(e)) entries[place.at(e)] = coefficient;
        }
    }
    reader.take("minor");
    const Residue stated{static_cast<std::uint64_t>(reader.integer(1, modulus - 1))};
    reader.end_line();
    if (matrix.size() != place.size())
        given.flaw = say("there are ", matrix.size(), " rows for ", place.size(), " columns");
    if (!given.flaw.empty()) throw Refused(given.flaw);
    const Residue minor = determinant(std::move(matrix));
    if (minor != stated) throw Refused("the minor is ", minor.value, " modulo q");
    return {given.type, basis.size()};
}
} // namespace

void replay_bounds(Reader& reader, const Classification& classes, FileReport& report) {
    reader.take(say("modulus ", modulus, " $"));
    std::map<Registration, std::size_t> bounds; // the smallest of each type
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        try {
            const auto [type, bound] = read_template(reader);
            const auto place = bounds.emplace(type, bound).first;
            place->second = std::min(place->second, bound);
            ++report.templates;
        } catch (const Refused& refused) {
            report.refuse(line, refused.reason);
        }
    }
    const std::size_t poses = bounds[relative_pose]; // 0 if there is no bound
    for (std::size_t n = 0; n < classes.representatives.size(); ++n) {
        const Signature& signature = classes.representatives[n];
        std::size_t& best = report.upper.emplace_back(0);
        Registration& type = report.types.emplace_back();
        if (!obstruction(signature).minimal()) continue;
        best = bound_by_theorem(signature);
        type.back() = unsigned(best == 64 ? 0 : n); // else each class for itself
        for (const Views pair : view_pairs) {
            if (shared_points(signature, pair) != 5) continue;
            const Registration left = registration(signature, pair);
            const std::size_t bound = poses * bounds[left];
            if (bound > 0 && (best == 0 || bound < best)) best = bound, type = left;
        }
        if (best > 0 && classes.swap_class[n] == n) ++report.at_most[best];
    }
}
} // namespace checker
