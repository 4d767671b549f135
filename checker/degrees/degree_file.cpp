#include "checker/degrees/degree_file.h"

#include "checker/degrees/krawczyk.h"
#include "checker/problem/obstruction.h"

namespace checker {
/// An image line: a feature of the table, and what the views see of it.
struct FeatureLine {
    std::size_t index = 0;
    FeatureImages images{};
};

/// A record up to its solutions.
struct DegreeRecord {
    std::size_t line = 0;
    std::size_t number = 0;
    bool complete = false; // by evidence
    std::vector<FeatureLine> features{};
};

/// Takes a word and a vector.
static Image read_image(Reader& reader, std::string_view word) {
    const Numbers x = reader.take(say(word, " @ @ @"));
    return {x[0], x[1], x[2]};
}

/// Takes the rest of an image line.
static FeatureImages read_images(Reader& reader, const Feature& feature) {
    FeatureImages images;
    for (std::size_t view = 0; view < 3; ++view) {
        if (!has_view(feature.views, view)) continue;
        reader.take("view");
        const bool sees_point = has_view(feature.point, view);
        Image& point = images.point[view];
        if (sees_point) point = read_image(reader, "point");
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (!has_view(feature.pin[pin], view)) continue;
            Image& line = images.line[pin][view];
            if (sees_point)
                line = cross(point, read_image(reader, "toward"));
            else
                line = read_image(reader, "line");
        }
    }
    reader.end_line();
    return images;
}

static FeatureLine read_feature_line(Reader& reader) {
    reader.take("image");
    const std::string_view name = reader.word();
    const std::size_t index = index_of(name);
    if (index == feature_count) reader.fail(name, "a feature of the table");
    return {index, read_images(reader, features[index])};
}

static ApproximateSolution read_solution(Reader& reader) {
    constexpr std::int64_t largest = 999'999'999'999'999'999;
    ApproximateSolution solution{.line = reader.line(), .real = reader.comes("real")};
    reader.take(solution.real ? "real" : "pair");
    solution.bits = reader.small_integer(0, 200);
    for (auto& [real, imaginary] : solution.coordinates) {
        real = reader.integer(-largest, largest);
        if (!solution.real) imaginary = reader.integer(-largest, largest);
    }
    reader.end_line();
    return solution;
}

/// Takes what follows `evidence`: whether it says that there are no more solutions. At least one
/// edge, or a trace, has to say so.
static bool read_evidence(Reader& reader) {
    if (reader.comes("none")) {
        reader.take("none $");
        return false;
    }
    reader.take("complete edges");
    const int edges = reader.small_integer(0, 99);
    reader.take("trace");
    const bool has_trace = !reader.comes("none");
    if (has_trace)
        reader.small_integer(-99, -1);
    else if (edges > 0)
        reader.take("none");
    else
        reader.fail("none", "the exponent of a trace, as there are 0 edges");
    reader.end_line();
    return true;
}

static DegreeRecord read_record(Reader& reader) {
    DegreeRecord record{.line = reader.line()};
    record.number = static_cast<std::size_t>(reader.take("degree # evidence")[0]);
    record.complete = read_evidence(reader);
    do {
        if (record.features.size() == camera_unknowns) reader.fail("image", "at most 11 features");
        record.features.push_back(read_feature_line(reader));
    } while (reader.comes("image"));
    return record;
}

/// The system of a record. Throws Refused if it does not belong to its class.
static CameraSystem system_of(const DegreeRecord& record, const Classification& classes) {
    if (record.number >= classes.representatives.size()) throw Refused("there is no such class");
    const Signature& signature = classes.representatives[record.number];
    if (!obstruction(signature).minimal()) throw Refused("the class is not minimal");
    std::vector<std::size_t> expected, found;
    for (std::size_t i = 0; i < feature_count; ++i)
        expected.insert(expected.end(), signature[i], i);
    CameraSystem system;
    for (const FeatureLine& line : record.features)
        found.push_back(line.index);
    if (found != expected)
        throw Refused("the images must be, in this order, those of ", notation(signature));
    for (const auto& [index, images] : record.features)
        add_feature(system, features[index], images);
    return system;
}

