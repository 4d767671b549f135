// How large a template of a trifocal problem would have to be (templates: proofs/templates.md, section 8):
// ranks of the multiples of the equations of 3*P/P/P + a/a/a, modulo a small prime. Proves nothing;
// tells where to look for an upper bound, and where not.
//   trifocal_rank K L     for degree K in the rotation of the second camera, L in that of the third
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <vector>

namespace {

// Integers modulo p as doubles: sums of 256 products are exact.
constexpr std::int64_t p = 2097143;
constexpr Eigen::Index block = 256;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::int64_t reduced(std::int64_t x) {
    return (x % p + p) % p;
}

std::int64_t inverse(std::int64_t x) {
    std::int64_t power = 1;
    for (std::int64_t rest = p - 2; rest > 0; rest /= 2, x = x * x % p)
        if (rest % 2 == 1) power = power * x % p;
    return power;
}

void reduce(Eigen::Ref<Matrix> m) {
    m = m.unaryExpr([](double x) { return x - std::floor(x * (1.0 / p)) * p; });
    m = m.unaryExpr([](double x) { return x < 0 ? x + p : x >= p ? x - p : x; });
}

/// A matrix in echelon form, to which rows are added in blocks.
class Echelon {
public:
    explicit Echelon(Eigen::Index columns) : columns_(columns) {}
    Eigen::Index rank() const { return rank_; }

