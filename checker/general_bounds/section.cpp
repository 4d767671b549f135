#include "checker/general_bounds/section.h"

#include "checker/general_bounds/vanishing.h"

#include <bit>

namespace checker {
static void multiply(SmallRow& row, const SmallRow& by) {
    for (std::size_t k = 0; k < row.size(); ++k)
        row[k] = row[k] * by[k];
}

/// Those of all cameras.
static std::vector<Resection> resections_of(const SceneSystem& system) {
    std::vector<Resection> resections;
    for (std::size_t camera = 0; camera < system.cameras; ++camera)
        resections.emplace_back(system, camera);
    return resections;
}

/// The effort of computing the values of all cubic forms at this number of scenes. Throws Refused
/// if these are too many.
static std::uint64_t effort_of_values(const std::vector<Resection>& resections,
                                      std::size_t scenes) {
    constexpr std::size_t most_values = 20'000'000;
    std::size_t values = 0;
    for (const Resection& resection : resections)
        values += resection.minors() * scenes;
    if (values > most_values)
        throw Refused("it takes more than ", most_values,
                      " values of cubic forms: leave further images out, or take smaller powers");
    return values / 100'000;
}

/// Elimination grows with the cube of the number of monomials.
static std::uint64_t effort_of_elimination(std::uint64_t monomials) {
    return monomials * monomials * monomials / 1'000'000;
}

/// Forms in the coordinates of scenes, by their values at some random scenes. Cameras are numbered
/// from that of view 2; those from `given` on belong to further images.
class Forms {
public:
    Forms(const SceneSystem& system, const std::vector<Resection>& resections,
          const SceneCoordinates& coordinates, std::size_t given, std::size_t scenes,
          Choices& choices)
        : cubics_(system.cameras), linear_(coordinates.kept().size()), given_(given),
          scenes_(scenes), choices_(choices) {
        for (std::size_t scene = 0; scene < scenes; ++scene) {
            SmallRow own(system.depths);
            for (const std::size_t depth : coordinates.kept())
                own[depth] = choices.next();
            append(linear_, coordinates.of(own));
            const SmallRow depths = place_depths(system, own);
            for (std::size_t camera = 0; camera < system.cameras; ++camera)
                append(cubics_[camera], resections[camera].cubics(depths));
        }
    }

    /// One of the coordinates.
    const SmallRow& first_coordinate() const { return linear_[0]; }

    /// A cubic form of a camera.
    SmallRow cubic(std::size_t camera) const { return combination(cubics_[camera]); }

    /// A product of cubic forms of further images, and of coordinates.
    SmallRow product(const Powers& powers) const {
        SmallRow row(scenes_, Small{1});
        for (int i = 0; i < powers.cubics; ++i) {
            const std::size_t further = cubics_.size() - given_;
            multiply(row, cubic(given_ + choices_.next().value % further));
        }
        for (int i = 0; i < powers.linear; ++i)
            multiply(row, combination(linear_));
        return row;
    }

private:
    /// Adds a value to each row.
    static void append(std::vector<SmallRow>& rows, const SmallRow& values) {
        rows.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            rows[i].push_back(values[i]);
    }

    SmallRow combination(const std::vector<SmallRow>& rows) const {
        SmallRow sum(scenes_);
        for (const SmallRow& row : rows) {
            const Small factor = choices_.next();
            for (std::size_t k = 0; k < scenes_; ++k)
                sum[k] = sum[k] + factor * row[k];
        }
        return sum;
    }

    std::vector<std::vector<SmallRow>> cubics_; // of each camera
    std::vector<SmallRow> linear_;
    std::size_t given_, scenes_;
    Choices& choices_;
};

/// Adds forms that this makes, some at a time, until it makes nothing new.
template <class Make> static void fill(RowSpace& space, const Make& make) {
    constexpr std::size_t rows_at_a_time = 32;
    for (bool is_new = true; is_new;) {
        std::vector<SmallRow> rows;
        for (std::size_t i = 0; i < rows_at_a_time; ++i)
            rows.push_back(make(i));
        is_new = space.add(rows);
    }
}

std::size_t solutions_at_most(const Problem& problem, const std::vector<Numbers>& views,
                              const Powers& powers, const Spend& spend) {
    if (!problem.cameras->all_matrices) throw Refused("its cameras are ", problem.cameras->name);
    const SceneSystem system = scene_system(problem, views);
    const BaseScenes base = base_scenes(problem, system);
    const SceneCoordinates coordinates(system, base.few_depths);
    const std::vector<Resection> resections = resections_of(system);
    const auto monomials = monomials_that_fit(base, coordinates, powers);
    spend(effort_of_elimination(monomials.size()));
    Choices choices;
    const std::size_t dimension =
        monomials.size() -
        rank_of_conditions(monomials, problem, system, base, coordinates, powers, choices);
    const auto given = static_cast<std::size_t>(std::popcount(problem.views)) - 1;
    constexpr std::size_t more = 20; // scenes than dimensions, to notice a mistake
    const std::size_t scenes = dimension + more;
    spend(effort_of_values(resections, scenes + base.size()));
    try_lemmas(problem, system, base, coordinates, resections);
    const Forms forms(system, resections, coordinates, given, scenes, choices);
    RowSpace space;
    fill(space, [&](std::size_t i) { // forms that vanish at all solutions
        SmallRow row = forms.product({powers.cubics - 1, powers.linear});
        multiply(row, forms.cubic(i % given));
        return row;
    });
    const std::size_t at_solutions = space.rank();
    fill(space, [&](std::size_t) { // multiples of one coordinate
        SmallRow row = forms.product({powers.cubics, powers.linear - 1});
        multiply(row, forms.first_coordinate());
        return row;
    });
    if (space.rank() > dimension)
        throw Refused("the forms have more dimensions than Lemmas F3 to F5 allow: report this");
    if (space.rank() < dimension)
        throw Refused("the forms leave ", dimension - space.rank(), " of ", dimension,
                      " dimensions open: take other powers");
    return dimension - at_solutions;
}
} // namespace checker
