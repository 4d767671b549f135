// The degree engine: known degrees as laws, relations between degrees, the tracker against itself
// on other instruction sets, and certified solutions against the scene they must come from.
#include "prover/degree/degree.h"
#include "prover/degree/integer_images.h"
#include "prover/degree/scene.h"
#include "prover/degree/trace_test.h"
#include "prover/degree/tracking/multiple_doubles.h"
#include "prover/problem/spec.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <gmpxx.h>

using namespace plprove;

namespace {

std::size_t number_of(const std::string& notation) {
    const Signature signature = *signature_of(parse_spec(notation));
    return class_number(label_classes(), representative(signature));
}

DegreeRun run(std::size_t number) {
    return compute_degree(number, {});
}

DegreeOptions until(int target) {
    DegreeOptions options;
    options.target = target;
    return options;
}

/// All solutions of a class at random complex images.
struct Solved {
    CameraSystem system;
    Monodromy monodromy;

    explicit Solved(std::size_t number)
        : system(camera_system(label_classes()[number])), monodromy(system, 1, number) {
        monodromy.run(4, 0);
    }
};

} // namespace

TEST_CASE("published degrees come out, complete by evidence, with a certificate for all of them") {
    for (const auto& [notation, degree] :
         {std::pair("2*Pa/Pa/Pa + P/P/P", 312), std::pair("3*P/P/P + a/a/a", 216)}) {
        CAPTURE(notation);
        const DegreeRun result = run(number_of(notation));
        CHECK(result.degree == degree);
        CHECK(result.complete());
        REQUIRE(result.certificate);
        CHECK(result.certificate->degree() == degree);
    }
}

TEST_CASE(
    "five points in two views leave 20 relative poses, each with equally many third cameras") {
    // Views 2 and 3 share exactly five points.
    const Solved solved(number_of("2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P"));
    const SolutionSet& solutions = solved.monodromy.solutions();
    CHECK(solutions.size() % 20 == 0);
    // The relative rotation R_3 R_2^T, which is the quaternion q_3 q_2^* up to scale.
    std::vector<std::pair<std::array<Complex, 3>, int>> poses;
    for (const CameraPoint& point : solutions.points()) {
        const QuaternionCameras cameras = solved.monodromy.chart().cameras(point);
        const auto& [a, b, c, d] = cameras.quaternion[1];
        const auto& [e, f, g, h] = cameras.quaternion[0];
        const Complex scale = a * e + b * f + c * g + d * h;
        const std::array<Complex, 3> pose{(b * e - a * f + d * g - c * h) / scale,
                                          (c * e - a * g + b * h - d * f) / scale,
                                          (d * e - a * h + c * f - b * g) / scale};
        const auto known = std::ranges::find_if(poses, [&](const auto& other) {
            double distance = 0, size = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                distance += std::abs(other.first[k] - pose[k]);
                size += std::abs(pose[k]);
            }
            return distance < 1e-5 * size;
        });
        if (known == poses.end())
            poses.emplace_back(pose, 1);
        else
            ++known->second;
    }
    CHECK(poses.size() == 20);
    for (const auto& pose : poses)
        CHECK(pose.second == solutions.size() / 20);
}

TEST_CASE(
    "degrees do not change under swap, exchange and relabeling, tracked from other equations") {
    const std::string base = "2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P";
    const Signature signature = *signature_of(parse_spec(base));
    Signature swapped = signature;
    std::swap(swapped[12], swapped[13]);
    CHECK(run(class_number(label_classes(), representative(signature))).degree ==
          run(class_number(label_classes(), representative(swapped))).degree);

    // The exchange of P/a/a for Pab/b/a.
    const Signature one = *signature_of(parse_spec("2*P/P/P + a/P/Pa + 2*-/P/P + P/a/a"));
    Signature exchanged = one;
    std::swap(exchanged[21], exchanged[24]);
    const DegreeRun left = run(class_number(label_classes(), representative(one)));
    const DegreeRun right = run(class_number(label_classes(), representative(exchanged)));
    CHECK(left.complete());
    CHECK(right.complete());
    CHECK(left.degree == right.degree);

    // The views in another order.
    const CameraSystem system = camera_system(relabelings(signature)[3]);
    Monodromy monodromy(system, 2, 0);
    monodromy.run(5, 0);
    CHECK(monodromy.solutions().size() == 240);
}

