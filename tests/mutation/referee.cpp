#include "tests/mutation/referee.h"

#include "prover/classification/decision.h"
#include "prover/geometry/flint.h"

#include <algorithm>
#include <bit>
#include <gmpxx.h>
#include <stdexcept>

namespace referee {

using plprove::Feature;
using plprove::Problem;
using Words = std::vector<std::string>;

namespace {

/// What is wrong with a file.
struct Objection : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void demand(bool holds, const char* otherwise) {
    if (!holds) throw Objection(otherwise);
}

mpz_class integer(const std::string& word) {
    mpz_class value;
    demand(!word.empty() && word.find_first_not_of("-0123456789") == word.npos &&
               value.set_str(word, 10) == 0,
           "a number");
    return value;
}

std::size_t index(const std::string& word) {
    const mpz_class value = integer(word);
    demand(value >= 0 && value < 1'000'000, "an index");
    return value.get_ui();
}

using Vector = std::array<mpz_class, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpz_class dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector unit(std::size_t i) {
    Vector e{0, 0, 0};
    e[i] = 1;
    return e;
}

struct Camera {
    std::array<mpz_class, 4> quaternion{1, 0, 0, 0};
    Vector translation{0, 0, 0};

    /// The rotation of a vector v as q v q*, for the quaternion q: no matrix is involved.
    Vector turn(const Vector& v) const {
        const mpz_class& a = quaternion[0];
        const Vector u{quaternion[1], quaternion[2], quaternion[3]};
        const Vector uv = cross(u, v);
        Vector result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = 2 * dot(u, v) * u[i] + (a * a - dot(u, u)) * v[i] + 2 * a * uv[i];
        return result;
    }
};

struct Placed {
    Feature feature;
    Vector point;
    std::vector<Vector> directions;
};

struct Pool {
    std::vector<Camera> cameras{Camera{}}; // camera 1 first
    std::vector<Placed> features;
};

Vector vector(const Words& words, std::size_t first) {
    demand(first + 3 <= words.size(), "three coordinates");
    return {integer(words[first]), integer(words[first + 1]), integer(words[first + 2])};
}

/// The pool that begins on line `at`, which is left behind it.
Pool read_pool(const Text& file, std::size_t& at, int views) {
    Pool pool;
    ++at;
    for (int view = 2; view <= views; ++view, ++at) {
        demand(at < file.lines.size(), "a camera");
        const Words& words = file.lines[at];
        demand(words.size() == 11 && words[0] == "camera" && words[1] == std::to_string(view) &&
                   words[2] == "quaternion" && words[7] == "translation",
               "a camera");
        Camera camera;
        for (std::size_t i = 0; i < 4; ++i)
            camera.quaternion[i] = integer(words[3 + i]);
        camera.translation = vector(words, 8);
        pool.cameras.push_back(camera);
    }
    for (; at < file.lines.size() && file.lines[at][0] == "feature"; ++at) {
        const Words& words = file.lines[at];
        demand(words.size() >= 6 && words[2] == "point", "a placed feature");
        Placed placed{plprove::parse_feature(words[1]), vector(words, 3), {}};
        for (std::size_t i = 6; i < words.size(); i += 4) {
            demand(words[i] == "pin", "a pin");
            placed.directions.push_back(vector(words, i + 1));
        }
        demand(placed.feature.views() == views, "what each view sees");
        demand(static_cast<int>(placed.directions.size()) == placed.feature.lines, "all pins");
        pool.features.push_back(std::move(placed));
    }
    return pool;
}

/// The equation that an image is kept: of the point, or of a line through it.
struct Equation {
    std::size_t view;
    Vector line;
    std::optional<std::size_t> pin; ///< none: line . dx = 0; else line . de = 0 of this pin
};

/// The equations of a feature in order. Objects to points that section 2 excludes.
std::vector<Equation> equations(const Placed& placed, const std::vector<Camera>& cameras) {
    std::vector<Equation> list;
    for (const Vector& direction : placed.directions)
        demand(direction[2] != 0, "the third coordinate of a direction");
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        Vector x = cameras[v].turn(placed.point);
        for (std::size_t i = 0; i < 3; ++i)
            x[i] += cameras[v].translation[i];
        const bool sees_point = placed.feature.sees_point(static_cast<int>(v));
        if (sees_point) {
            demand(x[2] != 0, "the third coordinate of an image");
            list.push_back({v, {0, x[2], -x[1]}, {}});
            list.push_back({v, {-x[2], 0, x[0]}, {}});
        }
        for (std::size_t pin = 0; pin < placed.directions.size(); ++pin) {
            if (!placed.feature.sees_line(static_cast<int>(v), static_cast<int>(pin))) continue;
            const Vector line = cross(x, cameras[v].turn(placed.directions[pin]));
            demand(line != Vector{0, 0, 0}, "the image of a line");
            if (!sees_point) list.push_back({v, line, {}});
            list.push_back({v, line, pin});
        }
    }
    return list;
}

/// A motion of one unknown: of a point, a direction, or a camera.
struct Unknown {
    enum Kind { point, direction, rotation, translation } kind;
    std::size_t which; ///< pin, or view
    std::size_t coordinate;
};

std::vector<Unknown> own_unknowns(const Feature& feature) {
    std::vector<Unknown> list;
    for (std::size_t i = 0; i < (feature.has_point ? 3U : 2U); ++i)
        list.push_back({Unknown::point, 0, i});
    for (std::size_t pin = 0; pin < static_cast<std::size_t>(feature.lines); ++pin)
        for (std::size_t i = 0; i < 2; ++i)
            list.push_back({Unknown::direction, pin, i});
    return list;
}

std::vector<Unknown> camera_unknowns(std::size_t views) {
    std::vector<Unknown> list;
    for (std::size_t view = 1; view < views; ++view) {
        for (std::size_t i = 0; i < 3; ++i)
            list.push_back({Unknown::rotation, view, i});
        for (std::size_t i = view == 1 ? 1 : 0; i < 3; ++i)
            list.push_back({Unknown::translation, view, i});
    }
    return list;
}

/// How fast the left side of the equation changes with the unknown.
mpz_class derivative(const Equation& equation, const Unknown& unknown, const Placed& placed,
                     const Camera& camera) {
    const Vector axis = unit(unknown.coordinate);
    switch (unknown.kind) {
    case Unknown::point:
        return equation.pin ? mpz_class(0) : dot(equation.line, camera.turn(axis));
    case Unknown::direction:
        return equation.pin == unknown.which ? dot(equation.line, camera.turn(axis)) : mpz_class(0);
    case Unknown::rotation: {
        if (equation.view != unknown.which) return 0;
        const Vector& arm = equation.pin ? placed.directions[*equation.pin] : placed.point;
        return dot(equation.line, cross(axis, camera.turn(arm)));
    }
    case Unknown::translation:
        return equation.view == unknown.which && !equation.pin ? equation.line[unknown.coordinate]
                                                               : mpz_class(0);
    }
    return 0;
}

struct Jacobian {
    std::vector<std::vector<mpz_class>> rows;
    std::size_t own = 0;     ///< columns of the features
    std::size_t cameras = 0; ///< columns of the cameras
};

Jacobian jacobian(const std::vector<Placed>& features, const std::vector<Camera>& cameras) {
    for (std::size_t v = 1; v < cameras.size(); ++v)
        demand(cameras[v].quaternion != std::array<mpz_class, 4>{0, 0, 0, 0}, "a quaternion");
    demand(cameras.size() > 1 && cameras[1].translation[0] != 0, "the first coordinate of t_2");
    Jacobian result;
    const std::vector<Unknown> camera_columns = camera_unknowns(cameras.size());
    result.cameras = camera_columns.size();
    for (const Placed& placed : features)
        result.own += own_unknowns(placed.feature).size();
    std::size_t first = 0;
    for (const Placed& placed : features) {
        const std::vector<Unknown> own = own_unknowns(placed.feature);
        for (const Equation& equation : equations(placed, cameras)) {
            auto& row = result.rows.emplace_back(result.own + result.cameras);
            const Camera& camera = cameras[equation.view];
            for (std::size_t c = 0; c < own.size(); ++c)
                row[first + c] = derivative(equation, own[c], placed, camera);
            for (std::size_t c = 0; c < camera_columns.size(); ++c)
                row[result.own + c] = derivative(equation, camera_columns[c], placed, camera);
        }
        first += own.size();
    }
    return result;
}

/// The determinant modulo q without these rows and columns, counted from 0.
std::uint64_t minor_without(const Jacobian& j, const std::vector<std::size_t>& rows,
                            const std::vector<std::size_t>& columns) {
    const std::size_t size = j.rows.size() - rows.size();
    demand(j.own + j.cameras - columns.size() == size, "a square matrix");
    plprove::ResidueMatrix matrix(static_cast<int>(size), static_cast<int>(size));
    for (std::size_t r = 0, target = 0; r < j.rows.size(); ++r) {
        if (std::ranges::find(rows, r) != rows.end()) continue;
        for (std::size_t c = 0, place = 0; c < j.rows[r].size(); ++c)
            if (std::ranges::find(columns, c) == columns.end())
                matrix.at(static_cast<int>(target), static_cast<int>(place++)) =
                    mpz_fdiv_ui(j.rows[r][c].get_mpz_t(), plprove::modulus);
        ++target;
    }
    return nmod_mat_det(matrix.get());
}

/// The rank over the rationals of the own columns, with one more column beside them if given.
slong own_rank(const Jacobian& j, const std::vector<mpz_class>* beside) {
    plprove::IntegerMatrix matrix(static_cast<int>(j.rows.size()),
                                  static_cast<int>(j.own + (beside ? 1 : 0)));
    for (std::size_t r = 0; r < j.rows.size(); ++r) {
        for (std::size_t c = 0; c < j.own; ++c)
            fmpz_set_mpz(matrix.at(static_cast<int>(r), static_cast<int>(c)),
                         j.rows[r][c].get_mpz_t());
        if (beside)
            fmpz_set_mpz(matrix.at(static_cast<int>(r), static_cast<int>(j.own)),
                         (*beside)[r].get_mpz_t());
    }
    return fmpz_mat_rank(matrix.get());
}

/// A record as its words say it.
struct Record {
    bool minimal = false, camera_minimal = false;
    std::string number;
    std::size_t pool = 0;
    std::vector<std::size_t> rows, columns; ///< deleted, from 0
    Words stated;                           ///< rank, excesses, star
    mpz_class minor;
    std::vector<std::vector<mpz_class>> kernel;
};

void read_deleted(const Words& words, Record& record) {
    auto* list = &record.columns;
    demand(words.size() > 2 && words[0] == "delete", "a line `delete`");
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i] == "rows" || words[i] == "columns") {
            list = words[i] == "rows" ? &record.rows : &record.columns;
            demand(list->empty(), "each list once");
            continue;
        }
        const std::size_t number = index(words[i]);
        demand(number > 0 && (list->empty() || list->back() + 1 < number), "an ascending list");
        list->push_back(number - 1);
    }
}

