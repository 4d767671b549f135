#include "tests/checker/degrees/instances.h"

#include <Eigen/Dense>

#include <sstream>

using namespace checker;

namespace instances {
std::size_t class_with(std::initializer_list<std::size_t> wanted) {
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        const auto has = [&](std::size_t i) { return s[i] > 0; };
        if (is_minimal_class(n) && std::all_of(wanted.begin(), wanted.end(), has)) return n;
    }
    return 0;
}

const std::vector<std::size_t>& all_kinds() {
    static const std::vector<std::size_t> numbers = [] {
        std::vector<std::size_t> some{2394, 6722};
        for (std::size_t i = 1; i < feature_count; ++i)
            some.push_back(class_with({i}));
        return some;
    }();
    return numbers;
}

Space centre_of(const RationalCameras& cameras, std::size_t view) {
    if (view == 0) return {0, 0, 0};
    if (view == 1) return {1, cameras[6], cameras[7]};
    return {cameras[8], cameras[9], cameras[10]};
}

Space turned(const RationalCameras& cameras, std::size_t view, const Space& x) {
    if (view == 0) return x;
    const auto* q = &cameras[3 * view - 3];
    const Rational b = q[0], c = q[1], d = q[2];
    return {(1 + b * b - c * c - d * d) * x[0] + 2 * (b * c - d) * x[1] + 2 * (b * d + c) * x[2],
            2 * (b * c + d) * x[0] + (1 - b * b + c * c - d * d) * x[1] + 2 * (c * d - b) * x[2],
            2 * (b * d - c) * x[0] + 2 * (c * d + b) * x[1] + (1 - b * b - c * c + d * d) * x[2]};
}

Space image_of(const RationalCameras& cameras, std::size_t view, const Space& point) {
    return turned(cameras, view, minus(point, centre_of(cameras, view)));
}

std::array<mpz_class, 3> coprime(const Space& vector) {
    mpz_class scale = 1, divisor = 0;
    for (const Rational& c : vector)
        scale = lcm(scale, c.get_den());
    std::array<mpz_class, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = vector[i].get_num() * (scale / vector[i].get_den());
        divisor = gcd(divisor, result[i]);
    }
    if (divisor != 0)
        for (mpz_class& c : result)
            c /= divisor;
    return result;
}

static Instance random_instance(std::size_t number, Random& random) {
    Instance instance;
    for (std::size_t i = 0; i < camera_unknowns; ++i)
        instance.cameras[i] = Rational(random(i < 6 ? 4 : 9), i < 6 ? 4 : 2);
    for (std::size_t i = 0; i < feature_count; ++i) {
        for (unsigned n = 0; n < all_classes().representatives[number][i]; ++n) {
            instance.features.push_back(i);
            auto& points = instance.points.emplace_back();
            for (unsigned k = 0; k < features[i].pins + 1; ++k)
                points.push_back({random(9), random(9), random(9)});
        }
    }
    return instance;
}

Instance good_instance(std::size_t number, std::uint64_t seed) {
    Random random{std::mt19937_64(seed)};
    while (true) {
        const Instance instance = random_instance(number, random);
        try {
            const CameraSystem system = system_of(instance);
            BackProjections<Rational> space;
            back_project(system, instance.cameras, space);
            if (degeneracy(system, instance.cameras, space).empty()) return instance;
        } catch (const Refused&) {
        }
    }
}

/// An integer vector with at most 6 digits, up to scale.
static std::string integers(const Space& vector) {
    std::string text;
    for (const mpz_class& c : coprime(vector)) {
        REQUIRE(abs(c) <= 999'999);
        text += " " + c.get_str();
    }
    return text;
}

std::string image_lines(const Instance& instance) {
    std::string text;
    for (std::size_t f = 0; f < instance.features.size(); ++f) {
        const Feature& feature = features[instance.features[f]];
        text += say("image ", feature.notation);
        for (std::size_t v = 0; v < 3; ++v) {
            if (!has_view(feature.views, v)) continue;
            text += " view";
            const bool sees_point = has_view(feature.point, v);
            const auto see = [&](std::size_t k) {
                return image_of(instance.cameras, v, instance.points[f][k]);
            };
            if (sees_point) text += " point" + integers(see(0));
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!has_view(feature.pin[pin], v)) continue;
                text += sees_point ? " toward" + integers(see(pin + 1))
                                   : " line" + integers(cross(see(0), see(pin + 1)));
            }
        }
        text += "\n";
    }
    return text;
}

