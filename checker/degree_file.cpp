// Degree files (FORMAT.md, section 9): so many cameras explain the images of a class, with proof.
#include "checker/krawczyk.h"
#include "checker/record.h"

namespace checker {
struct DegreeRecord {
    std::size_t number = 0, line = 0;
    bool complete = false; // by evidence
    std::vector<std::size_t> features{};
    std::vector<FeatureImages> images{};
    std::vector<Start> solutions{};
};

/// Takes the rest of an image line: what the views see of the feature.
static FeatureImages read_images(Reader& reader, const Feature& feature) {
    FeatureImages images;
    const auto vector = [&](std::string_view word) {
        const Numbers x = reader.take(say(word, " @ @ @"));
        return Image{x[0], x[1], x[2]};
    };
    for (unsigned v = 0; v < 3; ++v) {
        const bool sees_point = feature.point >> v & 1;
        const Image& x = images.point[v];
        if (feature.views >> v & 1) reader.take("view");
        if (sees_point) images.point[v] = vector("point");
        for (std::size_t pin = 0; pin < feature.pins; ++pin)
            if (feature.pin[pin] >> v & 1)
                images.line[pin][v] = sees_point ? cross(x, vector("toward")) : vector("line");
    }
    reader.end_line();
    return images;
}

static Start read_solution(Reader& reader) {
    constexpr std::int64_t largest = 999'999'999'999'999'999;
    Start start{.line = reader.line(), .real = reader.comes("real")};
    reader.take(start.real ? "real" : "pair");
    start.bits = reader.integer(0, 200);
    for (auto& [real, imaginary] : start.coordinates) {
        real = reader.integer(-largest, largest);
        if (!start.real) imaginary = reader.integer(-largest, largest);
    }
    reader.end_line();
    return start;
}

static DegreeRecord read_degree(Reader& reader) {
    DegreeRecord record{.line = reader.line()};
    record.number = static_cast<std::size_t>(reader.take("degree # evidence")[0]);
    record.complete = reader.comes("complete");
    reader.take(record.complete ? "complete edges" : "none");
    if (record.complete) {
        reader.integer(0, 99);
        reader.take("trace");
        reader.comes("none") ? reader.take("none") : Numbers{reader.integer(-99, -1)};
    }
    reader.end_line();
    do {
        reader.take("image");
        const std::string_view name = reader.word();
        std::size_t i = 0;
        while (i < feature_count && features[i].notation != name) ++i;
        if (i == feature_count || record.images.size() == camera_unknowns)
            reader.fail(name, "one of at most 11 features of the table");
        record.features.push_back(i);
        record.images.push_back(read_images(reader, features[i]));
    } while (reader.comes("image"));
    do record.solutions.push_back(read_solution(reader));
    while (!reader.at_end() && !reader.comes("degree"));
    return record;
}

/// The system of a record. Throws Refused if it does not belong to its class.
static System system_of(const DegreeRecord& record, const Classification& classes) {
    if (record.number >= classes.representatives.size()) throw Refused("there is no such class");
    const Signature& signature = classes.representatives[record.number];
    if (!obstruction(signature).minimal()) throw Refused("the class is not minimal");
    std::vector<std::size_t> due;
    for (std::size_t i = 0; i < feature_count; ++i) due.insert(due.end(), signature[i], i);
    if (record.features != due)
        throw Refused("the images must be, in this order, those of ", notation(signature));
    System system;
    for (std::size_t i = 0; i < due.size(); ++i)
        add_feature(system, features[due[i]], record.images[i]);
    return system;
}

/// The number of solutions, proved to be different. Throws a Complaint about the line of one not.
static std::size_t count_solutions(const System& system, const std::vector<Start>& starts) {
    std::vector<std::pair<Box, std::size_t>> found; // with lines
    for (const Start& start : starts) {
        try {
            const Box box = certify(system, start);
            found.emplace_back(box, start.line);
            if (start.real) continue;
            if (box.meets(box.conjugate())) throw Refused("the pair may be real");
            found.emplace_back(box.conjugate(), start.line);
        } catch (const Refused& refused) {
            throw Complaint{start.line, refused.reason};
        }
    }
    // Boxes that meet do so in the real part of the last coordinate, by which they are sorted.
    constexpr std::size_t last = 2 * camera_unknowns - 2;
    std::ranges::sort(found, {}, [](const auto& one) { return one.first.low[last]; });
    for (auto a = found.begin(); a != found.end(); ++a)
        for (auto b = a + 1; b != found.end() && b->first.low[last] <= a->first.high[last]; ++b) {
            const auto [first, second] = std::minmax(a->second, b->second);
            if (a->first.meets(b->first))
                throw Complaint{second, say("this may be the solution of line ", first)};
        }
    return found.size();
}

void replay_degrees(Reader& reader, const Classification& classes, FileReport& report) {
    if (!has_arb) return report.refuse(reader.line(), "this plcheck was built without Arb");
    for (std::size_t due = 0; !reader.at_end();) {
        const DegreeRecord record = read_degree(reader);
        const std::string name = say("class ", record.number, ": ");
        if (record.number < due) throw Complaint{record.line, name + "comes too late"};
        due = record.number + 1;
        try {
            const System system = system_of(record, classes);
            const std::size_t count = count_solutions(system, record.solutions);
            report.degrees.push_back({record.number, record.line, count, record.complete});
        } catch (const Refused& refused) {
            report.refuse(record.line, name + refused.reason);
        } catch (const Complaint& complaint) {
            report.refuse(complaint.line, name + complaint.reason);
        }
    }
}
} // namespace checker