Record read_record(const Text& file, std::size_t at) {
    Record record;
    demand(at < file.lines.size(), "a record");
    const Words& head = file.lines[at];
    record.minimal = head[0] == "minimal";
    record.camera_minimal = head[0] == "camera-minimal";
    demand(head.size() >= 3 && (record.minimal || record.camera_minimal || head[0] == "deficient"),
           "a record");
    record.number = head[1];
    record.pool = index(head[2]);
    if (record.minimal) {
        demand(head.size() == 4 && at + 1 <= file.lines.size(), "a minor");
        record.minor = integer(head[3]);
        return record;
    }
    demand(at + 2 < file.lines.size(), "a line `minor`");
    record.stated.assign(head.begin() + 3, head.end());
    read_deleted(file.lines[at + 1], record);
    const Words& minor = file.lines[at + 2];
    demand(minor.size() == 2 && minor[0] == "minor", "a line `minor`");
    record.minor = integer(minor[1]);
    for (at += 3; at < file.lines.size() && file.lines[at][0] == "kernel"; ++at) {
        auto& vector = record.kernel.emplace_back();
        for (std::size_t i = 1; i < file.lines[at].size(); ++i)
            vector.push_back(integer(file.lines[at][i]));
    }
    return record;
}

std::vector<std::size_t> deleted_columns(const Record& record, const Jacobian& j) {
    std::vector<std::size_t> columns = record.columns;
    if (!record.camera_minimal)
        for (std::size_t& column : columns)
            column += j.own;
    demand(columns.empty() || columns.back() < j.own + (record.camera_minimal ? 0 : j.cameras),
           "a column of J");
    demand(record.rows.empty() || record.rows.back() < j.rows.size(), "a row of J");
    return columns;
}

