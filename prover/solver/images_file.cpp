#include "prover/solver/images_file.h"

#include "prover/problem/spec.h"
#include "prover/solver/exact_json.h"
#include "prover/system/exit.h"
#include "prover/system/words.h"

#include <algorithm>
#include <initializer_list>
#include <regex>

namespace plprove {

std::optional<mpq_class> exact_number(const std::string& text) {
    constexpr std::size_t longest = 100;
    constexpr long largest_exponent = 100;
    static const std::regex fraction("([-+]?[0-9]+)/([0-9]+)");
    static const std::regex decimal("([-+]?)([0-9]+)(?:\\.([0-9]+))?(?:[eE]([-+]?[0-9]{1,3}))?");
    if (text.size() > longest) return std::nullopt;
    const auto integer = [](std::string digits) {
        if (digits.starts_with('+')) digits.erase(0, 1);
        return mpz_class(digits, 10);
    };
    std::smatch match;
    if (std::regex_match(text, match, fraction)) {
        const mpz_class denominator = integer(match[2]);
        if (denominator == 0) return std::nullopt;
        mpq_class value(integer(match[1]), denominator);
        value.canonicalize();
        return value;
    }
    if (!std::regex_match(text, match, decimal)) return std::nullopt;
    const std::string places = match[3];
    const long exponent = match[4].matched ? std::stol(match[4]) : 0;
    if (std::abs(exponent) > largest_exponent) return std::nullopt;
    const long shift = exponent - static_cast<long>(places.size());
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(shift)));
    mpq_class value(integer(match[2].str() + places));
    if (match[1] == "-") value = -value;
    return shift < 0 ? mpq_class(value / power) : mpq_class(value * power);
}