TEST_CASE("the trace test finds a single missing solution") {
    const Solved solved(number_of("2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P"));
    const auto residual = [&](std::span<const CameraPoint> solutions) {
        Random random(3, 0);
        return *trace_residual(solved.system, solved.monodromy.chart(),
                               solved.monodromy.constants(), solved.monodromy.images(), solutions,
                               random);
    };
    const std::vector<CameraPoint>& all = solved.monodromy.solutions().points();
    CHECK(residual(all) < 1e-12);
    for (const std::size_t missing : {std::size_t{0}, all.size() / 2, all.size() - 1}) {
        std::vector<CameraPoint> part = all;
        part.erase(part.begin() + static_cast<std::ptrdiff_t>(missing));
        CHECK(residual(part) > 1e-5);
    }
}

TEST_CASE("a trace test that cannot fail is none") {
    // The image lines fix both rotations, and the points then the centres, by linear equations.
    const Solved solved(number_of("Pabcdef/Pabcdef/Pabcdef + -/P/P + P/-/P"));
    CHECK(solved.monodromy.solutions().size() == 64);
    Random random(3, 0);
    CHECK_FALSE(trace_residual(solved.system, solved.monodromy.chart(),
                               solved.monodromy.constants(), solved.monodromy.images(),
                               solved.monodromy.solutions().points(), random));
}

TEST_CASE("a run that takes a degenerate end of a path for a solution is made again") {
    const DegreeRun run = compute_degree(92746, {.certificate = false});
    CHECK(run.degree == 640);
    CHECK(run.complete());
    CHECK(run.notes == std::vector<std::string>{"attempt 2: others fell short"});
}

TEST_CASE("an edge that lost a path is reported, and does not count") {
    const DegreeRun run = compute_degree(8984, {.certificate = false});
    CHECK(run.degree == 1048);
    REQUIRE(run.complete());
    CHECK(run.evidence->edges == 2);
    REQUIRE(run.notes.size() == 1);
    CHECK(run.notes[0].find(" edges are no bijections: ") != std::string::npos);
}

TEST_CASE("what doubles lose arrives with two or three times as many digits") {
    // Here many paths pass by cameras that are nearly degenerate.
    const CameraSystem system = camera_system(label_classes()[257]);
    Monodromy monodromy(system, 0, 257);
    monodromy.run(3, 600);
    Random random(13, 0);
    const TrackedImages images = moving_images(
        system, monodromy.constants(), monodromy.images(),
        rephased(random_neighbour(monodromy.images(), random), Phases::near_one, random));
    const std::vector<CameraPoint>& starts = monodromy.solutions().points();
    PathFollower follower(tracked_system(system, monodromy.chart()));
    const auto lost = [](const std::vector<CameraPoint>& from, const PathFollower::Ends& ends) {
        std::vector<CameraPoint> result;
        for (std::size_t i = 0; i < from.size(); ++i)
            if (!ends[i]) result.push_back(from[i]);
        return result;
    };
    const auto quickly = lost(starts, follower.follow_quickly(images, starts));
    const auto lost_again = lost(quickly, follower.follow_double_double(images, quickly));
    CHECK(quickly.size() > 10);
    CHECK(lost_again.size() == 1);
    CHECK(follower.counts().failed == 1);
    CHECK(lost(lost_again, follower.follow_triple_double(images, lost_again)).empty());
    CHECK(follower.counts().failed == 0);
}

namespace {

using plprove::PLC_LANES::DoubleDouble;
using plprove::PLC_LANES::Real;
using plprove::PLC_LANES::TripleDouble;

mpq_class exact(Real x) {
    return mpq_class(at(x, 0));
}
mpq_class exact(DoubleDouble x) {
    return exact(x.high) + exact(x.low);
}
mpq_class exact(TripleDouble x) {
    return exact(x.high) + exact(x.middle) + exact(x.low);
}

/// Checks that the operations on such numbers are right up to 2^-bits, of the terms of a sum or the
/// value of a product or quotient, against exact arithmetic.
template <class Number>
void check_operations(int bits) {
    Random random(6, 0);
    const mpq_class small = mpq_class(1) / (mpz_class(1) << static_cast<unsigned>(bits));
    const auto number = [&] { // of parts that do not overlap, and of any size
        const double size = std::ldexp(1.0, static_cast<int>(40 * random.complex().real()));
        Number sum = Number::of(0);
        for (const int part : {0, 54, 108})
            sum = sum + Number::of(std::ldexp(random.complex().real(), -part) * size);
        return sum;
    };
    for (int i = 0; i < 1000; ++i) {
        const Number a = number(), b = number(), c = i % 2 == 0 ? number() : a * b;
        const mpq_class x = exact(a), y = exact(b), z = exact(c);
        const auto near = [&](const Number& computed, const mpq_class& value,
                              const mpq_class& scale) {
            return abs(exact(computed) - value) <= small * abs(scale);
        };
        CHECK(near(a + b, x + y, abs(x) + abs(y)));
        CHECK(near(a - b, x - y, abs(x) + abs(y)));
        CHECK(near(a * b, x * y, x * y));
        CHECK(near(a / b, x / y, x / y));
        CHECK(near(fma(a, b, c), x * y + z, abs(x * y) + abs(z)));
        CHECK(near(fnma(a, b, c), z - x * y, abs(x * y) + abs(z))); // cancels where c = a * b
    }
}

} // namespace