/// Objects unless the record's numbers hold for J; `problem` is what stands behind J.
void examine(const Record& record, const Jacobian& j, const Problem& problem) {
    demand(minor_without(j, record.rows, deleted_columns(record, j)) != 0, "a nonzero minor");
    demand(minor_without(j, record.rows, deleted_columns(record, j)) == record.minor, "the minor");
    if (record.minimal) return;
    if (record.camera_minimal) {
        demand(record.rows.empty() && record.stated.empty() && record.kernel.empty(), "no more");
        return;
    }
    const plprove::Obstruction why = plprove::obstruction(problem);
    const auto deficiency = static_cast<std::size_t>(why.deficiency());
    const Words due{"rank",
                    std::to_string(11 - deficiency),
                    "excess",
                    std::to_string(why.excess[0]),
                    std::to_string(why.excess[1]),
                    std::to_string(why.excess[2]),
                    "star",
                    std::to_string(why.star)};
    demand(record.stated == due, "rank, excess and star");
    demand(deficiency > 0 && record.columns.size() == deficiency &&
               record.rows.size() == deficiency && record.kernel.size() == deficiency,
           "the deficiency");
    for (std::size_t i = 0; i < deficiency; ++i) {
        const auto& vector = record.kernel[i];
        demand(vector.size() == j.cameras, "a kernel vector");
        mpz_class divisor = 0;
        for (const mpz_class& entry : vector)
            divisor = gcd(divisor, entry);
        demand(divisor == 1, "a primitive kernel vector");
        for (std::size_t k = 0; k < deficiency; ++k)
            demand(i == k ? vector[record.columns[k]] > 0 : vector[record.columns[k]] == 0,
                   "a kernel vector of the basis");
        std::vector<mpz_class> effect(j.rows.size());
        for (std::size_t r = 0; r < j.rows.size(); ++r)
            for (std::size_t c = 0; c < j.cameras; ++c)
                effect[r] += j.rows[r][j.own + c] * vector[c];
        demand(own_rank(j, &effect) == own_rank(j, nullptr), "a motion that keeps all images");
    }
}

