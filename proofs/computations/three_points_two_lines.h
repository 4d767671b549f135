// Lemma V10 of proofs/four_and_five_views.md: three points, one of them with three pins, and two
// free lines in four views, as a degenerate matrix on a quadric; one example modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <array>
#include <cstddef>

namespace proofs {

/// Products coordinate by coordinate, one coordinate for each view.
inline ResidueRow by_views(const ResidueRow& a, const ResidueRow& b) {
    ResidueRow result;
    for (std::size_t v = 0; v < a.size(); ++v)
        result.push_back(a[v] * b[v]);
    return result;
}

/// Covectors (a, b, 0) of the pins and (a, b, 1) of the free lines, in the coordinates where the
/// views show the three points at the unit vectors. Each a, b has a coordinate for each view.
struct PinsAndLines {
    std::array<ResidueRow, 3> pin_a{}, pin_b{};
    std::array<ResidueRow, 2> line_a{}, line_b{};
};

inline PinsAndLines generic_pins_and_lines(Residues& random) {
    PinsAndLines images;
    for (std::size_t i = 0; i < 3; ++i) {
        images.pin_a[i] = random.row(4);
        images.pin_b[i] = random.row(4);
    }
    for (std::size_t j = 0; j < 2; ++j) {
        images.line_a[j] = random.row(4);
        images.line_b[j] = random.row(4);
    }
    return images;
}

/// The quadric Q: the c where a_1, a_2, b_1 c, b_2 c of the free lines are dependent.
class Quadric {
public:
    explicit Quadric(const PinsAndLines& images)
        : images_(images), forms_(kernel_of({images.line_a[0], images.line_a[1]}, 4)) {
        ResidueMatrix square; // takes c to the four entries of N(c)
        for (const ResidueRow& form : forms_)
            for (const ResidueRow& b : images.line_b)
                square.push_back(by_views(form, b));
        smooth_ = forms_.size() == 2 && rank_of(square) == 4;
        for (std::size_t n = 0; smooth_ && n < 4; ++n) {
            ResidueMatrix system = square;
            for (std::size_t i = 0; i < 4; ++i)
                system[i].push_back(Residue{i == n ? 1U : 0U});
            inverse_.emplace_back();
            for (const ResidueRow& row : echelon(system).rows)
                inverse_.back().push_back(row.back());
        }
    }

    bool smooth() const { return smooth_; }

    bool contains(const ResidueRow& c) const {
        return determinant_of({images_.line_a[0], images_.line_a[1], by_views(images_.line_b[0], c),
                               by_views(images_.line_b[1], c)}) == Residue{};
    }

    /// The point c with N(c) = s t^T, if the quadric is smooth.
    ResidueRow point(const ResidueRow& s, const ResidueRow& t) const {
        return product({{s[0] * t[0], s[0] * t[1], s[1] * t[0], s[1] * t[1]}}, inverse_).front();
    }

    /// The linear form that vanishes on S_1 + S_2 at this point.
    ResidueRow form(const ResidueRow& s) const {
        ResidueRow result(4);
        add_multiple(result, s[1], forms_[0]);
        add_multiple(result, -s[0], forms_[1]);
        return result;
    }

private:
    const PinsAndLines& images_;
    ResidueMatrix forms_, inverse_{};
    bool smooth_ = false;
};

/// The equation that a Y_1 + b Y_2 is a zero of the form.
inline ResidueRow equation(const ResidueRow& form, const ResidueRow& a, const ResidueRow& b) {
    ResidueRow row = by_views(form, a);
    for (const Residue number : by_views(form, b))
        row.push_back(number);
    return row;
}

/// The equations of a pin for (Y_1, Y_2): three, which have rank 2 unless b c is a multiple of a.
inline ResidueMatrix equations_of_pin(const ResidueRow& a, const ResidueRow& b,
                                      const ResidueRow& c) {
    const ResidueMatrix forms = kernel_of({a}, 4);
    const ResidueRow bc = by_views(b, c);
    ResidueMatrix rows;
    for (std::size_t h = 0; h < 3; ++h) {
        const ResidueRow &one = forms[h], &other = forms[(h + 1) % 3];
        ResidueRow form(4);
        add_multiple(form, product(other, bc), one);
        add_multiple(form, -product(one, bc), other);
        rows.push_back(equation(form, a, b));
    }
    return rows;
}

/// All equations for (Y_1, Y_2) at the point c of the quadric with N(c) = s t^T: nine of the pins,
/// bilinear in s and t, and one of the free lines, linear in s.
inline ResidueMatrix equations_at(const PinsAndLines& images, const Quadric& quadric,
                                  const ResidueRow& s, const ResidueRow& t) {
    const ResidueRow c = quadric.point(s, t);
    ResidueMatrix rows;
    for (std::size_t i = 0; i < 3; ++i)
        for (const ResidueRow& row : equations_of_pin(images.pin_a[i], images.pin_b[i], c))
            rows.push_back(row);
    ResidueRow a = images.line_a[0], b = images.line_b[0];
    add_multiple(a, -Residue{1}, images.line_a[1]);
    add_multiple(b, -Residue{1}, images.line_b[1]);
    rows.push_back(equation(quadric.form(s), a, b));
    return rows;
}

/// Combinations of the minors of size 6 that contain the last equation: of degree 6 in s, 5 in t.
class CombinedMinors {
public:
    CombinedMinors(Residues& random, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            rows_.push_back(random.matrix(5, 9));
            columns_.push_back(random.matrix(8, 6));
        }
    }

    ResidueRow at(const ResidueMatrix& equations) const {
        ResidueRow values;
        const ResidueMatrix of_pins(equations.begin(), equations.end() - 1);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            ResidueMatrix six = product(rows_[i], of_pins);
            six.push_back(equations.back());
            values.push_back(determinant_of(product(six, columns_[i])));
        }
        return values;
    }

private:
    std::vector<ResidueMatrix> rows_{}, columns_{};
};

/// Whether the equations have rank 6 at all points of a generic line of each family on the quadric.
inline bool no_curve_of_degenerate_points(const PinsAndLines& images, const Quadric& quadric,
                                          Residues& random) {
    constexpr std::size_t count = 6;
    const CombinedMinors minors(random, count);
    const ResidueRow fixed = random.row(2);
    for (const bool s_is_fixed : {true, false}) {
        ResidueMatrix values(count);
        const std::size_t degree = s_is_fixed ? 5 : 6;
        for (std::size_t z = 0; z <= degree; ++z) {
            const ResidueRow moving{Residue{1}, Residue::of(z)};
            const ResidueRow at = minors.at(equations_at(
                images, quadric, s_is_fixed ? fixed : moving, s_is_fixed ? moving : fixed));
            for (std::size_t i = 0; i < count; ++i)
                values[i].push_back(at[i]);
        }
        ResidueMatrix forms;
        for (const ResidueRow& of_minor : values)
            forms.push_back(interpolated(of_minor));
        if (!have_no_common_zero(forms)) return false;
    }
    return true;
}

/// Whether the quadric contains no point c where b c is a multiple of a, for a pin.
inline bool pins_have_rank_2(const PinsAndLines& images, const Quadric& quadric) {
    for (std::size_t i = 0; i < 3; ++i) {
        ResidueRow c;
        for (std::size_t v = 0; v < 4; ++v)
            c.push_back(images.pin_a[i][v] * images.pin_b[i][v].inverse());
        if (quadric.contains(c)) return false;
    }
    return true;
}

} // namespace proofs
