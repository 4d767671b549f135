#include "tests/laws/hodge.h"

#include <algorithm>
#include <cmath>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <set>

namespace laws {

namespace {

/// A further feature, or a further pin on a point, whose index is `point`, which makes it the
/// feature `added`.
struct Divisor {
    std::optional<std::size_t> point;
    std::size_t added = 0;
};

/// Points that all views see, with 0 to 7 pins, each seen by all views.
std::vector<std::size_t> common_points() {
    constexpr std::size_t most_pins = 7;
    std::vector<std::size_t> result(most_pins + 1);
    for (std::size_t i = 0; i < checker::feature_count; ++i) {
        const checker::Feature& feature = checker::features[i];
        if (feature.point == checker::all_views) result[feature.pins] = i;
    }
    return result;
}

std::vector<Divisor> divisors_on(const Product& surface) {
    std::vector<Divisor> divisors;
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (checker::features[i].weight() == 1 && letter(i) == i) divisors.push_back({{}, i});
    const std::vector<std::size_t> points = common_points();
    for (std::size_t pins = 0; pins + 1 < points.size(); ++pins)
        for (unsigned copy = 0; copy < std::min(surface[points[pins]], 2U); ++copy)
            divisors.push_back({points[pins], points[pins + 1]});
    return divisors;
}

/// The product on a divisor.
Product cut(Product product, const Divisor& divisor) {
    if (divisor.point) --product[*divisor.point];
    ++product[divisor.added];
    return product;
}

/// The divisor again, of what it cut out: a second pin is on the point that has the first. Nothing
/// if the point would have more pins than any problem has.
std::optional<Divisor> again(const Divisor& divisor) {
    if (!divisor.point) return divisor;
    const std::size_t pins = checker::features[divisor.added].pins;
    const std::vector<std::size_t> points = common_points();
    if (pins + 1 == points.size()) return std::nullopt;
    return Divisor{divisor.added, points[pins + 1]};
}

IntersectionMatrix matrix_on(const Product& surface, const DegreeForm& form) {
    const std::vector<Divisor> divisors = divisors_on(surface);
    IntersectionMatrix matrix{surface, divisors.size(), {}, {}};
    std::set<std::size_t> classes;
    for (std::size_t i = 0; i < divisors.size(); ++i)
        for (std::size_t j = 0; j < divisors.size(); ++j) {
            const auto second = i == j ? again(divisors[i]) : divisors[j];
            const Product curve = cut(surface, divisors[i]);
            const auto index = second ? form.class_of(cut(curve, *second)) : std::nullopt;
            matrix.entries.push_back(index ? form.classes()[*index].degree : 0);
            matrix.members.push_back(index);
            if (index) classes.insert(*index);
        }
    matrix.classes.assign(classes.begin(), classes.end());
    return matrix;
}

/// Whether no relabeling of the views gives a larger product.
bool represents_its_class(const Product& product) {
    return checker::constraint_class(product) == product;
}

} // namespace

std::vector<IntersectionMatrix> intersection_matrices(const DegreeForm& form) {
    std::vector<IntersectionMatrix> matrices;
    for (const Product& surface : products(checker::camera_unknowns - 2)) {
        if (!represents_its_class(surface)) continue;
        IntersectionMatrix matrix = matrix_on(surface, form);
        if (!matrix.classes.empty()) matrices.push_back(std::move(matrix));
    }
    return matrices;
}

std::size_t positive_eigenvalues(const IntersectionMatrix& matrix) {
    const auto size = static_cast<slong>(matrix.divisors);
    fmpz_mat_t numbers;
    fmpz_mat_init(numbers, size, size);
    for (slong i = 0; i < size; ++i)
        for (slong j = 0; j < size; ++j)
            fmpz_set_si(fmpz_mat_entry(numbers, i, j),
                        matrix.entries[static_cast<std::size_t>(i * size + j)]);
    fmpz_poly_t polynomial;
    fmpz_poly_init(polynomial);
    fmpz_mat_charpoly(polynomial, numbers);
    std::size_t changes = 0;
    int last = 0;
    for (slong i = 0; i <= size; ++i) {
        const int sign = fmpz_sgn(fmpz_poly_get_coeff_ptr(polynomial, i));
        if (sign * last < 0) ++changes;
        if (sign != 0) last = sign;
    }
    fmpz_poly_clear(polynomial);
    fmpz_mat_clear(numbers);
    return changes;
}

namespace {

/// (AA), (AB) and (BB) of two divisors: the places of these entries in a matrix.
struct Inequality {
    std::size_t left = 0, middle = 0, right = 0;
};

std::vector<Inequality> inequalities(std::size_t divisors) {
    std::vector<Inequality> result;
    for (std::size_t a = 0; a < divisors; ++a)
        for (std::size_t b = 0; b < divisors; ++b)
            if (a != b) result.push_back({a * divisors + a, a * divisors + b, b * divisors + b});
    return result;
}

/// The least integer whose square is at least x.
std::int64_t root_above(std::int64_t x) {
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));
    while (root * root < x)
        ++root;
    while (root > 0 && (root - 1) * (root - 1) >= x)
        --root;
    return root;
}

} // namespace

std::vector<HodgeBounds> bounds_by_others(const std::vector<IntersectionMatrix>& matrices,
                                          const DegreeForm& form) {
    std::vector<HodgeBounds> bounds(form.classes().size());
    for (const IntersectionMatrix& matrix : matrices)
        for (const auto& [left, middle, right] : inequalities(matrix.divisors)) {
            const auto &aa = matrix.members[left], &ab = matrix.members[middle],
                       &bb = matrix.members[right];
            const std::int64_t product = matrix.entries[left] * matrix.entries[right];
            const std::int64_t square = matrix.entries[middle] * matrix.entries[middle];
            if (aa && bb && aa != ab && aa != bb) {
                std::optional<std::int64_t>& most = bounds[*aa].most;
                const std::int64_t bound = square / matrix.entries[right];
                most = std::min(most.value_or(bound), bound);
            }
            if (ab && ab != aa && ab != bb)
                bounds[*ab].least = std::max(bounds[*ab].least, root_above(product));
        }
    return bounds;
}

std::size_t bounded_by_exact(const std::vector<IntersectionMatrix>& matrices,
                             const std::vector<bool>& exact) {
    std::vector<bool> bounded = exact;
    const auto known = static_cast<std::size_t>(std::ranges::count(exact, true));
    for (std::size_t before = 0, now = known; before < now;) {
        before = now;
        for (const IntersectionMatrix& matrix : matrices)
            for (const auto& [left, middle, right] : inequalities(matrix.divisors)) {
                const auto &aa = matrix.members[left], &ab = matrix.members[middle];
                const bool bounds = matrix.members[right] && (!ab || bounded[*ab]);
                if (aa && bounds) bounded[*aa] = true;
            }
        now = static_cast<std::size_t>(std::ranges::count(bounded, true));
    }
    return static_cast<std::size_t>(std::ranges::count(bounded, true)) - known;
}

} // namespace laws