TEST_CASE("sums of two and three doubles have 30 and 45 digits at least") {
    check_operations<DoubleDouble>(100);
    check_operations<TripleDouble>(150);
}

TEST_CASE("every instruction set tracks the same paths to the same bits, with any precision") {
    const Solved solved(number_of("3*P/P/P + a/a/a"));
    const Monodromy& monodromy = solved.monodromy;
    Random random(4, 0);
    const Images to =
        rephased(random_neighbour(monodromy.images(), random), Phases::near_one, random);
    const TrackedSystem system = tracked_system(solved.system, monodromy.chart());
    const TrackedImages images =
        moving_images(solved.system, monodromy.constants(), monodromy.images(), to);
    std::vector<CameraPoint> starts = monodromy.solutions().points();
    starts.resize(21); // no multiple of a number of lanes
    const auto ends = [&](TrackFunction* track) {
        std::vector<CameraPoint> result(starts.size());
        std::vector<TrackOutcome> outcomes(starts.size());
        track(system, images, {}, starts.size(), starts.data(), result.data(), outcomes.data());
        CHECK(std::ranges::count(outcomes, TrackOutcome::arrived) >= 20);
        return result;
    };
    const std::vector<CameraPoint> expected = ends(portable::track);
    const std::vector<CameraPoint> expected_double_double = ends(portable::track_double_double);
    const std::vector<CameraPoint> expected_triple_double = ends(portable::track_triple_double);
    const TracePencil pencil{
        0, images, moving_images(solved.system, monodromy.constants(), to, to),
        moving_images(solved.system, monodromy.constants(), monodromy.images(), to)};
    const auto bends = [&](TraceFunction* trace) {
        std::vector<TraceTerm> terms(starts.size());
        trace(system, &pencil, 1, starts.size(), starts.data(), terms.data());
        std::vector<Complex> result;
        for (const TraceTerm& term : terms)
            result.push_back(term.quadratic);
        return result;
    };
    const std::vector<Complex> expected_bends = bends(portable::trace_terms);
    CHECK(ends(fastest_tracker()) == expected);
    CHECK(ends(fastest_double_double_tracker()) == expected_double_double);
    CHECK(ends(fastest_triple_double_tracker()) == expected_triple_double);
    CHECK(bends(fastest_trace()) == expected_bends);
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        CHECK(ends(avx2::track) == expected);
        CHECK(ends(avx2::track_double_double) == expected_double_double);
        CHECK(ends(avx2::track_triple_double) == expected_triple_double);
        CHECK(bends(avx2::trace_terms) == expected_bends);
    }
#endif
}

TEST_CASE("the same class and seed give the same certificate, another seed another one") {
    const std::size_t number = number_of("3*P/P/P + a/a/a");
    const auto values = [&](std::uint64_t seed) {
        DegreeOptions options;
        options.seed = seed;
        const DegreeRun found = compute_degree(number, options);
        std::vector<std::vector<std::int64_t>> result;
        for (const auto& solution : found.certificate->solutions)
            result.push_back(solution.values);
        return result;
    };
    CHECK(values(0) == values(0));
    CHECK(values(0) != values(1));
}

TEST_CASE("a run stops at its target, or shows that there are not so many solutions") {
    const std::size_t number = number_of("3*P/P/P + a/a/a");
    const DegreeRun part = compute_degree(number, until(100));
    CHECK(part.degree >= 100);
    CHECK(part.degree < 216);
    CHECK_FALSE(part.complete());
    CHECK(part.certificate->degree() >= 100);
    const DegreeRun all = compute_degree(number, until(300));
    CHECK(all.degree == 216);
    CHECK(all.complete());
}

