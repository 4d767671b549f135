#include "prover/fibres/linear_unknowns.h"

#include "prover/model/prime_field.h"

#include <utility>

namespace plprove {

namespace {

using model::Univariate;
using Row = std::vector<Univariate>;

/// The rows are equations: factors of the unknowns, and what is to be added to their sum.
std::vector<Row> rows_of(const UnivariateField& field, Row point, std::size_t count,
                         const UnivariateEquations& equations) {
    const std::size_t known = point.size();
    point.resize(known + count);
    const Row constants = equations(point);
    std::vector<Row> rows(constants.size());
    for (std::size_t k = known; k < point.size(); ++k) {
        point[k] = field.constant(1);
        const Row values = equations(point);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].push_back(field.difference(values[i], constants[i]));
        point[k] = {};
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].push_back(constants[i]);
    return rows;
}

/// Moves a row to place k whose entry there has an inverse, and divides by it.
bool find_pivot(const UnivariateField& field, std::vector<Row>& rows, std::size_t k) {
    for (std::size_t i = k; i < rows.size(); ++i)
        try {
            const Univariate inverse = field.inverse(rows[i][k]);
            for (Univariate& x : rows[i])
                x = field.product(x, inverse);
            std::swap(rows[i], rows[k]);
            return true;
        } catch (const model::NotInvertible&) {
            continue; // it vanishes at some solution
        }
    return false;
}

void subtract(const UnivariateField& field, Row& row, const Row& pivot, std::size_t k) {
    const Univariate factor = row[k];
    for (std::size_t j = k; j < row.size(); ++j)
        row[j] = field.difference(row[j], field.product(factor, pivot[j]));
}

} // namespace

std::optional<std::vector<Univariate>> with_linear_unknowns(const UnivariateField& field,
                                                            std::vector<Univariate> first,
                                                            std::size_t count,
                                                            const UnivariateEquations& equations) {
    std::vector<Row> rows = rows_of(field, first, count, equations);
    for (std::size_t k = 0; k < count; ++k) {
        if (!find_pivot(field, rows, k)) return std::nullopt;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (i != k) subtract(field, rows[i], rows[k], k);
    }
    for (std::size_t i = count; i < rows.size(); ++i)
        if (!rows[i][count].is_zero()) return std::nullopt;
    for (std::size_t k = 0; k < count; ++k)
        first.push_back(field.difference({}, rows[k][count]));
    return first;
}

} // namespace plprove
