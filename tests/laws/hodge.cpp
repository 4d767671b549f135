#include "tests/laws/hodge.h"

#include <algorithm>
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
    IntersectionMatrix matrix{surface, divisors.size(), {}};
    std::set<std::size_t> classes;
    for (std::size_t i = 0; i < divisors.size(); ++i)
        for (std::size_t j = 0; j < divisors.size(); ++j) {
            const auto second = i == j ? again(divisors[i]) : divisors[j];
            const Product curve = cut(surface, divisors[i]);
            const auto index = second ? form.class_of(cut(curve, *second)) : std::nullopt;
            matrix.entries.push_back(index ? form.classes()[*index].degree : 0);
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

} // namespace laws
