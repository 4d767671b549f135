// Following solutions of equations while their data move: the part that all headers have in common
// which `plprove generate` writes. It is embedded in the program, without the lines that begin with
// `#`, and becomes part of a namespace. C++17 and its standard library alone.
//
// A class Equations says what is solved:
//
//     unknowns, data, conditions, counted, starts    how many there are; `counted` is 0 where all
//                                                    unknowns count
//     linearise<moving>(u, d, speed, a)    row i of the matrix a becomes the derivatives of
//     equation
//                                          i by the unknowns, its value and, if moving, its
//                                          derivative by time; u, d and speed are the unknowns, the
//                                          data and the derivatives of the data by time
//     find_conditions(u, d, out)           what must not vanish
//     find_counted(u, d, out)              what tells solutions apart
//     start_data, start_solutions          real and imaginary parts of numbers
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace detail {

/// A complex number. The products of std::complex look for infinities, which takes time.
struct Complex {
    double re = 0, im = 0;

    constexpr Complex() = default;
    constexpr Complex(double real, double imaginary = 0) : re(real), im(imaginary) {}
};

inline Complex operator+(Complex x, Complex y) {
    return {x.re + y.re, x.im + y.im};
}
inline Complex operator-(Complex x, Complex y) {
    return {x.re - y.re, x.im - y.im};
}
inline Complex operator*(Complex x, Complex y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}
inline Complex operator+(double x, Complex y) {
    return {x + y.re, y.im};
}
inline Complex operator-(double x, Complex y) {
    return {x - y.re, -y.im};
}
inline Complex operator*(double x, Complex y) {
    return {x * y.re, x * y.im};
}
inline Complex operator+(Complex x, double y) {
    return y + x;
}
inline Complex operator-(Complex x, double y) {
    return {x.re - y, x.im};
}
inline Complex operator*(Complex x, double y) {
    return y * x;
}
inline Complex operator-(Complex x) {
    return {-x.re, -x.im};
}
inline double square(Complex x) {
    return x.re * x.re + x.im * x.im;
}
inline double size(Complex x) {
    return std::sqrt(square(x));
}
inline bool is_finite(Complex x) {
    return std::isfinite(x.re) && std::isfinite(x.im);
}
inline Complex inverse(Complex x) {
    const double scale = 1 / square(x);
    return {x.re * scale, -x.im * scale};
}

/// The length of a point, where one more coordinate is 1.
template <class Point>
double length(const Point& point) {
    double sum = 1;
    for (const Complex x : point)
        sum += square(x);
    return std::sqrt(sum);
}

/// Whether all coordinates are near, each relative to its size.
template <class Point>
bool has_near_coordinates(const Point& point, const Point& other) {
    constexpr double near = 1e-7;
    for (std::size_t i = 0; i < point.size(); ++i)
        if (!(size(point[i] - other[i]) < near * (1 + size(other[i])))) return false;
    return true;
}

/// Random numbers, the same on any machine.
class Random {
public:
    /// Real and imaginary parts between -1 and 1.
    Complex number() {
        const double real = part(), imaginary = part();
        return {real, imaginary};
    }

private:
    double part() {
        // G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators, 2014.
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t bits = state_;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
        bits ^= bits >> 31;
        return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
    }

    std::uint64_t state_ = 1;
};

/// Linear equations for n unknowns: what is eliminated are rows with `columns` columns, of which
/// the first n are a square matrix.
template <std::size_t n, std::size_t columns>
class Elimination {
public:
    using Rows = std::array<std::array<Complex, columns>, n>;

    /// Makes the matrix upper triangular.
    void eliminate() {
        for (std::size_t k = 0; k < n; ++k) {
            choose_pivot(k);
            inverse_[k] = inverse(rows[k][k]);
            for (std::size_t i = k + 1; i < n; ++i) {
                if (rows[i][k].re == 0 && rows[i][k].im == 0) continue; // as most, where k is small
                const Complex factor = rows[i][k] * inverse_[k];
                for (std::size_t c = k + 1; c < columns; ++c)
                    rows[i][c] = rows[i][c] - factor * rows[k][c];
            }
        }
    }

    /// What the matrix has to be multiplied by to give a column.
    std::array<Complex, n> solution(std::size_t column) const {
        std::array<Complex, n> x;
        for (std::size_t i = n; i-- > 0;) {
            Complex sum = rows[i][column];
            for (std::size_t k = i + 1; k < n; ++k)
                sum = sum - rows[i][k] * x[k];
            x[i] = sum * inverse_[i];
        }
        return x;
    }

    Rows rows;

private:
    /// Newton's method makes up for the digits that a pivot costs which is not the largest one.
    void choose_pivot(std::size_t k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (square(rows[i][k]) > square(rows[best][k])) best = i;
        if (square(rows[k][k]) < square(rows[best][k]) / 4096) std::swap(rows[k], rows[best]);
    }

    std::array<Complex, n> inverse_;
};

/// Data that move, at times from 0 to 1: from some to others, and in between away from the straight
/// way by t (1 - t) times a bend.
template <class Equations>
class Way {
public:
    using Data = std::array<Complex, Equations::data>;

    Way(const Data& from, const Data& to, const Data& bend) : from_(from), bend_(bend) {
        for (std::size_t i = 0; i < from.size(); ++i)
            slope_[i] = to[i] - from[i] + bend[i];
    }

    Data at(double time) const {
        Data data;
        for (std::size_t i = 0; i < data.size(); ++i)
            data[i] = from_[i] + time * (slope_[i] - time * bend_[i]);
        return data;
    }
    Data speed_at(double time) const {
        Data speed;
        for (std::size_t i = 0; i < speed.size(); ++i)
            speed[i] = slope_[i] - 2 * time * bend_[i];
        return speed;
    }

private:
    Data from_, bend_, slope_;
};

/// How steps are chosen. Sizes are relative to the point of the path.
struct TrackSettings {
    double prediction = 1e-3;  ///< Newton's first correction that the step size aims at
    double contraction = 0.05; ///< the second correction is at most that much of the first ...
    double noise = 1e-6;       ///< ... or as small as rounding may make it
    double first_step = 0.01;
    double largest_step = 0.2;
    double smallest_step = 1e-10; ///< a path that wants a smaller one is lost
    int most_steps = 2000;        ///< a path that needs more is lost
};

/// Some five times the steps: these jump to other paths more rarely.
inline TrackSettings careful_settings() {
    TrackSettings settings;
    settings.prediction = 1e-6;
    settings.contraction = 0.005;
    settings.largest_step = 0.05;
    settings.most_steps = 20000;
    return settings;
}

/// Follows a solution on a way of the data. Each step predicts the next point from the last three
/// points of the path and the speeds there, and corrects it twice by Newton's method.
template <class Equations>
class Path {
public:
    static constexpr std::size_t n = Equations::unknowns;
    using Point = std::array<Complex, n>;

    Path(const Way<Equations>& way, const TrackSettings& settings, const Point& start)
        : way_(way), settings_(settings) {
        point_[0] = start;
    }

    /// Where the path ends; nothing if it gets lost.
    std::optional<Point> follow() {
        bool arrived = false;
        while (steps_ < settings_.most_steps) {
            ++steps_;
            const bool good = advance();
            if (good && arrived) return point_[0];
            if (good && time_[0] >= 1)
                arrived = true; // and corrected once more there
            else if (step_ < settings_.smallest_step)
                break;
        }
        return std::nullopt;
    }

    std::size_t steps() const { return static_cast<std::size_t>(steps_); }

private:
    /// A step; the first one goes nowhere, and finds the speed there. Whether it was good.
    bool advance() {
        const double time = std::min(time_[0] + step_, 1.0);
        Point point = predicted(time - time_[0]), speed{};
        const double first = correct<false>(time, point, speed);
        const double second = correct<true>(time, point, speed);

        // Sizes are squared. Comparisons with what is no number are false.
        const double goal = settings_.prediction * settings_.prediction;
        const double contraction = settings_.contraction * settings_.contraction;
        const bool quiet = second < settings_.noise * settings_.noise;
        const bool good = first < 64 * goal && (quiet || second < contraction * first);
        constexpr double tiny = 1e-40;
        double ratio = goal / (first + tiny);
        if (!quiet) ratio = std::min(ratio, contraction * first / (second + tiny));
        choose_step(good, ratio);
        if (good) remember(time, point, speed);
        return good;
    }

    /// The errors of predictions grow with the fourth or the sixth power of the step.
    void choose_step(bool good, double ratio) {
        const double root8 = std::sqrt(std::sqrt(std::sqrt(ratio)));
        if (good && known_ == 0) {
            step_ = settings_.first_step;
        } else if (good) {
            const double root16 = std::sqrt(root8);
            const double stretch = 0.9 * (known_ < 3 ? root8 : root16 * std::sqrt(root16));
            step_ = std::min(step_ * std::clamp(stretch, 0.3, 2.5), settings_.largest_step);
        } else {
            step_ *= ratio < 1e80 ? std::clamp(0.7 * root8, 0.1, 0.5) : 0.1;
        }
    }

    void remember(double time, const Point& point, const Point& speed) {
        for (std::size_t m : {std::size_t{2}, std::size_t{1}}) {
            point_[m] = point_[m - 1];
            speed_[m] = speed_[m - 1];
            time_[m] = time_[m - 1];
        }
        point_[0] = point;
        speed_[0] = speed;
        time_[0] = time;
        known_ = std::min(known_ + 1, 3);
    }

    /// Hermite extrapolation from the points that are known, in Newton's form, each node twice, to
    /// the time s after the newest.
    Point predicted(double s) const {
        Point result = point_[0];
        if (known_ == 0) return result;
        const double a = time_[0] - time_[1], b = time_[0] - time_[2], c = time_[1] - time_[2];
        const double w3 = s * s * (s + a), w4 = w3 * (s + a), w5 = w4 * (s + b);
        for (std::size_t k = 0; k < n; ++k) {
            const Complex x0 = point_[0][k], x1 = point_[1][k], x2 = point_[2][k];
            const Complex v0 = speed_[0][k], v1 = speed_[1][k], v2 = speed_[2][k];
            result[k] = x0 + s * v0;
            if (known_ == 1) continue;
            const Complex d01 = (1 / a) * (x0 - x1);
            const Complex d001 = (1 / a) * (v0 - d01), d011 = (1 / a) * (d01 - v1);
            const Complex d0011 = (1 / a) * (d001 - d011);
            result[k] = result[k] + s * s * d001 + w3 * d0011;
            if (known_ == 2) continue;
            const Complex d12 = (1 / c) * (x1 - x2);
            const Complex d112 = (1 / c) * (v1 - d12), d122 = (1 / c) * (d12 - v2);
            const Complex d0112 = (1 / b) * (d011 - d112), d1122 = (1 / c) * (d112 - d122);
            const Complex d00112 = (1 / b) * (d0011 - d0112), d01122 = (1 / b) * (d0112 - d1122);
            result[k] = result[k] + w4 * d00112 + w5 * ((1 / b) * (d00112 - d01122));
        }
        return result;
    }

    /// One of Newton's corrections; its size relative to the point, squared. With the speed of the
    /// point if moving.
    template <bool moving>
    double correct(double time, Point& point, Point& speed) {
        const auto data = way_.at(time);
        if constexpr (moving) {
            const auto data_speed = way_.speed_at(time);
            Equations::template linearise<true>(point.data(), data.data(), data_speed.data(),
                                                matrix_.rows.data());
        } else {
            Equations::template linearise<false>(point.data(), data.data(), nullptr,
                                                 matrix_.rows.data());
        }
        matrix_.eliminate();
        const Point correction = matrix_.solution(n);
        double change = 0, norm = 1;
        for (std::size_t k = 0; k < n; ++k) {
            Complex& x = point[Equations::order[k]];
            change += square(correction[k]);
            norm += square(x);
            x = x - correction[k];
        }
        if constexpr (moving) {
            const Point solved = matrix_.solution(n + 1);
            for (std::size_t k = 0; k < n; ++k)
                speed[Equations::order[k]] = -solved[k];
        }
        return change / norm;
    }

    const Way<Equations>& way_;
    const TrackSettings& settings_;
    std::array<Point, 3> point_{}, speed_{}; ///< the newest first
    std::array<double, 3> time_{0, -1, -2};
    int known_ = 0; ///< how many of these points there are
    double step_ = 0;
    int steps_ = 0;
    Elimination<n, n + 2> matrix_{};
};

/// Equations with certain data.
template <class Equations>
class At {
public:
    static constexpr std::size_t n = Equations::unknowns;
    using Point = std::array<Complex, n>;
    using Data = std::array<Complex, Equations::data>;

    explicit At(const Data& data) : data_(data) {}

    /// Where Newton's method leads from an approximation; nothing where that is far away, or the
    /// Jacobian is singular as far as rounding lets one see.
    std::optional<Point> refined(const Point& approximation) const {
        constexpr int steps = 3;
        constexpr double far = 1e-4, converged = 1e-6;
        Point point = approximation;
        double moved = 0, last = 0;
        for (int step = 0; step < steps; ++step) {
            Elimination<n, n + 1> matrix{};
            linearise(point, matrix.rows);
            matrix.eliminate();
            const Point change = matrix.solution(n);
            last = 0;
            for (std::size_t k = 0; k < n; ++k) {
                if (!is_finite(change[k])) return std::nullopt;
                Complex& x = point[Equations::order[k]];
                x = x - change[k];
                last += square(change[k]);
            }
            last = std::sqrt(last);
            moved += last;
        }
        const double scale = length(approximation);
        if (!(moved < far * scale && last < converged * scale) || !is_regular(point))
            return std::nullopt;
        return point;
    }

    /// Whether no condition is as small as rounding may make a zero.
    bool keeps_conditions(const Point& point) const {
        constexpr double tiny = 1e-9;
        std::array<Complex, Equations::conditions> values;
        Equations::find_conditions(point.data(), data_.data(), values.data());
        return std::all_of(values.begin(), values.end(),
                           [](Complex x) { return is_finite(x) && size(x) > tiny; });
    }

    /// The largest value of an equation, relative to the sizes of its terms.
    double residual(const Point& point) const {
        typename Elimination<n, n + 1>::Rows rows{};
        linearise(point, rows);
        double largest = 0;
        for (const auto& row : rows)
            largest = std::max(largest, size(row[n]) / size_of_terms(row, point));
        return largest;
    }

    /// What tells solutions apart.
    std::vector<Complex> counted(const Point& point) const {
        std::vector<Complex> values(Equations::counted);
        Equations::find_counted(point.data(), data_.data(), values.data());
        if (!values.empty() && std::all_of(values.begin(), values.end(), is_finite)) return values;
        return {point.begin(), point.end()};
    }

private:
    void linearise(const Point& point, typename Elimination<n, n + 1>::Rows& rows) const {
        Equations::template linearise<false>(point.data(), data_.data(), nullptr, rows.data());
    }

    /// At least: 1 and the unknowns times the derivatives.
    template <class Row>
    static double size_of_terms(const Row& row, const Point& point) {
        double sum = 1;
        for (std::size_t k = 0; k < n; ++k)
            sum += size(row[k]) * size(point[Equations::order[k]]);
        return sum;
    }

    /// Where the Jacobian is not regular, equations whose terms change by 10^-16 have solutions
    /// 10^-8 away.
    bool is_regular(const Point& point) const {
        constexpr double largest = 1e7; // of the inverse, relative to the point
        typename Elimination<n, n + 1>::Rows rows{};
        linearise(point, rows);
        Elimination<n, 2 * n> matrix{};
        for (std::size_t i = 0; i < n; ++i) {
            const double scale = 1 / size_of_terms(rows[i], point);
            for (std::size_t k = 0; k < n; ++k)
                matrix.rows[i][k] = scale * rows[i][k];
            matrix.rows[i][n + i] = 1;
        }
        matrix.eliminate();
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (const Complex x : matrix.solution(n + i))
                sum += square(x);
        return std::sqrt(sum) < largest * length(point);
    }

    const Data& data_;
};

template <class Point>
struct Found {
    Point point{};
    bool real = false;
    double residual = 0;
};

/// Different solutions for the same data, which are real.
template <class Equations>
class Collection {
public:
    using Point = typename Path<Equations>::Point;
    static constexpr std::size_t none = ~std::size_t{0};

    explicit Collection(const typename Way<Equations>::Data& data) : equations_(data) {}

    /// Adds the solution that this approximates, and its conjugate. Returns its number, or none.
    std::size_t add(const Point& approximation) {
        const auto solution = equations_.refined(approximation);
        if (!solution || !equations_.keeps_conditions(*solution)) return none;
        if (const auto real = real_one(*solution)) return add_new(*real, true);
        const std::size_t number = add_new(*solution, false);
        Point conjugate = *solution;
        for (Complex& x : conjugate)
            x.im = -x.im;
        add_new(conjugate, false);
        return number;
    }

    std::size_t size() const { return found_.size(); }

    /// Each that counts once: real ones first, in the order of their numbers.
    std::vector<Found<Point>> counted() && {
        std::stable_sort(found_.begin(), found_.end(), comes_before);
        if constexpr (Equations::counted == 0) return std::move(found_);
        std::vector<Found<Point>> result;
        std::vector<std::vector<Complex>> seen;
        for (const Found<Point>& found : found_) {
            std::vector<Complex> values = equations_.counted(found.point);
            const auto is_same = [&](const std::vector<Complex>& other) {
                return values.size() == other.size() && has_near_coordinates(values, other);
            };
            if (std::any_of(seen.begin(), seen.end(), is_same)) continue;
            seen.push_back(std::move(values));
            result.push_back(found);
        }
        return result;
    }

private:
    /// The solution itself, if it is real: without the imaginary parts that rounding gives it.
    std::optional<Point> real_one(const Point& solution) const {
        constexpr double tiny = 1e-7, near = 1e-6;
        Point real;
        for (std::size_t k = 0; k < real.size(); ++k) {
            const Complex x = solution[k];
            if (!(std::abs(x.im) < tiny * (1 + detail::size(x)))) return std::nullopt;
            real[k] = x.re;
        }
        const auto point = equations_.refined(real);
        if (!point) return std::nullopt;
        double distance = 0;
        for (std::size_t k = 0; k < real.size(); ++k) {
            distance += square((*point)[k] - solution[k]);
            real[k] = (*point)[k].re;
        }
        if (!(std::sqrt(distance) < near * length(*point))) return std::nullopt;
        return real;
    }

    std::size_t add_new(const Point& solution, bool real) {
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (has_near_coordinates(solution, found_[i].point)) return i;
        found_.push_back({solution, real, equations_.residual(solution)});
        return found_.size() - 1;
    }

    static bool comes_before(const Found<Point>& a, const Found<Point>& b) {
        if (a.real != b.real) return a.real;
        return std::lexicographical_compare(
            a.point.begin(), a.point.end(), b.point.begin(), b.point.end(),
            [](Complex x, Complex y) { return x.re != y.re ? x.re < y.re : x.im < y.im; });
    }

    At<Equations> equations_;
    std::vector<Found<Point>> found_;
};

/// What following paths cost.
struct Cost {
    std::size_t paths = 0;
    std::size_t steps = 0;
};

/// All solutions for some data, from those for the data at the start.
template <class Equations>
class PathSolver {
public:
    using Point = typename Path<Equations>::Point;
    using Data = typename Way<Equations>::Data;

    explicit PathSolver(const Data& data) : data_(data), solutions_(data) {
        for (std::size_t i = 0; i < start_.size(); ++i)
            start_[i] = {Equations::start_data[2 * i], Equations::start_data[2 * i + 1]};
        ends_.assign(Equations::starts, lost);
    }

    /// Follows all paths; more carefully those that seem lost, or to have jumped to another path;
    /// then on other ways, at most so many.
    void run(int more_ways) {
        const TrackSettings usual, careful = careful_settings();
        const Way<Equations> straight(start_, data_, Data{});
        for (std::size_t path = 0; path < ends_.size(); ++path)
            follow(straight, usual, path);
        if (is_complete()) return;
        for (const std::size_t path : doubtful())
            follow(straight, careful, path);
        Random random;
        for (int way = 0; way < more_ways && !is_complete(); ++way) {
            Data bend;
            for (Complex& x : bend)
                x = random.number();
            const Way<Equations> bent(start_, data_, bend);
            for (std::size_t path = 0; path < ends_.size(); ++path)
                follow(bent, careful, path);
        }
    }

    std::vector<Found<Point>> solutions() && { return std::move(solutions_).counted(); }
    const Cost& cost() const { return cost_; }

private:
    static constexpr std::size_t lost = Collection<Equations>::none;

    bool is_complete() const { return solutions_.size() >= ends_.size(); }

    void follow(const Way<Equations>& way, const TrackSettings& settings, std::size_t path) {
        Point start;
        for (std::size_t k = 0; k < start.size(); ++k)
            start[k] = {Equations::start_solutions[path][2 * k],
                        Equations::start_solutions[path][2 * k + 1]};
        Path<Equations> tracked(way, settings, start);
        const auto end = tracked.follow();
        ends_[path] = end ? solutions_.add(*end) : lost;
        ++cost_.paths;
        cost_.steps += tracked.steps();
    }

    /// Paths that ended nowhere, or where another one did.
    std::vector<std::size_t> doubtful() const {
        std::vector<int> paths(solutions_.size());
        for (const std::size_t end : ends_)
            if (end != lost) ++paths[end];
        std::vector<std::size_t> result;
        for (std::size_t path = 0; path < ends_.size(); ++path)
            if (ends_[path] == lost || paths[ends_[path]] > 1) result.push_back(path);
        return result;
    }

    const Data& data_;
    Data start_;
    Collection<Equations> solutions_;
    std::vector<std::size_t> ends_; ///< of each path, the number of its solution, or lost
    Cost cost_;
};

/// Arrays of any shape, number by number.
template <class To>
void read_numbers(const double& number, To*& to) {
    *to++ = number;
}
template <class Item, std::size_t count, class To>
void read_numbers(const Item (&array)[count], To*& to) {
    for (const Item& item : array)
        read_numbers(item, to);
}
inline void write_numbers(double& number, const Complex*& from) {
    number = (from++)->re;
}
inline void write_numbers(std::complex<double>& number, const Complex*& from) {
    number = {from->re, from->im};
    ++from;
}
template <class Item, std::size_t count>
void write_numbers(Item (&array)[count], const Complex*& from) {
    for (Item& item : array)
        write_numbers(item, from);
}

/// A camera from one up to a factor: nine numbers of a matrix with orthogonal rows, then three.
inline void read_camera(const Complex* numbers, double (&rotation)[3][3],
                        double (&translation)[3]) {
    const double a = numbers[0].re, b = numbers[1].re, c = numbers[2].re;
    const double scale = 1 / std::sqrt(a * a + b * b + c * c);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            rotation[i][k] = scale * numbers[3 * i + k].re;
        translation[i] = scale * numbers[9 + i].re;
    }
}

} // namespace detail
