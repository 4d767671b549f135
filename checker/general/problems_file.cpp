#include "checker/general/problems_file.h"

#include "checker/general/family.h"
#include "checker/general/record.h"

#include <set>

namespace checker::general {
/// Takes the family's name, if the file claims one.
static std::string read_family(Reader& reader) {
    if (!reader.comes("family")) return {};
    reader.take("family");
    const std::string name(reader.word());
    if (name != "plmp" && name != "projective") reader.fail(name, "`plmp` or `projective`");
    reader.end_line();
    return name;
}

static std::size_t size_of(const Classes& classes) {
    std::size_t size = 0;
    for (const auto& [key, problems] : classes)
        size += problems.size();
    return size;
}

ProblemsFile replay_problems(Reader& reader) {
    ProblemsFile file{.family = read_family(reader)};
    reader.take(say("modulus ", modulus, " $"));
    const bool has_family = !file.family.empty();
    const Classes classes = has_family ? family(file.family) : Classes{};
    std::set<const Problem*> decided; // classes of the family
    do {
        const Record record = read_record(reader);
        const auto& [notation, problem] = record.problem;
        try {
            const Problem* of_family = has_family ? find(classes, problem) : nullptr;
            if (has_family && !of_family) throw Refused("it is not in the family ", file.family);
            if (decided.contains(of_family)) throw Refused("a record before decides it");
            check_record(record);
            if (has_family) decided.insert(of_family);
            file.verdicts.push_back({notation, problem, record.minimal()});
        } catch (const Refused& refused) {
            file.refusals.add(record.line, say(printable(notation, 200), ": ", refused.reason));
        }
    } while (!reader.at_end());
    file.missing = size_of(classes) - decided.size();
    if (file.missing > 0)
        file.refusals.add(reader.line(), say("the family ", file.family, " has ", file.missing,
                                             " more problems; each needs a record that holds"));
    return file;
}
} // namespace checker::general
