#include "checker/bounds/constraints.h"

namespace checker {
/// Takes the words, and the numbers among them as `count` vectors.
template <std::size_t count>
static std::array<IntegerVector, count> take(Reader& reader, std::string_view words) {
    const Numbers numbers = reader.take(words);
    std::array<IntegerVector, count> vectors;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        vectors[i / 3][i % 3] = numbers[i];
    return vectors;
}

static Star read_star(Reader& reader) {
    const auto [point, image] = take<2>(reader, "star point @ @ @ image @ @ @");
    Star star{.point = point, .image = image};
    while (reader.comes("pin")) {
        if (star.pins.size() == 6) reader.fail("pin", "at most 6 pins");
        const auto [direction, toward] = take<2>(reader, "pin @ @ @ toward @ @ @");
        star.pins.push_back({direction, toward});
    }
    reader.end_line();
    return star;
}

static KnownLine read_line(Reader& reader) {
    const auto [point, direction, image] =
        take<3>(reader, "line point @ @ @ direction @ @ @ image @ @ @ $");
    return {point, direction, image};
}

static Incidence read_incidence(Reader& reader) {
    const auto [point, line] = take<2>(reader, "incidence point @ @ @ line @ @ @ $");
    return {point, line};
}

static Group read_group(Reader& reader) {
    const auto [point] = take<1>(reader, "transversals point @ @ @");
    Group group{.point = point};
    do {
        if (group.rays.size() == 6) reader.fail("direction", "at most 6 rays");
        const auto [direction, image] = take<2>(reader, "direction @ @ @ image @ @ @");
        group.rays.push_back({direction, image});
    } while (!reader.at_end());
    reader.end_line();
    return group;
}

Constraints read_constraints(Reader& reader, Frame frame) {
    Constraints constraints{.frame = frame};
    std::size_t lines = 0; // of the file
    const auto comes = [&](std::string_view word) {
        if (!reader.comes(word)) return false;
        if (++lines > 6) reader.fail(word, "at most 6 lines of constraints");
        return true;
    };
    while (comes("star"))
        constraints.stars.push_back(read_star(reader));
    while (comes("line"))
        constraints.lines.push_back(read_line(reader));
    while (comes("incidence"))
        constraints.incidences.push_back(read_incidence(reader));
    while (comes("transversals"))
        constraints.groups.push_back(read_group(reader));
    return constraints;
}

Registration type_of(const Constraints& constraints) {
    Registration type;
    for (const Star& star : constraints.stars)
        ++type.stars[star.pins.size()];
    type.lines = static_cast<unsigned>(constraints.lines.size());
    type.incidences = static_cast<unsigned>(constraints.incidences.size());
    for (const Group& group : constraints.groups)
        ++type.groups[group.rays.size()];
    return type;
}

unsigned weight_of(const Constraints& constraints) {
    std::size_t weight = 2 * constraints.lines.size() + constraints.incidences.size();
    for (const Star& star : constraints.stars)
        weight += 2 + star.pins.size();
    for (const Group& group : constraints.groups)
        weight += group.rays.size();
    return static_cast<unsigned>(weight);
}
} // namespace checker
