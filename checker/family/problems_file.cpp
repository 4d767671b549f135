#include "checker/family/problems_file.h"

#include "checker/family/family.h"
#include "checker/minimal/record_lines.h"
#include "checker/problem/notation.h"

namespace checker {
/// Takes the family's name, if the file claims one.
static const CameraModel* read_family(Reader& reader) {
    if (!reader.comes("family")) return nullptr;
    reader.take("family");
    const std::string_view name = reader.word();
    const CameraModel* cameras = cameras_of_family(name);
    if (!cameras) reader.fail(name, "`plmp` or a kind of cameras");
    reader.end_line();
    return cameras;
}

/// How many coordinates there are.
static std::size_t size_of(const Placement& placement) {
    std::size_t size = placement.shared.size() + placement.scene.size();
    for (const Numbers& camera : placement.cameras)
        size += camera.size();
    return size;
}

/// The effort of a record: that of elimination grows with the cube of the size of J.
static std::uint64_t effort_of(const Record& record) {
    const auto* minor = std::get_if<MinorClaim>(&record.claim);
    const std::uint64_t size = minor ? size_of(minor->placement) : 0;
    return 10 + size * size * size / 200'000;
}

ProblemsFile replay_problems(Reader& reader, const Execution& execution) try {
    const CameraModel* cameras = read_family(reader);
    ProblemsFile file{.family = cameras ? std::string(family_name(*cameras)) : ""};
    Records records(file.refusals, execution);
    reader.take(say("modulus ", modulus, " $"));
    const bool has_family = cameras != nullptr;
    const Problems all = has_family ? family(*cameras) : Problems{};
    Problems decided; // of the family
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        reader.take("problem");
        const auto written = read_notation(reader);
        const std::string& notation = written.notation;
        const Problem& problem = written.problem;
        const Record record = read_record(reader, line, problem);
        records.replay(line, printable(notation, 200) + ": ", [&] {
            records.spend(effort_of(record));
            if (has_family && !all.find(problem))
                throw Refused("it is not in the family ", file.family);
            if (decided.find(problem)) throw Refused("a record before decides it");
            check_record(record, problem);
            if (has_family) decided[problem] = {};
            file.verdicts.push_back({notation, problem, record.minimal()});
        });
    }
    file.missing = all.count() - decided.count();
    if (file.missing > 0)
        file.refusals.add(reader.line(), say("the family ", file.family, " has ", file.missing,
                                             " more problems; each needs a record that holds"));
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
