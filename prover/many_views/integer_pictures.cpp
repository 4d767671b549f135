#include "prover/many_views/integer_pictures.h"

#include "prover/format/certificate_text.h"

#include <cmath>

namespace plprove::many_views {

namespace {

constexpr int largest_factor = 5;

int random_integer(int largest, Random& random) {
    return static_cast<int>(std::floor((random.real() + 1) / 2 * (2 * largest + 1))) - largest;
}

/// What one view sees.
std::vector<int> random_numbers(const Problem& problem, int largest_coordinate, Random& random) {
    std::vector<int> numbers;
    const auto add = [&](std::size_t count, int largest) {
        for (; count > 0; --count)
            numbers.push_back(random_integer(largest, random));
    };
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        if (carrier(problem, static_cast<int>(p)))
            add(2, largest_factor);
        else
            add(3, largest_coordinate);
    for (const Line& line : problem.lines)
        add(line.points.size() >= 2 ? 0 : 6 - 3 * line.points.size(), largest_coordinate);
    return numbers;
}

template <class Scalar>
ViewImages<Scalar> vectors_of(const Problem& problem, std::span<const int> numbers) {
    ViewImages<Scalar> view;
    const auto take = [&] {
        const Vector<Scalar> vector{Scalar(numbers[0]), Scalar(numbers[1]), Scalar(numbers[2])};
        numbers = numbers.subspan(3);
        return vector;
    };
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        if (!carrier(problem, static_cast<int>(p))) {
            view.points.push_back(take());
            continue;
        }
        view.points.push_back({Scalar(numbers[0]), Scalar(numbers[1]), Scalar(0)});
        numbers = numbers.subspan(2);
    }
    for (const Line& line : problem.lines) {
        auto& ends = view.lines.emplace_back();
        for (std::size_t end = line.points.size(); end < 2; ++end)
            ends[end] = take();
    }
    return view;
}

Vector<Complex> cross(const Vector<Complex>& a, const Vector<Complex>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether a vector is neither zero nor too long. Its coordinates are integers, exactly.
bool is_sound(const Vector<Complex>& vector) {
    constexpr double largest = 1e9;
    double size = 0;
    for (const Complex& x : vector)
        size = std::max(size, std::abs(x));
    return size > 0 && size <= largest;
}

/// Whether no point is another one of its carrier.
bool has_different_points(const Problem& problem, const ViewImages<Complex>& view) {
    for (std::size_t p = 0; p < view.points.size(); ++p)
        if (carrier(problem, static_cast<int>(p)) &&
            (view.points[p][0] == Complex(0) || view.points[p][1] == Complex(0)))
            return false;
    return true;
}

/// Whether the view meets the conditions of the format.
bool conforms(const Problem& problem, const ViewImages<Complex>& view) {
    const std::vector<Vector<Complex>> points = image_vectors(problem, view);
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Vector<Complex>& y = points[p];
        if (!is_sound(y) || y[2] == Complex(0)) return false;
        const auto carrier = plprove::carrier(problem, static_cast<int>(p));
        if (!carrier) continue;
        const auto& on_it = problem.lines[static_cast<std::size_t>(*carrier)].points;
        const Vector<Complex>& a = points[static_cast<std::size_t>(on_it[0])];
        if (y[2] * a[1] - y[1] * a[2] == Complex(0)) return false;
    }
    for (std::size_t line = 0; line < problem.lines.size(); ++line) {
        std::array<Vector<Complex>, 2> ends = view.lines[line];
        const auto& on_it = problem.lines[line].points;
        for (std::size_t n = 0; n < std::min<std::size_t>(2, on_it.size()); ++n)
            ends[n] = points[static_cast<std::size_t>(on_it[n])];
        if (!is_sound(cross(ends[0], ends[1]))) return false;
    }
    return true;
}

} // namespace

IntegerImages random_integer_images(const Problem& problem, int views, Random& random,
                                    int largest) {
    constexpr int most_tries = 10'000;
    IntegerImages images;
    for (int tries = 0; tries < most_tries; ++tries) {
        const std::vector<int> numbers = random_numbers(problem, largest, random);
        const ViewImages<Complex> view = vectors_of<Complex>(problem, numbers);
        if (!has_different_points(problem, view) || !conforms(problem, view)) continue;
        images.push_back(numbers);
        if (std::ssize(images) == views) return images;
    }
    throw FormatLimit("found no integer images whose coordinates the format allows: leave -o out");
}

Images<std::int64_t> exact_images(const Problem& problem, const IntegerImages& integers) {
    Images<std::int64_t> images;
    for (const std::vector<int>& numbers : integers)
        images.push_back(vectors_of<std::int64_t>(problem, numbers));
    return images;
}

Images<Complex> scaled(const Problem& problem, const IntegerImages& integers, double scale) {
    Images<Complex> images;
    for (const std::vector<int>& numbers : integers) {
        ViewImages<Complex> view = vectors_of<Complex>(problem, numbers);
        for (std::size_t p = 0; p < view.points.size(); ++p)
            if (!carrier(problem, static_cast<int>(p)))
                for (Complex& x : view.points[p])
                    x /= scale;
        for (auto& ends : view.lines)
            for (Vector<Complex>& end : ends)
                for (Complex& x : end)
                    x /= scale;
        images.push_back(view);
    }
    return images;
}

} // namespace plprove::many_views