int pins_seen(const Feature& feature, int line, bool with_point_only) {
    int views = 0;
    for (int view = 0; view < feature.views(); ++view)
        views += feature.sees_line(view, line) && (!with_point_only || feature.sees_point(view));
    return views;
}

Feature without(const Feature& feature, int line) {
    Feature rest = feature;
    --rest.lines;
    for (plprove::Sight& sight : rest.sights) {
        std::uint32_t pins = 0;
        for (int i = 0; i < rest.lines; ++i)
            if ((sight.pins >> (i < line ? i : i + 1) & 1U) != 0) pins |= 1U << i;
        sight.pins = pins;
    }
    return rest;
}

/// Whether the table of FORMAT.md, section 7, allows the step.
bool allowed(const std::string& rule, const Feature& f, const std::optional<Feature>& result) {
    int points = 0;
    for (const plprove::Sight& sight : f.sights)
        points += sight.point;
    Feature line = f;
    line.has_point = false;
    for (plprove::Sight& sight : line.sights)
        sight.point = false;
    if (!f.has_point) {
        const int seen = pins_seen(f, 0, false);
        return !result && ((rule == "unseen-line" && seen == 0) ||
                           (rule == "free-line" && (seen == 1 || seen == 2)));
    }
    bool others = false; // a pin that is unseen or fit for a rule about pins
    for (int pin = 0; pin < f.lines; ++pin) {
        const int seen = pins_seen(f, pin, false);
        const bool all_with_point = pins_seen(f, pin, true) == seen;
        const std::string fit = seen == 0                     ? "unseen-line"
                                : seen == 1 && all_with_point ? "pin-seen-once"
                                : seen == 2 && all_with_point ? "pin-seen-twice"
                                                              : "";
        others |= !fit.empty();
        if (fit == rule && result && *result == without(f, pin)) return true;
    }
    if (rule == "unseen-point") {
        for (int pin = 0; pin < f.lines; ++pin)
            if (pins_seen(f, pin, false) == 0) return false;
        if (points > 0 || f.lines == 0) return false;
        return f.lines == 1 ? result && *result == line : !result;
    }
    if (rule == "bare-point") return !result && f.lines == 0 && points <= 1;
    if (rule == "point-on-line")
        return f.views() == 3 && points == 1 && f.lines == 1 && pins_seen(f, 0, false) == 3 &&
               result && *result == line;
    if (rule != "point-and-pin" || result) return false;
    if (f.views() == 3)
        return points == 1 && f.lines == 1 && pins_seen(f, 0, false) - pins_seen(f, 0, true) == 1;
    bool apart = false;
    for (int pin = 0; pin < f.lines; ++pin)
        apart |= pins_seen(f, pin, false) > pins_seen(f, pin, true);
    return points > 0 && apart && !others;
}