/// Takes the next word, and a vector.
static Image take_vector(std::istream& words) {
    std::string word;
    Image x;
    words >> word >> x[0] >> x[1] >> x[2];
    return x;
}

CameraSystem system_of(const Instance& instance) {
    CameraSystem system;
    std::istringstream words(image_lines(instance));
    for (const std::size_t index : instance.features) {
        const Feature& feature = features[index];
        FeatureImages images;
        std::string word;
        words >> word >> word;
        for (std::size_t v = 0; v < 3; ++v) {
            if (!has_view(feature.views, v)) continue;
            words >> word;
            const bool sees_point = has_view(feature.point, v);
            if (sees_point) images.point[v] = take_vector(words);
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!has_view(feature.pin[pin], v)) continue;
                Image& line = images.line[pin][v];
                line = take_vector(words);
                if (sees_point) line = cross(images.point[v], line);
            }
        }
        add_feature(system, feature, images);
    }
    return system;
}

std::string record(std::size_t number, const Instance& instance) {
    return say("degree ", number, " evidence none\n", image_lines(instance));
}

ComplexCameras approximate(const RationalCameras& exact) {
    ComplexCameras z;
    for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = exact[i].get_d();
    return z;
}

std::string solution_line(const ComplexCameras& cameras, bool real) {
    constexpr int bits = 50;
    std::string line = say(real ? "real " : "pair ", bits);
    for (const Complex& x : cameras) {
        line += say(" ", std::llround(std::ldexp(x.real(), bits)));
        if (!real) line += say(" ", std::llround(std::ldexp(x.imag(), bits)));
    }
    return line + "\n";
}

const Instance& example() {
    static const Instance instance = good_instance(chicago);
    return instance;
}

const std::string& example_images() {
    static const std::string text = record(chicago, example());
    return text;
}

std::string example_solution() {
    return solution_line(approximate(example().cameras), true);
}

/// Where Newton's method leads from z: how far the last step moved.
static double settle(const CameraSystem& system, ComplexCameras& z) {
    BackProjections<Complex> space;
    double moved = 1;
    for (int step = 0; step < 40 && moved > 1e-13; ++step) {
        back_project(system, z, space);
        Eigen::Matrix<Complex, 11, 11> jacobian;
        Eigen::Matrix<Complex, 11, 1> values;
        for (std::size_t e = 0; e < 11; ++e) {
            ComplexCameras row;
            values[Eigen::Index(e)] = evaluate(system, system.equations[e], space, row);
            for (std::size_t k = 0; k < 11; ++k)
                jacobian(Eigen::Index(e), Eigen::Index(k)) = row[k];
        }
        const Eigen::Matrix<Complex, 11, 1> change = jacobian.partialPivLu().solve(values);
        moved = change.norm();
        for (std::size_t k = 0; k < 11; ++k)
            z[k] -= change[Eigen::Index(k)];
    }
    return moved;
}

std::vector<ComplexCameras> hunt(const CameraSystem& system, std::size_t tries) {
    std::vector<ComplexCameras> found;
    std::mt19937_64 engine{3};
    std::normal_distribution<double> normal;
    while (tries-- > 0) {
        ComplexCameras z;
        for (Complex& x : z)
            x = {normal(engine), normal(engine)};
        const double moved = settle(system, z);
        const auto moderate = [](const Complex& x) { return std::abs(x) < 200; };
        if (moved < 1e-12 && std::all_of(z.begin(), z.end(), moderate)) found.push_back(z);
    }
    return found;
}

static FileContent content_of(const std::string& records) {
    return replay(all_classes(), "file", "plcert 2 degrees\n" + records).content;
}

DegreeFile replayed(const std::string& records) {
    const FileContent content = content_of(records);
    REQUIRE(std::holds_alternative<DegreeFile>(content));
    return std::get<DegreeFile>(content);
}

std::string refusal(const std::string& records) {
    const DegreeFile file = replayed(records);
    CHECK(file.bounds.empty());
    REQUIRE(file.refusals.count == 1);
    return say(file.refusals.first[0].line, ": ", file.refusals.first[0].reason);
}

std::string violation(const std::string& records) {
    const FileContent content = content_of(records);
    REQUIRE(std::holds_alternative<Malformed>(content));
    const Complaint& complaint = std::get<Malformed>(content).complaint;
    return say(complaint.line, ": ", complaint.reason);
}
} // namespace instances
