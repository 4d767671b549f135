#include "checker/family/problems_file.h"

#include "checker/family/family.h"
#include "checker/minimal/record_lines.h"
#include "checker/problem/notation.h"

#include <set>

namespace checker {
/// Takes the family's name, if the file claims one.
static std::string read_family(Reader& reader) {
    if (!reader.comes("family")) return {};
    reader.take("family");
    const std::string name(reader.word());
    if (name != "plmp" && name != "projective") reader.fail(name, "`plmp` or `projective`");
    reader.end_line();
    return name;
}

static std::size_t size_of(const IsomorphismClasses& classes) {
    std::size_t size = 0;
    for (const auto& [key, problems] : classes)
        size += problems.size();
    return size;
}

/// How many coordinates there are.
static std::size_t size_of(const Placement& placement) {
    std::size_t size = placement.scene.size();
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
    ProblemsFile file{.family = read_family(reader)};
    Effort effort(execution.effort);
    reader.take(say("modulus ", modulus, " $"));
    const bool has_family = !file.family.empty();
    const IsomorphismClasses classes = has_family ? family(file.family) : IsomorphismClasses{};
    std::set<const Problem*> decided; // classes of the family
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        reader.take("problem");
        const auto [notation, list, problem] = read_notation(reader);
        const Record record = read_record(reader, line, problem);
        effort.spend(effort_of(record), line);
        try {
            const Problem* of_family = has_family ? find(classes, problem) : nullptr;
            if (has_family && !of_family) throw Refused("it is not in the family ", file.family);
            if (decided.contains(of_family)) throw Refused("a record before decides it");
            check_record(record, problem);
            if (has_family) decided.insert(of_family);
            file.verdicts.push_back({notation, problem, record.minimal()});
        } catch (const Refused& refused) {
            file.refusals.add(line, say(printable(notation, 200), ": ", refused.reason));
        }
    }
    file.missing = size_of(classes) - decided.size();
    if (file.missing > 0)
        file.refusals.add(reader.line(), say("the family ", file.family, " has ", file.missing,
                                             " more problems; each needs a record that holds"));
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