/// The problem that the steps leave; `at` is left behind them.
Problem reduced(Problem problem, const Text& file, std::size_t& at) {
    for (; at < file.lines.size() && file.lines[at][0] == "reduce"; ++at) {
        const Words& words = file.lines[at];
        demand(words.size() == 4, "a step");
        const std::size_t position = index(words[1]);
        demand(position >= 1 && position <= problem.size(), "a position");
        std::optional<Feature> result;
        if (words[3] != "nothing") result = plprove::parse_feature(words[3]);
        const auto place = problem.begin() + static_cast<std::ptrdiff_t>(position - 1);
        demand(allowed(words[2], *place, result), "a rule that applies");
        if (result)
            *place = *result;
        else
            problem.erase(place);
    }
    for (const Feature& feature : problem)
        demand(!plprove::reduce_once(feature), "a reduced problem");
    return problem;
}

std::string number_of(const Problem& lifted) {
    const auto signature = lifted.empty() || lifted.front().views() == 2
                               ? std::nullopt
                               : plprove::signature_of(lifted);
    if (!signature) return "-";
    const auto& classes = plprove::label_classes();
    return std::to_string(plprove::class_number(classes, plprove::representative(*signature)));
}

std::vector<Placed> used(const Pool& pool, const plprove::Signature& signature) {
    std::vector<Placed> features;
    for (std::size_t i = 0; i < plprove::feature_count; ++i) {
        int missing = signature[i];
        for (const Placed& placed : pool.features)
            if (missing > 0 && placed.feature == plprove::standard_features()[i]) {
                features.push_back(placed);
                --missing;
            }
        demand(missing == 0, "enough instances");
    }
    return features;
}

/// The pool with this number, from 1, of a classification file.
Pool pool_of(const Text& file, std::size_t number) {
    for (std::size_t at = 0; at < file.lines.size(); ++at)
        if (file.lines[at] == Words{"pool", std::to_string(number)}) return read_pool(file, at, 3);
    throw Objection("a pool");
}