namespace {

using Json = nlohmann::json;

constexpr std::size_t longest_quote = 60;  // of a file, in a message
constexpr std::size_t longest_error = 300; // that the parser tells of

/// A value of the file, and where it is.
class Field {
public:
    /// The place of the file itself is empty.
    Field(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

    [[noreturn]] void expect(const std::string& expected) const {
        throw BadInput(place() + ": expected " + expected + ", found " +
                       printable(json_.dump(), longest_quote));
    }

    /// Says what to give in place of what there is, without quoting it.
    [[noreturn]] void refuse(const std::string& advice) const {
        throw BadInput(place() + ": " + advice);
    }

    bool is_null() const { return json_.is_null(); }
    bool is_object() const { return json_.is_object(); }
    bool is_list() const { return json_.is_array(); }

    std::vector<Field> list(const std::string& expected) const {
        if (!json_.is_array()) expect(expected);
        std::vector<Field> fields;
        for (std::size_t i = 0; i < json_.size(); ++i)
            fields.emplace_back(json_[i], place_ + "[" + std::to_string(i) + "]");
        return fields;
    }

    /// Refuses what is no object, and members that have other names.
    void require_object(const std::vector<std::string>& names) const {
        if (!is_object()) expect("an object");
        for (const auto& [name, value] : json_.items())
            if (std::ranges::find(names, name) == names.end()) {
                std::string known;
                for (const std::string& one : names)
                    known += (known.empty() ? "" : ", ") + one;
                throw BadInput(place() + ": there is no member called \"" +
                               printable(name, longest_quote) + "\" here, but " +
                               (known.empty() ? "none" : known));
            }
    }

    std::optional<Field> find(const std::string& name) const {
        const auto found = json_.find(name);
        if (found == json_.end()) return std::nullopt;
        return Field(*found, place_.empty() ? name : place_ + "." + name);
    }

    Field at(const std::string& name) const {
        const auto found = find(name);
        if (!found) expect("the member \"" + name + "\"");
        return *found;
    }

    mpq_class number() const {
        constexpr const char* expected = "a number, such as 12.5, or a fraction, such as \"1/3\"";
        if (!json_.is_string()) expect(expected);
        const auto value = exact_number(json_.get<std::string>());
        if (!value) expect(expected);
        return *value;
    }

    std::string text() const {
        if (!json_.is_string()) expect("a text");
        return json_.get<std::string>();
    }

    /// A text that does nothing to a terminal.
    std::string name() const {
        const std::string name = text();
        if (has_control_character(name)) expect("a name without control characters");
        return name;
    }

private:
    std::string place() const { return place_.empty() ? "the file" : place_; }

    const Json& json_;
    std::string place_;
};

std::array<mpq_class, 2> read_point(const Field& field) {
    const auto numbers = field.list("a point [x, y]");
    if (numbers.size() != 2) field.expect("a point [x, y]");
    return {numbers[0].number(), numbers[1].number()};
}

ExactVector read_coefficients(const std::vector<Field>& numbers) {
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

GivenLine read_line(const Field& field) {
    constexpr const char* expected =
        "a line: two points [[x, y], [x, y]], or the coefficients [a, b, c] of a x + b y + c = 0";
    const auto parts = field.list(expected);
    if (parts.size() == 3) {
        GivenLine line{read_coefficients(parts), {}};
        if (line.coefficients[0] == 0 && line.coefficients[1] == 0)
            field.expect("a line [a, b, c] with a or b different from 0");
        return line;
    }
    if (parts.size() != 2) field.expect(expected);
    const auto p = read_point(parts[0]), q = read_point(parts[1]);
    if (p == q) field.expect("two different points of a line");
    return {{p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]}, {p, q}};
}

std::array<ExactVector, 3> read_matrix(const Field& field) {
    constexpr const char* expected =
        "an upper triangular 3x3 matrix [[fx, s, cx], [0, fy, cy], [0, 0, 1]]";
    std::array<ExactVector, 3> K;
    const auto rows = field.list(expected);
    if (rows.size() != 3) field.expect(expected);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto numbers = rows[i].list(expected);
        if (numbers.size() != 3) field.expect(expected);
        K[i] = read_coefficients(numbers);
    }
    if (K[1][0] != 0 || K[2][0] != 0 || K[2][1] != 0 || K[2][2] != 1) field.expect(expected);
    return K;
}

std::array<ExactVector, 3> read_camera(const Field& field) {
    std::array<ExactVector, 3> K{ExactVector{1, 0, 0}, ExactVector{0, 1, 0}, ExactVector{0, 0, 1}};
    if (field.is_null()) return K;
    if (field.is_object() && field.find("K")) {
        field.require_object({"K"});
        K = read_matrix(field.at("K"));
    } else {
        field.require_object({"fx", "fy", "cx", "cy"});
        K[0] = {field.at("fx").number(), 0, field.at("cx").number()};
        K[1] = {0, field.at("fy").number(), field.at("cy").number()};
    }
    if (K[0][0] <= 0 || K[1][1] <= 0) field.expect("positive focal lengths");
    return K;
}

GivenSighting read_sighting(const Field& field, const Feature& feature, int view) {
    GivenSighting sighting;
    sighting.lines.resize(static_cast<std::size_t>(feature.lines));
    const bool sees_point = feature.sees_point(view);
    const auto shared = static_cast<int>(feature.shared.size());
    std::vector<std::string> letters;
    for (int line = shared; line < feature.lines; ++line)
        if (feature.sees_line(view, line)) letters.emplace_back(1, letter_of(feature, line));
    if (!sees_point && letters.empty()) {
        if (!field.is_null()) field.expect("null: this view sees nothing of " + notation(feature));
        return sighting;
    }
    std::vector<std::string> members;
    if (sees_point) members.emplace_back("point");
    if (!letters.empty()) members.emplace_back("lines");
    if (field.is_null()) field.expect("what this view sees of " + notation(feature));
    field.require_object(members);
    if (sees_point) {
        const auto [x, y] = read_point(field.at("point"));
        sighting.point = ExactVector{x, y, 1};
    }
    if (letters.empty()) return sighting;
    const Field lines = field.at("lines");
    lines.require_object(letters);
    for (const std::string& name : letters)
        sighting.lines[static_cast<std::size_t>(shared + name[0] - 'a')] =
            read_line(lines.at(name));
    return sighting;
}

/// What the views see of a feature as the file has it, such as Pa/Pa/a; `?` where it is no feature.
std::string seen_in(const Field& feature) {
    const auto views = feature.is_object() ? feature.find("views") : std::nullopt;
    if (!views || !views->is_list()) return "?";
    std::string seen;
    for (const Field& view : views->list("")) {
        std::string sight;
        if (view.is_object()) {
            if (view.find("point")) sight += 'P';
            const auto lines = view.find("lines");
            if (lines && lines->is_object())
                for (char letter = 'a'; letter <= 'z'; ++letter)
                    if (lines->find(std::string(1, letter))) sight += letter;
        }
        seen += (seen.empty() ? "" : "/") + (sight.empty() ? "-" : sight);
    }
    return seen.empty() ? "?" : seen;
}

/// Refuses the features, as they are not as many as those of the problem.
[[noreturn]] void refuse_number(const Field& field, const std::vector<Field>& features,
                                const Features& problem) {
    std::string given;
    for (const Field& feature : features)
        given += (given.empty() ? "" : " + ") + seen_in(feature);
    field.refuse("these are " + std::to_string(features.size()) +
                 (given.empty() ? "" : ", " + printable(given, longest_quote)) + ": give the " +
                 std::to_string(problem.size()) + " of " + notation(problem) + ", in this order");
}

void read_features(const Field& field, GivenImages& images) {
    const auto features = field.list("a list of features");
    if (features.size() != images.problem.size()) refuse_number(field, features, images.problem);
    for (std::size_t f = 0; f < features.size(); ++f) {
        const Feature& feature = images.problem[f];
        features[f].require_object({"views", "name"});
        const auto name = features[f].find("name");
        images.names.push_back(name ? name->name() : "");
        const Field all = features[f].at("views");
        const auto views = all.list("a list of views");
        if (std::ssize(views) != feature.views())
            all.expect(std::to_string(feature.views()) + " views of " + notation(feature) +
                       "; these are " + std::to_string(views.size()));
        auto& sightings = images.features.emplace_back();
        for (std::size_t v = 0; v < views.size(); ++v)
            sightings.push_back(read_sighting(views[v], feature, static_cast<int>(v)));
    }
}

void read_cameras(const Field& file, GivenImages& images) {
    const auto views = static_cast<std::size_t>(images.problem.front().views());
    const auto field = file.find("cameras");
    if (!field) {
        images.calibration.assign(views, read_camera(Field(Json(), "cameras")));
        return;
    }
    if (images.general && images.general->cameras == &projective_cameras)
        field->refuse("uncalibrated cameras have no intrinsics: leave \"cameras\" out");
    const auto cameras = field->list("a list of cameras");
    if (cameras.size() != views)
        field->expect(std::to_string(views) + " cameras, one for each view; these are " +
                      std::to_string(cameras.size()));
    for (const Field& camera : cameras)
        images.calibration.push_back(read_camera(camera));
}

/// The problem that was asked for, which the file names, too, or that of the file.
ImagedProblem read_problem(const Field& file, const std::optional<ImagedProblem>& asked) {
    const auto field = file.find("problem");
    if (!field && !asked) file.expect("the member \"problem\"");
    if (!field) return *asked;
    const std::string text = field->text();
    const std::optional<Problem> general = parse_general_spec(text);
    const ImagedProblem problem = general ? ImagedProblem(*general) : parse_spec(text);
    if (asked && !(problem == *asked))
        field->expect("images of " + notation(*asked) + ", in the order of this notation");
    return problem;
}

} // namespace

GivenImages read_images(const std::string& text, const std::string& name,
                        const std::optional<ImagedProblem>& problem) {
    Json json;
    try {
        json = parse_exact_json(text);
    } catch (const std::invalid_argument& error) {
        throw BadInput(name + ": this is no JSON: " + printable(error.what(), longest_error));
    }
    try {
        const Field file(json, "");
        file.require_object({"problem", "cameras", "features"});
        GivenImages images;
        ImagedProblem imaged = read_problem(file, problem);
        images.problem = std::move(imaged.features);
        images.general = std::move(imaged.general);
        read_cameras(file, images);
        read_features(file.at("features"), images);
        return images;
    } catch (const BadInput& error) {
        throw BadInput(name + ": " + error.what());
    } catch (const NotationError& error) {
        throw BadInput(name + ": problem: " + error.what());
    }
}

} // namespace plprove
