#include "checker/minimal/classification_file.h"

#include "checker/minimal/pool.h"
#include "checker/minimal/record_lines.h"

namespace checker {
/// A feature line of a pool.
struct PlacedFeature {
    std::size_t line = 0;
    std::size_t index = 0; // in the table
    Numbers placement{};
};

/// The components of each feature that a class may use, and how many the file has. None if the
/// pool is refused.
struct Pool {
    bool holds = true;
    std::array<std::vector<Component>, feature_count> components{};
};

/// Takes the feature lines of a pool, in the order of the table.
static std::vector<PlacedFeature> read_features(Reader& reader) {
    std::vector<PlacedFeature> placed;
    do {
        if (placed.size() == 1000) reader.fail("feature", "at most 1000 features in a pool");
        const std::size_t line = reader.line();
        reader.take("feature");
        const std::string_view name = reader.word();
        const std::size_t index = index_of(name);
        const std::size_t least = placed.empty() ? 0 : placed.back().index;
        if (index == feature_count || index < least)
            reader.fail(name, "a feature, in the order of the table");
        placed.push_back({line, index, read_placement(reader, features[index].pins)});
    } while (reader.comes("feature"));
    return placed;
}

/// Eliminates the features of a pool, up to the number that a balanced problem can have. All must
/// meet the requirements of section 2, or the pool is refused.
static Pool pool_of(const std::vector<Numbers>& cameras, std::size_t line,
                    const std::vector<PlacedFeature>& placed, std::size_t number,
                    Refusals& refusals) {
    Pool pool;
    std::size_t at = line;
    try {
        require_cameras(calibrated_cameras, cameras);
        for (const auto& [feature_line, index, placement] : placed) {
            const Feature& feature = features[index];
            at = feature_line;
            std::vector<Component>& components = pool.components[index];
            if (components.size() == camera_unknowns / feature.weight()) {
                require_section_2(problem_of(feature, 3), {cameras, placement});
                continue;
            }
            Jacobian<mpz_class> j = rows_of(feature, 3, {cameras, placement});
            components.push_back(component_of(j.own, std::move(j.rows)));
        }
    } catch (const Refused& refused) {
        refusals.add(at, say("pool ", number, ": ", refused.reason));
        return {.holds = false};
    }
    return pool;
}

/// The components of a class in a pool.
static std::vector<const Component*> components_of(const Signature& signature, const Pool& pool) {
    if (!pool.holds) throw Refused("its pool is refused");
    std::vector<const Component*> components;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (pool.components[i].size() < signature[i])
            throw Refused("its pool has too few ", features[i].notation);
        for (std::size_t n = 0; n < signature[i]; ++n)
            components.push_back(&pool.components[i][n]);
    }
    return components;
}

/// The obstruction of a class, if its record holds; else throws Refused.
static Obstruction check_class(std::size_t number, std::size_t pool, const MinorClaim& claim,
                               const std::vector<Pool>& pools, const Classification& classes) {
    if (number >= classes.representatives.size()) throw Refused("there is no such class");
    if (pool == 0 || pool > pools.size()) throw Refused("there is no such pool");
    const Signature& signature = classes.representatives[number];
    const Obstruction found = obstruction(signature);
    check_claim(claim, found, components_of(signature, pools[pool - 1]));
    return found;
}

ClassificationFile replay_classification(Reader& reader, const Classification& classes) {
    ClassificationFile file;
    reader.take(say("modulus ", modulus, " $"));
    std::vector<Pool> pools;
    while (reader.comes("pool")) {
        const std::size_t number = pools.size() + 1;
        const std::size_t line = reader.line();
        const std::vector<Numbers> cameras = read_cameras(reader, number, 3);
        pools.push_back(pool_of(cameras, line, read_features(reader), number, file.refusals));
    }
    std::size_t due = 0; // the class whose record is due
    const auto refuse_missing = [&](std::size_t end, std::size_t line) {
        for (; due < std::min(end, classes.representatives.size()); ++due)
            file.refusals.add(line, say("class ", due, ": there is no certificate"));
    };
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        const bool minimal = reader.comes("minimal");
        const Numbers words = reader.take(minimal ? "minimal # #" : "deficient # #");
        const auto number = static_cast<std::size_t>(words[0]);
        const auto pool = static_cast<std::size_t>(words[1]);
        const MinorClaim claim = read_minor_in_pool(reader, minimal);
        if (number < due) throw Malformed{{line, say("class ", number, " is out of order")}};
        refuse_missing(number, line);
        due = number + 1;
        try {
            file.verdicts.push_back({number, check_class(number, pool, claim, pools, classes)});
        } catch (const Refused& refused) {
            file.refusals.add(line, say("class ", number, ": ", refused.reason));
        }
    }
    refuse_missing(classes.representatives.size(), reader.line());
    return file;
}
} // namespace checker