std::string join(const Words& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

void examine_problem(const Text& file) {
    demand(file.lines.size() >= 3 && join(file.lines[0]) == "plcert 1 problem" &&
               file.lines[1][0] == "problem",
           "a problem file");
    const Problem problem = plprove::parse_problem(join(file.lines[1]).substr(8));
    const plprove::Decision decision = plprove::decide(problem);
    std::size_t at = 2;
    const Problem lifted = plprove::lifted(reduced(problem, file, at));
    demand(at < file.lines.size() && file.lines[at][0] == "verdict", "a verdict");
    const int excess = std::abs(decision.constraints - decision.camera_dimension);
    const std::string verdict(name(decision.verdict));
    demand(join(file.lines[at]) ==
               "verdict " + verdict + (excess == 0 ? "" : " " + std::to_string(excess)),
           "the verdict");
    if (excess != 0) {
        demand(at + 1 == file.lines.size(), "no evidence");
        return;
    }
    demand(at + 2 < file.lines.size() &&
               join(file.lines[at + 1]) == "modulus 2305843009213693951" &&
               join(file.lines[at + 2]) == "pool 1",
           "modulus and pool");
    at += 2;
    const Pool pool = read_pool(file, at, problem.front().views());
    const Record record = read_record(file, at);
    const bool obstructed = decision.verdict == plprove::Verdict::obstructed;
    demand(record.minimal == (verdict == "minimal") &&
               record.camera_minimal == (verdict == "camera-minimal"),
           "evidence of the verdict");
    demand(at + (record.minimal ? 1 : 3 + record.kernel.size()) == file.lines.size(), "the end");
    demand(record.number == number_of(lifted) && record.pool == 1, "the number of the class");
    const Problem& posed = obstructed ? lifted : problem;
    demand(pool.features.size() == posed.size(), "the features of the problem");
    for (std::size_t i = 0; i < posed.size(); ++i)
        demand(pool.features[i].feature == posed[i], "the features of the problem");
    examine(record, jacobian(pool.features, pool.cameras), posed);
}

template <class Examination>
std::optional<std::string> objection(Examination examination) {
    try {
        examination();
    } catch (const std::exception& error) { // an Objection, a NotationError, an empty line
        return error.what();
    }
    return std::nullopt;
}

} // namespace

Text split(std::string_view file) {
    Text text;
    for (std::size_t number = 1; !file.empty(); ++number) {
        std::string_view line = file.substr(0, file.find('\n'));
        file.remove_prefix(std::min(line.size() + 1, file.size()));
        if (number > 1 && line.starts_with("#")) continue;
        Words& words = text.lines.emplace_back();
        text.numbers.push_back(number);
        do {
            words.emplace_back(line.substr(0, line.find(' ')));
            line.remove_prefix(std::min(words.back().size() + 1, line.size()));
        } while (!line.empty());
    }
    return text;
}

std::optional<std::string> objection_to_problem(const Text& file) {
    return objection([&] { examine_problem(file); });
}

std::optional<std::string> objection_to_record(const Text& file, std::size_t line,
                                               const plprove::Signature& signature) {
    return objection([&] {
        const auto at = std::ranges::find(file.numbers, line) - file.numbers.begin();
        const Record record = read_record(file, static_cast<std::size_t>(at));
        const Pool pool = pool_of(file, record.pool);
        const Problem problem = plprove::problem_of(signature);
        demand(record.minimal == (plprove::obstruction(problem).deficiency() == 0), "the verdict");
        examine(record, jacobian(used(pool, signature), pool.cameras), problem);
    });
}

std::optional<std::uint64_t> true_minor(const Text& file, std::size_t line,
                                        const std::optional<plprove::Signature>& signature) {
    std::optional<std::uint64_t> minor;
    objection([&] {
        const Record record = read_record(file, line);
        const Pool all = [&] {
            if (signature) return pool_of(file, record.pool);
            const auto is_pool = [](const Words& words) { return words[0] == "pool"; };
            auto at = static_cast<std::size_t>(std::ranges::find_if(file.lines, is_pool) -
                                               file.lines.begin());
            const bool two_views = at + 2 < file.lines.size() && file.lines[at + 2][0] != "camera";
            return read_pool(file, at, two_views ? 2 : 3);
        }();
        const Jacobian j = jacobian(signature ? used(all, *signature) : all.features, all.cameras);
        minor = minor_without(j, record.rows, deleted_columns(record, j));
    });
    return minor;
}

} // namespace referee
