#include "tests/fake_engine/fake_engine.h"

#include "prover/three_views/integer_vectors.h"

#include <random>
#include <stdexcept>

namespace fake_engine {

using namespace plprove;

namespace {

IntegerVector triple(std::mt19937_64& random) {
    const auto coordinate = [&] { return static_cast<std::int64_t>(random() % 1999) - 999; };
    return {coordinate(), coordinate(), 1 + coordinate() % 7};
}

FeatureImage image_of(const Feature& feature, std::mt19937_64& random) {
    FeatureImage image{feature, {}};
    for (int view = 0; view < feature.views(); ++view) {
        ViewImage seen;
        if (feature.sees_point(view)) seen.point = triple(random);
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line)) seen.lines.push_back(triple(random));
        image.views.push_back(seen);
    }
    return image;
}

DegreeCertificate certificate_of(const DegreeRun& run, std::uint64_t seed) {
    std::mt19937_64 random(run.number + (seed << 32U));
    DegreeCertificate certificate;
    certificate.number = run.number;
    for (const Feature& feature : problem_of(label_classes()[run.number]))
        certificate.images.push_back(image_of(feature, random));
    for (int left = run.degree; left > 0;) {
        StartingValues solution{left % 2 == 1, 40, {}};
        solution.values.resize(solution.real ? 11 : 22);
        for (std::int64_t& value : solution.values)
            value = static_cast<std::int64_t>(random() % 2'000'000'000'000) - 1'000'000'000'000;
        left -= solution.real ? 1 : 2;
        certificate.solutions.push_back(std::move(solution));
    }
    return certificate;
}

} // namespace

int degree(std::size_t number) {
    return 1 + static_cast<int>(number * 7919 % 60);
}

bool throws(std::size_t number) {
    return number % 97 == 5;
}

bool falls_short(std::size_t number) {
    return number % 89 == 7;
}

DegreeRun compute(std::size_t number, const DegreeOptions& options) {
    if (throws(number))
        throw std::runtime_error("the fake engine does not like \"" + std::to_string(number) +
                                 "\"");
    DegreeRun run;
    run.number = number;
    run.degree = degree(number);
    const bool stopped = options.target > 0 && run.degree >= options.target;
    if (stopped) run.degree = options.target;
    if (falls_short(number))
        run.notes = {"the fake engine is tired", "and \xFF not even UTF-8"};
    else if (!stopped)
        run.complete = true;
    if (falls_short(number)) run.degree = 1;
    run.tracks = 10 * number;
    run.retried = number % 3;
    run.failed = number % 2;
    run.certificate = certificate_of(run, options.seed);
    return run;
}

} // namespace fake_engine
