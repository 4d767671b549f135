#include "checker/degrees/degree_file.h"

#include "checker/degrees/cameras_at.h"
#include "checker/degrees/shared_matrices.h"
#include "checker/degrees/solutions.h"
#include "checker/fibres/prove_fibre.h"
#include "checker/minimal/obstruction.h"

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
    std::vector<FeatureLine> features{};
};

/// Takes a word and a vector.
static Image read_image(Reader& reader, std::string_view word) {
    reader.take(word);
    Image image;
    for (mpz_class& coordinate : image)
        coordinate = reader.big_integer(18);
    return image;
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

/// Takes what follows `evidence`, which proves nothing.
static void read_evidence(Reader& reader) {
    if (reader.comes("none")) {
        reader.take("none $");
        return;
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
}

static DegreeRecord read_record(Reader& reader) {
    DegreeRecord record{.line = reader.line()};
    record.number = static_cast<std::size_t>(reader.take("degree # evidence")[0]);
    read_evidence(reader);
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

/// What the records of a file are about, and where what they prove goes.
class DegreeReplay {
public:
    DegreeReplay(Reader& reader, const Classification& classes, const Execution& execution,
                 DegreeFile& file)
        : reader_(reader), classes_(classes), file_(file), records_(file.refusals, execution),
          solutions_(reader, records_, execution.threads) {}

    void run() {
        for (std::size_t due = 0; !reader_.at_end();) {
            const DegreeRecord record = read_record(reader_);
            const std::string about = say("class ", record.number);
            if (record.number < due) throw Malformed{{record.line, about + ": is out of order"}};
            if (record.number != fibres_.number) finish_fibres();
            const bool is_fibre = reader_.comes("fibre");
            due = is_fibre ? record.number : record.number + 1;
            if (is_fibre)
                replay_fibre(record, about);
            else
                replay_solutions(record, about);
        }
        finish_fibres();
    }

private:
    void replay_fibre(const DegreeRecord& record, const std::string& about) {
        const std::size_t degree = read_fibre_degree(reader_);
        const Fibre fibre = read_fibre(reader_, degree, camera_unknowns, camera_unknowns);
        records_.replay(record.line, about + ": ", [&] {
            records_.spend(effort_of(fibre));
            prove_fibre<CamerasAt>(system_of(record, classes_), fibre);
            file_.bounds.push_back({record.number, degree, {}, {}});
            fibres_.number = record.number;
            fibres_.proved.push_back(fibre);
        });
    }

    /// Adds what all fibres of one class show.
    void finish_fibres() {
        if (fibres_.proved.empty()) return;
        std::vector<Polynomial> polynomials;
        for (const Fibre& fibre : fibres_.proved)
            polynomials.push_back(fibre.lower);
        const std::size_t most =
            std::ranges::max_element(polynomials, {}, &Polynomial::size)->size();
        std::erase_if(fibres_.proved,
                      [&](const Fibre& fibre) { return fibre.lower.size() < most; });
        const auto spend = [&](std::uint64_t effort) { records_.spend(effort); };
        LowerBound& bound = file_.bounds.back();
        bound.cycle_types = cycle_types_of(polynomials, spend);
        for (std::size_t i = 0; i < bound.cycle_types.size(); ++i)
            add_block_cycles(fibres_.proved[i], bound.cycle_types[i], bound);
        fibres_ = {};
    }

    void add_block_cycles(const Fibre& fibre, const CycleType& solutions, LowerBound& bound) {
        const std::uint64_t degree = fibre.lower.size();
        records_.spend(degree * degree * degree / 100'000);
        for (const auto& [views, values] : shared_matrices(fibre))
            bound.block_cycles.push_back({views, solutions, cycle_type_of(values)});
    }

    void replay_solutions(const DegreeRecord& record, const std::string& about) {
        const auto prepare = [&]() -> Certify {
            if (!has_arb) throw Refused("this plcheck was built without Arb: see --version");
            return [system = system_of(record, classes_)](const ApproximateSolution& start) {
                return certify(system, start);
            };
        };
        const auto count = solutions_.run({camera_unknowns, "degree"}, record.line, about, prepare);
        if (count) file_.bounds.push_back({record.number, *count, {}, {}});
    }

    /// The fibres of a class that hold.
    struct Fibres {
        std::size_t number = 0;
        std::vector<Fibre> proved{};
    };

    Reader& reader_;
    const Classification& classes_;
    DegreeFile& file_;
    Records records_;
    SolutionsReplay solutions_;
    Fibres fibres_{};
};

DegreeFile replay_degrees(Reader& reader, const Classification& classes,
                          const Execution& execution) try {
    DegreeFile file;
    DegreeReplay(reader, classes, execution, file).run();
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
