#include "checker/general_bounds/resection.h"

#include "checker/file/complaint.h"

namespace checker {
Row3 residues(const ImageCoordinates& v) {
    return {Small::of_integer(v[0]), Small::of_integer(v[1]), Small::of_integer(v[2])};
}

SmallRow place_depths(const SceneSystem& system, const SmallRow& own) {
    SmallRow depths;
    for (const Place& place : system.places) {
        Small depth;
        for (std::size_t k = 0; k < place.depth.size(); ++k)
            depth = depth + Small::of_integer(place.depth[k]) * own[k];
        depths.push_back(depth);
    }
    return depths;
}

/// The rows of all combinations of these rows that are 0: a basis, by Gaussian elimination. Each
/// of the rows has a number for each column. None unless the columns are independent.
static std::vector<SmallRow> relations(std::vector<SmallRow> rows, std::size_t columns) {
    const std::size_t count = rows.size();
    for (std::size_t r = 0; r < count; ++r) {
        rows[r].resize(columns + count);
        rows[r][columns + r] = Small{1};
    }
    for (std::size_t c = 0; c < columns; ++c) {
        std::size_t pivot = c;
        while (pivot < count && rows[pivot][c] == Small{})
            ++pivot;
        if (pivot == count) return {};
        std::swap(rows[c], rows[pivot]);
        const Small inverse = rows[c][c].inverse();
        for (std::size_t r = c + 1; r < count; ++r) {
            const Small factor = -rows[r][c] * inverse;
            for (std::size_t k = c; k < columns + count; ++k)
                rows[r][k] = rows[r][k] + factor * rows[c][k];
        }
    }
    std::vector<SmallRow> found;
    for (std::size_t r = columns; r < count; ++r)
        found.emplace_back(rows[r].begin() + static_cast<std::ptrdiff_t>(columns), rows[r].end());
    return found;
}

Resection::Resection(const SceneSystem& system, std::size_t camera) {
    constexpr std::size_t entries_of_m = 9;
    std::vector<SmallRow> by_m;
    for (const SceneEquation& equation : system.equations) {
        if (equation.camera != camera) continue;
        const auto line = residues(equation.line);
        const auto x = residues(system.places[equation.place].x);
        SmallRow& row = by_m.emplace_back();
        for (const Small l : line)
            for (const Small coordinate : x)
                row.push_back(l * coordinate);
        incidences_.push_back({line, equation.place});
    }
    if (by_m.size() < entries_of_m + 3) throw Refused("an image has fewer than 12 equations");
    eliminations_ = relations(by_m, entries_of_m);
    if (eliminations_.empty())
        throw Refused("an image is too special: it leaves a part of the camera open");
}

std::vector<Row3> Resection::matrix(const SmallRow& depths) const {
    std::vector<Row3> n;
    for (const SmallRow& elimination : eliminations_) {
        Row3& row = n.emplace_back();
        for (std::size_t e = 0; e < incidences_.size(); ++e) {
            const Small factor = elimination[e] * depths[incidences_[e].place];
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] = row[i] + factor * incidences_[e].line[i];
        }
    }
    return n;
}

SmallRow Resection::cubics(const SmallRow& depths) const {
    const std::vector<Row3> n = matrix(depths);
    SmallRow minors;
    for (std::size_t c = 0; c < n.size(); ++c)
        for (std::size_t b = 0; b < c; ++b)
            for (std::size_t a = 0; a < b; ++a)
                minors.push_back(determinant(n[a], n[b], n[c]));
    return minors;
}

bool Resection::vanish(const SmallRow& depths, const SmallRow& directions, bool twice) const {
    const std::vector<Row3> n = matrix(depths), d = matrix(directions);
    for (std::size_t c = 0; c < n.size(); ++c)
        for (std::size_t b = 0; b < c; ++b)
            for (std::size_t a = 0; a < b; ++a) {
                if (determinant(n[a], n[b], n[c]) != Small{}) return false;
                const Small derivative = determinant(d[a], n[b], n[c]) +
                                         determinant(n[a], d[b], n[c]) +
                                         determinant(n[a], n[b], d[c]);
                if (twice && derivative != Small{}) return false;
            }
    return true;
}
} // namespace checker