    void add(Matrix rows) {
        for (const Block& earlier : blocks_) {
            Matrix factors(rows.rows(), std::ssize(earlier.pivots));
            for (std::size_t k = 0; k < earlier.pivots.size(); ++k)
                factors.col(static_cast<Eigen::Index>(k)) = rows.col(earlier.pivots[k]);
            rows.noalias() -= factors * earlier.rows;
            reduce(rows);
        }
        // Gauss-Jordan elimination within the block.
        std::vector<Eigen::Index> pivots;
        Eigen::Index kept = 0;
        for (Eigen::Index r = 0; r < rows.rows(); ++r) {
            Eigen::Index c = 0;
            while (c < columns_ && rows(r, c) == 0)
                ++c;
            if (c == columns_) continue;
            rows.row(kept).swap(rows.row(r));
            rows.row(kept) *=
                static_cast<double>(inverse(static_cast<std::int64_t>(rows(kept, c))));
            reduce(rows.row(kept));
            for (Eigen::Index i = 0; i < rows.rows(); ++i) {
                if (i == kept || rows(i, c) == 0) continue;
                rows.row(i) -= rows(i, c) * rows.row(kept);
                reduce(rows.row(i));
            }
            pivots.push_back(c);
            ++kept;
        }
        rank_ += kept;
        if (kept > 0) blocks_.push_back({rows.topRows(kept), pivots});
    }

private:
    struct Block {
        Matrix rows;
        std::vector<Eigen::Index> pivots;
    };
    Eigen::Index columns_;
    Eigen::Index rank_ = 0;
    std::vector<Block> blocks_;
};

/// Forms in two quaternions: exponents of both.
using Exponents = std::array<int, 8>;
using Form = std::map<Exponents, std::int64_t>;
using FormVector = std::array<Form, 3>;
using Vector = std::array<std::int64_t, 3>;

void add(Form& sum, const Form& a, const Form& b, std::int64_t factor) {
    for (const auto& [e, x] : a)
        for (const auto& [f, y] : b) {
            Exponents g = e;
            for (std::size_t i = 0; i < 8; ++i)
                g[i] += f[i];
            std::int64_t& entry = sum[g];
            entry = reduced(entry + x * y % p * reduced(factor));
        }
}

Form constant(std::int64_t x) {
    return {{Exponents{}, reduced(x)}};
}

Form coordinate(std::size_t i) {
    Exponents e{};
    e[i] = 1;
    return {{e, 1}};
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The camera of a view: none for the first, which does not turn.
struct View {
    std::array<Form, 9> rotation{};
    Form norm = constant(1);
    std::array<Vector, 3> points{}; // images of the points; the world's origin is the first
    Vector line{};

    View(int number, std::mt19937& random) {
        for (Vector* v : {points.data(), &points[1], &points[2], &line})
            for (std::int64_t& x : *v)
                x = static_cast<std::int64_t>(random() % 2000) - 1000;
        if (number == 0) {
            for (const std::size_t i : {0U, 4U, 8U})
                rotation[i] = constant(1);
            return;
        }
        const std::size_t first = number == 1 ? 0 : 4;
        std::array<Form, 4> q;
        for (std::size_t i = 0; i < 4; ++i)
            q[i] = coordinate(first + i);
        norm = {};
        for (const Form& x : q)
            add(norm, x, x, 1);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                Form& entry = rotation[3 * i + j];
                add(entry, q[1 + i], q[1 + j], 2);
                if (i == j) {
                    add(entry, q[0], q[0], 1);
                    for (std::size_t k = 1; k < 4; ++k)
                        add(entry, q[k], q[k], -1);
                } else {
                    add(entry, q[0], q[4 - i - j], (j + 3 - i) % 3 == 1 ? -2 : 2);
                }
            }
    }

    /// R^T x, in the coordinates of the world.
    FormVector back(const Vector& x) const {
        FormVector result;
        for (std::size_t i = 0; i < 9; ++i)
            add(result[i % 3], rotation[i], constant(1), x[i / 3]);
        return result;
    }
    /// x cross (R y)
    FormVector crossed(const Vector& x, const Vector& y) const {
        FormVector result;
        for (std::size_t k = 0; k < 3; ++k) {
            Vector unit{};
            unit[k] = 1;
            const Vector row = cross(unit, x); // (x cross z)_k = (unit cross x) . z
            for (std::size_t i = 0; i < 9; ++i)
                add(result[k], rotation[i], constant(1), reduced(row[i / 3] * y[i % 3]));
        }
        return result;
    }
};

Form dot(const FormVector& a, const FormVector& b) {
    Form sum;
    for (std::size_t i = 0; i < 3; ++i)
        add(sum, a[i], b[i], 1);
    return sum;
}

FormVector cross(const FormVector& a, const FormVector& b) {
    FormVector result;
    for (std::size_t i = 0; i < 3; ++i) {
        add(result[i], a[(i + 1) % 3], b[(i + 2) % 3], 1);
        add(result[i], a[(i + 2) % 3], b[(i + 1) % 3], -1);
    }
    return result;
}

/// An equation that is linear in the depths of the first point, of a degree in each rotation.
struct Equation {
    std::array<Form, 3> coefficients{};
    int second, third;
};

std::vector<Equation> equations() {
    std::mt19937 random(1);
    const std::array<View, 3> views{View(0, random), View(1, random), View(2, random)};
    std::vector<Equation> all;
    for (const auto& [v, w] : {std::pair{0U, 1U}, {0U, 2U}, {1U, 2U}})
        for (const std::size_t i : {1U, 2U}) { // the rays of a point in two views meet
            const auto normal = [&](std::size_t view) {
                return views[view].back(cross(views[view].points[0], views[view].points[i]));
            };
            Equation& e = all.emplace_back();
            e.coefficients[v] = dot(normal(v), views[w].back(views[w].points[i]));
            e.coefficients[w] = dot(normal(w), views[v].back(views[v].points[i]));
            e.second = v == 1 || w == 1 ? 1 : 0;
            e.third = w == 2 ? 1 : 0;
        }
    const auto &first = views[0], &second = views[1], &third = views[2];
    for (const std::size_t i : {1U, 2U}) { // the depth of a point in the first view is the same
        const Vector &x = second.points[i], &y = third.points[i];
        const FormVector a = second.crossed(x, first.points[i]);
        const FormVector b = third.crossed(y, first.points[i]);
        const FormVector a0 = second.crossed(x, first.points[0]);
        const FormVector b0 = third.crossed(y, first.points[0]);
        const Vector a1 = cross(x, second.points[0]), b1 = cross(y, third.points[0]);
        for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t k = 0; k < 2; ++k) {
                Equation& e = all.emplace_back();
                add(e.coefficients[0], b[k], a0[j], 1);
                add(e.coefficients[0], a[j], b0[k], -1);
                add(e.coefficients[1], b[k], second.norm, -a1[j]);
                add(e.coefficients[2], a[j], third.norm, b1[k]);
                e.second = e.third = 1;
            }
    }
    std::array<FormVector, 3> normals; // of the planes of the line
    std::array<std::int64_t, 3> offsets{};
    for (std::size_t v = 0; v < 3; ++v) {
        normals[v] = views[v].back(views[v].line);
        for (std::size_t i = 0; i < 3; ++i)
            offsets[v] = reduced(offsets[v] + views[v].line[i] * views[v].points[0][i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        Equation& e = all.emplace_back();
        for (std::size_t v = 0; v < 3; ++v)
            add(e.coefficients[v], cross(normals[(v + 1) % 3], normals[(v + 2) % 3])[i],
                views[v].norm, offsets[v]);
        e.second = e.third = 1;
    }
    const Form dependent = dot(normals[0], cross(normals[1], normals[2]));
    for (std::size_t v = 0; v < 3; ++v) {
        Equation& e = all.emplace_back();
        e.coefficients[v] = dependent;
        e.second = e.third = 1;
    }
    return all;
}

/// The monomials of degree 2 k in one quaternion and 2 l in the other.
std::vector<Exponents> monomials(int k, int l) {
    std::vector<std::array<int, 4>> of[2];
    for (int which = 0; which < 2; ++which) {
        const int degree = 2 * (which == 0 ? k : l);
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b)
                for (int c = 0; a + b + c <= degree; ++c)
                    of[which].push_back({a, b, c, degree - a - b - c});
    }
    std::vector<Exponents> all;
    for (const auto& e : of[0])
        for (const auto& f : of[1])
            all.push_back({e[0], e[1], e[2], e[3], f[0], f[1], f[2], f[3]});
    return all;
}

} // namespace