namespace {

/// Numbers a + b i with rational a and b.
struct Gaussian {
    mpq_class re, im;
};
Gaussian operator+(const Gaussian& a, const Gaussian& b) {
    return {a.re + b.re, a.im + b.im};
}
Gaussian operator-(const Gaussian& a, const Gaussian& b) {
    return {a.re - b.re, a.im - b.im};
}
Gaussian operator*(const Gaussian& a, const Gaussian& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
Gaussian operator/(const Gaussian& a, const Gaussian& b) {
    const mpq_class square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}
Gaussian exactly(const Complex& z) {
    return {mpq_class(z.real()), mpq_class(z.imag())};
}
double size(const Gaussian& a) {
    return std::hypot(a.re.get_d(), a.im.get_d());
}

using Exact3 = std::array<Gaussian, 3>;

Gaussian dot(const Exact3& a, const Exact3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Exact3 exact_cross(const Exact3& a, const Exact3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact3 difference(const Exact3& a, const Exact3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double size(const Exact3& a) {
    return size(a[0]) + size(a[1]) + size(a[2]);
}

/// A camera with rational coordinates: x -> R (x - c).
struct ExactCamera {
    std::array<Exact3, 3> rows;
    Exact3 centre;

    ExactCamera(const std::array<Complex, 4>& quaternion, const Complex3& at) {
        for (std::size_t k = 0; k < 3; ++k)
            centre[k] = exactly(at[k]);
        std::array<Gaussian, 4> q;
        for (std::size_t k = 0; k < 4; ++k)
            q[k] = exactly(quaternion[k]);
        // The rotation of v is the imaginary part of q v q^*.
        const auto product = [](const std::array<Gaussian, 4>& a,
                                const std::array<Gaussian, 4>& b) {
            return std::array<Gaussian, 4>{a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                                           a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                                           a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
                                           a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
        };
        const Gaussian zero{}, one{1, 0};
        const std::array<Gaussian, 4> adjoint{q[0], zero - q[1], zero - q[2], zero - q[3]};
        for (std::size_t column = 0; column < 3; ++column) {
            std::array<Gaussian, 4> unit{};
            unit[column + 1] = one;
            const auto image = product(product(q, unit), adjoint);
            for (std::size_t row = 0; row < 3; ++row)
                rows[row][column] = image[row + 1];
        }
    }
    Exact3 turn(const Exact3& d) const {
        return {dot(rows[0], d), dot(rows[1], d), dot(rows[2], d)};
    }
    /// R^T x.
    Exact3 back(const Exact3& x) const {
        Exact3 result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = rows[0][k] * x[0] + rows[1][k] * x[1] + rows[2][k] * x[2];
        return result;
    }
};

Exact3 exactly(const std::array<int, 3>& x) {
    return {Gaussian{x[0], 0}, Gaussian{x[1], 0}, Gaussian{x[2], 0}};
}

/// Makes the scene of one feature from two views and sees it in all of them: how far the images are
/// from the given ones, relative to their size.
double reprojection_error(const FeatureImage& image, const std::array<ExactCamera, 3>& cameras) {
    std::array<std::vector<Exact3>, 3> lines;
    std::vector<std::size_t> with_point, with_lines;
    for (std::size_t v = 0; v < 3; ++v) {
        const ViewImage& view = image.views[v];
        for (const auto& line : view.lines)
            lines[v].push_back(view.point ? exact_cross(exactly(*view.point), exactly(line))
                                          : exactly(line));
        if (view.point) with_point.push_back(v);
        if (!view.lines.empty()) with_lines.push_back(v);
    }
    // A ray, that of the point or of any point on the free line, and the plane of a line in another
    // view that contains the point.
    const std::size_t i = with_point.empty() ? with_lines[0] : with_point[0];
    const Exact3 seen = with_point.empty() ? exact_cross(lines[i][0], exactly(std::array{3, 1, 4}))
                                           : exactly(*image.views[i].point);
    std::size_t j = 3;
    Exact3 plane;
    for (std::size_t v = 0; v < 3; ++v) {
        if (v == i || j < 3) continue;
        if (image.views[v].point)
            plane = exact_cross(exactly(*image.views[v].point), exactly(std::array{3, 1, 4}));
        else if (!lines[v].empty())
            plane = lines[v][0];
        else
            continue;
        j = v;
    }
    const Exact3 ray = cameras[i].back(seen), normal = cameras[j].back(plane);
    const Gaussian depth =
        dot(normal, difference(cameras[j].centre, cameras[i].centre)) / dot(normal, ray);
    Exact3 point;
    for (std::size_t k = 0; k < 3; ++k)
        point[k] = cameras[i].centre[k] + depth * ray[k];

    double worst = 0;
    const auto vanish = [&](double value, double scale) { worst = std::max(worst, value / scale); };
    for (std::size_t v = 0; v < 3; ++v) {
        const Exact3 x = cameras[v].turn(difference(point, cameras[v].centre));
        if (image.views[v].point) {
            const Exact3 given = exactly(*image.views[v].point);
            vanish(size(exact_cross(x, given)), size(x) * size(given));
        }
    }
    for (int line = 0; line < image.feature.lines; ++line) {
        std::vector<std::pair<std::size_t, Exact3>> seen_lines;
        std::array<std::size_t, 3> next{};
        for (int view = 0; view < 3; ++view) {
            const auto v = static_cast<std::size_t>(view);
            for (int other = 0; other < line; ++other)
                next[v] += image.feature.sees_line(view, other);
            if (image.feature.sees_line(view, line)) seen_lines.emplace_back(v, lines[v][next[v]]);
        }
        const Exact3 direction =
            exact_cross(cameras[seen_lines[0].first].back(seen_lines[0].second),
                        cameras[seen_lines[1].first].back(seen_lines[1].second));
        for (const auto& [v, given] : seen_lines) {
            const Exact3 x = cameras[v].turn(difference(point, cameras[v].centre));
            const Exact3 d = cameras[v].turn(direction);
            vanish(size(dot(given, x)), size(given) * size(x));
            vanish(size(dot(given, d)), size(given) * size(d));
        }
    }
    return worst;
}

} // namespace

TEST_CASE("certified cameras see the scene that they come from, in exact arithmetic") {
    for (const char* notation :
         {"2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P", "3*P/P/P + a/a/a", "Pab/Pab/Pab + 2*Pa/a/Pa"}) {
        CAPTURE(notation);
        const std::size_t number = number_of(notation);
        const DegreeRun result = compute_degree(number, until(40));
        REQUIRE(result.certificate);
        const DegreeCertificate& certificate = *result.certificate;
        REQUIRE(certificate.degree() >= 40);
        // The starting values, as close to the solutions as doubles can be.
        const CameraSystem system = camera_system(label_classes()[number]);
        Images images;
        for (const FeatureImage& image : certificate.images)
            for (const ViewImage& view : image.views) {
                const auto add = [&](const std::array<int, 3>& x) {
                    images.push_back({static_cast<double>(x[0]), static_cast<double>(x[1]),
                                      static_cast<double>(x[2])});
                };
                if (view.point) add(*view.point);
                for (const auto& line : view.lines)
                    add(line);
            }
        std::vector<CameraPoint> starts;
        for (const ApproximateSolution& solution : certificate.solutions) {
            CameraPoint& start = starts.emplace_back();
            for (std::size_t k = 0; k < start.size(); ++k) {
                const std::size_t at = solution.real ? k : 2 * k;
                const auto value = [&](std::size_t i) {
                    return std::ldexp(static_cast<double>(solution.values[i]), -solution.bits);
                };
                start[k] = {value(at), solution.real ? 0 : value(at + 1)};
            }
        }
        TrackSettings settings;
        settings.first_step = settings.largest_step = 1;
        std::vector<CameraPoint> ends(starts.size());
        std::vector<TrackOutcome> outcomes(starts.size());
        fastest_double_double_tracker()(
            tracked_system(system, standard_chart()),
            moving_images(system, standard_constants(system), images, images), settings,
            starts.size(), starts.data(), ends.data(), outcomes.data());
        const ExactCamera first({1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
        for (std::size_t i = 0; i < ends.size(); i += 5) {
            REQUIRE(outcomes[i] == TrackOutcome::arrived);
            const QuaternionCameras cameras = standard_chart().cameras(ends[i]);
            const std::array<ExactCamera, 3> exact{
                first, ExactCamera(cameras.quaternion[0], cameras.centre[0]),
                ExactCamera(cameras.quaternion[1], cameras.centre[1])};
            for (const FeatureImage& image : certificate.images)
                CHECK(reprojection_error(image, exact) < 1e-8);
        }
    }
}