/// The effort of a proof: numbers of twice as many bits, and more steps, take four times as much.
static std::uint64_t effort_of(const Proof& proof) {
    const auto* box = std::get_if<Box>(&proof);
    if (!box || box->tries == 1) return 1;
    return box->tries == 2 ? 4 : 16;
}

/// A box with one solution, and the line of its starting values.
struct Found {
    Box box;
    std::size_t line;
};

/// The solutions of a record that are proved so far. No two boxes meet. (They are as many as the
/// degree at most, so it does not take long to compare them all.)
class ProvedSolutions {
public:
    std::size_t count() const { return found_.size(); }

    /// Adds what is proved of a starting value: a solution, and its conjugate unless it is real.
    /// Throws Refused if nothing is, or if it may be one that is added before.
    void add(const ApproximateSolution& start, const Proof& proof) {
        if (const auto* refused = std::get_if<Refused>(&proof)) throw *refused;
        const Box& box = std::get<Box>(proof);
        add({box, start.line});
        if (start.real) return;
        const Box conjugate = box.conjugate();
        if (box.meets(conjugate)) throw Refused("the pair may be real");
        add({conjugate, start.line});
    }

private:
    void add(const Found& solution) {
        for (const Found& before : found_)
            if (before.box.meets(solution.box))
                throw Refused("this may be the solution of line ", before.line);
        found_.push_back(solution);
    }

    std::vector<Found> found_;
};

/// Takes the solutions of a record and proves them as they come, some at a time. After one that is
/// refused, the others are only read.
class RecordReplay {
public:
    RecordReplay(Reader& reader, DegreeFile& file, const Execution& execution, Progress& progress,
                 Effort& effort)
        : reader_(reader), file_(file), execution_(execution), progress_(progress),
          effort_(effort) {}

    void run(const DegreeRecord& record, const Classification& classes) {
        ++progress_.records;
        std::size_t line = record.line; // at fault, if one is
        try {
            if (file_.refusals.count >= most_refusals)
                throw Refused("not replayed, as ", most_refusals, " records are refused before it");
            const CameraSystem system = system_of(record, classes);
            ProvedSolutions proved;
            do {
                const auto starts = read_some(proved.count());
                const auto proofs = certify_all(system, starts, execution_.threads);
                for (std::size_t i = 0; i < starts.size(); ++i) {
                    line = starts[i].line;
                    effort_.spend(effort_of(proofs[i]), line);
                    proved.add(starts[i], proofs[i]);
                    ++progress_.solutions;
                    execution_.watch({line, progress_.records, progress_.solutions});
                }
            } while (has_more());
            file_.bounds.push_back({record.number, proved.count(), record.complete});
        } catch (const Refused& refused) {
            file_.refusals.add(line, say("class ", record.number, ": ", refused.reason));
            skip(line == record.line);
        }
    }

private:
    bool has_more() const { return !reader_.at_end() && !reader_.comes("degree"); }

    /// Reads as many solutions as the threads shall prove at a time. What comes after a flaw is
    /// proved in vain; so at first these are few, as most flawed records have their flaw early.
    std::vector<ApproximateSolution> read_some(std::size_t proved) {
        const std::size_t threads = execution_.threads;
        const std::size_t most = threads == 1 ? 1 : std::clamp(proved, threads, 64 * threads);
        std::vector<ApproximateSolution> starts;
        do
            starts.push_back(read_solution(reader_));
        while (starts.size() < most && has_more());
        return starts;
    }

    /// Reads the solutions that are left, one at least if none is read yet.
    void skip(bool none_is_read) {
        if (none_is_read) read_solution(reader_);
        while (has_more())
            read_solution(reader_);
    }

    Reader& reader_;
    DegreeFile& file_;
    const Execution& execution_;
    Progress& progress_;
    Effort& effort_;
};

DegreeFile replay_degrees(Reader& reader, const Classification& classes,
                          const Execution& execution) try {
    DegreeFile file;
    if (!has_arb) {
        file.refusals.add(reader.line(), "this plcheck was built without Arb");
        return file;
    }
    Progress progress;
    Effort effort(execution.effort);
    for (std::size_t due = 0; !reader.at_end();) {
        const DegreeRecord record = read_record(reader);
        if (record.number < due)
            throw Malformed{{record.line, say("class ", record.number, ": is out of order")}};
        due = record.number + 1;
        RecordReplay(reader, file, execution, progress, effort).run(record, classes);
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