int main(int count, char** values) {
    if (count != 3) return std::fputs("usage: trifocal_rank K L\n", stderr), 3;
    const int k = std::atoi(values[1]), l = std::atoi(values[2]);
    if (k < 1 || l < 1 || k > 4 || l > 4) return std::fputs("K and L are from 1 to 4\n", stderr), 3;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Exponents> columns = monomials(k, l);
    std::map<Exponents, Eigen::Index> place;
    for (const Exponents& e : columns)
        place.emplace(e, std::ssize(place));
    const Eigen::Index per_depth = std::ssize(columns), width = 3 * per_depth;

    Echelon echelon(width);
    Matrix rows = Matrix::Zero(block, width);
    Eigen::Index filled = 0, total = 0;
    const auto flush = [&] {
        echelon.add(rows.topRows(filled));
        rows.setZero();
        filled = 0;
        std::fprintf(stderr, "\r%td rows, rank %td of %td ", total, echelon.rank(), width);
    };
    const auto add_row = [&](const std::array<Form, 3>& coefficients, const Exponents& factor) {
        for (std::size_t v = 0; v < 3; ++v)
            for (const auto& [e, x] : coefficients[v]) {
                Exponents f = e;
                for (std::size_t i = 0; i < 8; ++i)
                    f[i] += factor[i];
                rows(filled, static_cast<Eigen::Index>(v) * per_depth + place.at(f)) =
                    static_cast<double>(x);
            }
        ++total;
        if (++filled == block) flush();
    };
    for (const Equation& e : equations())
        for (const Exponents& factor : monomials(k - e.second, l - e.third))
            add_row(e.coefficients, factor);
    if (filled > 0) flush();
    const auto report = [&](const char* what) {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("%s: degree (%d, %d), %td columns, %td rows, rank %td, %td left, %.0f s\n",
                    what, k, l, width, total, echelon.rank(), width - echelon.rank(),
                    seconds.count());
        std::fflush(stdout);
    };
    report("\nequations");
    // Zeros at infinity: where the norm of the first quaternion vanishes.
    std::mt19937 unused(1);
    const Form norm = View(1, unused).norm;
    for (std::size_t v = 0; v < 3; ++v)
        for (const Exponents& factor : monomials(k - 1, l)) {
            std::array<Form, 3> coefficients;
            coefficients[v] = norm;
            add_row(coefficients, factor);
        }
    if (filled > 0) flush();
    report("\n... where the norm of the second camera's quaternion vanishes");
    return 0;
}
