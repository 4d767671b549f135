#include "checker/bounds/bounds_file.h"

#include "checker/bounds/template_equations.h"
#include "checker/minimal/record_lines.h"

namespace checker {
/// A rows line: an equation, and the monomials by which it is multiplied; numbered from 1.
struct RowsLine {
    int equation = 0;
    Numbers monomials{};
};

/// A template as a file has it.
struct Template {
    Constraints constraints{};
    Bidegree most{}; // the degree of the columns
    Numbers basis{}; // numbers of monomials
    std::vector<RowsLine> rows{};
    Residue minor{};
};

static Frame read_frame(Reader& reader) {
    const std::string_view word = reader.word();
    if (word == "general") return Frame::general;
    if (word == "line") return Frame::line;
    if (word == "points") return Frame::points;
    if (word == "lines") return Frame::lines;
    reader.fail(word, "`general`, `line`, `points` or `lines`");
}

static Template read_template(Reader& reader) {
    constexpr int largest = 999'999;
    Template read;
    reader.take("template");
    const Frame frame = read_frame(reader);
    reader.take("degree");
    read.most[0] = static_cast<unsigned>(reader.small_integer(1, 6));
    if (frame != Frame::general) read.most[1] = static_cast<unsigned>(reader.small_integer(1, 6));
    reader.end_line();
    read.constraints = read_constraints(reader, frame);
    reader.take("basis");
    read.basis = read_ascending(reader, largest);
    reader.end_line();
    do {
        reader.take("rows");
        RowsLine& line = read.rows.emplace_back();
        const int before = read.rows.size() == 1 ? 0 : read.rows[read.rows.size() - 2].equation;
        line.equation = reader.small_integer(before + 1, largest);
        line.monomials = read_ascending(reader, largest);
        reader.end_line();
    } while (reader.comes("rows"));
    reader.take("minor");
    read.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    return read;
}

/// The columns of the square matrix, by their monomials: all that are not in the basis.
using Columns = std::map<Exponents, std::size_t>;

static Columns columns_outside(const Numbers& basis, const std::vector<Exponents>& monomials,
                               const RotationRing& ring, const Bidegree& most) {
    if (std::cmp_greater(basis.back(), monomials.size()))
        throw Refused("there are only ", monomials.size(), " monomials");
    Columns columns;
    for (std::size_t i = 0; i < monomials.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        if (!std::binary_search(basis.begin(), basis.end(), number))
            columns.emplace(monomials[i], columns.size());
        else if (!fits(ring.degree(monomials[i]), ring.unit(), most))
            throw Refused("monomial ", number, " is of too large a degree for the basis");
    }
    return columns;
}

using Matrix = std::vector<std::vector<Residue>>;

/// The row of an equation's polynomial times a monomial. All its monomials must be of degree at
/// most `most`.
static std::vector<Residue> row_of(const Polynomial& polynomial, const Exponents& monomial,
                                   const RotationRing& ring, const Bidegree& most,
                                   const Columns& columns) {
    Polynomial product;
    ring.add_product(product, polynomial, {{monomial, {1}}}, {1});
    std::vector<Residue> row(columns.size());
    for (const auto& [exponents, coefficient] : product) {
        const bool in_degree = fits(ring.degree(exponents), {}, most);
        if (!in_degree && coefficient != Residue{})
            throw Refused("a row has a monomial of too large a degree");
        const auto column = columns.find(exponents);
        if (column != columns.end()) row[column->second] = coefficient; // else it is in the basis
    }
    return row;
}

/// Throws Refused unless the rows name equations and monomials that exist, are of degrees that fit,
/// and make the matrix square. No polynomial is needed to see that.
static void check_rows(const Template& given, const std::vector<RotationEquation>& equations,
                       const std::vector<Exponents>& monomials, const RotationRing& ring,
                       std::size_t columns) {
    std::size_t rows = 0;
    for (const auto& [number, factors] : given.rows) {
        if (std::cmp_greater(number, equations.size()))
            throw Refused("there are only ", equations.size(), " equations");
        const RotationEquation& equation = equations[static_cast<std::size_t>(number - 1)];
        for (const int factor : factors) {
            if (std::cmp_greater(factor, monomials.size()))
                throw Refused("there are only ", monomials.size(), " monomials");
            if (rows == columns)
                throw Refused("there are more rows than the ", columns, " columns");
            const Exponents& monomial = monomials[static_cast<std::size_t>(factor - 1)];
            if (!fits(equation.degree, ring.degree(monomial), given.most))
                throw Refused("equation ", number, " times monomial ", factor,
                              " is of too large a degree");
            ++rows;
        }
    }
    if (rows != columns) throw Refused("there are ", rows, " rows for ", columns, " columns");
}

/// The square matrix of rows that check_rows accepts.
static Matrix matrix_of(const Template& given, const std::vector<RotationEquation>& equations,
                        const std::vector<Exponents>& monomials, const RotationRing& ring,
                        const Columns& columns) {
    Matrix matrix;
    for (const auto& [number, factors] : given.rows) {
        const Polynomial polynomial = equations[static_cast<std::size_t>(number - 1)].polynomial();
        for (const int factor : factors) {
            const Exponents& monomial = monomials[static_cast<std::size_t>(factor - 1)];
            matrix.push_back(row_of(polynomial, monomial, ring, given.most, columns));
        }
    }
    return matrix;
}

/// Throws Refused unless the template holds: then generic constraints of its type have at most as
/// many solutions as its basis has monomials.
static void check_template(const Template& given) {
    check_frame(given.constraints);
    const FrameRotations rotations(given.constraints.frame);
    const RotationRing& ring = rotations.ring;
    const std::vector<Exponents> monomials = ring.monomials(given.most);
    const Columns columns = columns_outside(given.basis, monomials, ring, given.most);
    const TemplateEquations equations(given.constraints, rotations);
    check_rows(given, equations.all(), monomials, ring, columns.size());
    const Residue minor = determinant(matrix_of(given, equations.all(), monomials, ring, columns));
    if (minor != given.minor) throw Refused("the minor is ", minor.value, " modulo q");
}

BoundsFile replay_bounds(Reader& reader, const Execution& execution) try {
    constexpr std::uint64_t effort_of_a_template = 600;
    BoundsFile file;
    reader.take(say("modulus ", modulus, " $"));
    Records records(file.refusals, execution);
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        const Template given = read_template(reader);
        records.replay(line, "", [&] {
            records.spend(effort_of_a_template);
            check_template(given);
            ++file.templates;
            add_bound(file.bounds, type_of(given.constraints), given.basis.size());
        });
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
