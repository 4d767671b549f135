#include "checker/replay.h"

#include "checker/sha256.h"
#include "checker/version.h"

namespace checker {
/// Takes the number of the format. Throws Malformed, with the release that reads another format.
static void take_format(Reader& reader) {
    const int format = reader.small_integer(1, 999'999);
    if (format == 1)
        throw Malformed{{1, "this is a file of format 1: write it again with plprove 1.1 or newer, "
                            "or check it with plcheck 1.0"}};
    if (format > 2)
        throw Malformed{
            {1, say("this is a file of format ", format, ", and plcheck ", software_version,
                    " reads format 2: check it with a newer plcheck")}};
}

/// Takes the first line, and replays the rest as its kind of file. Throws Malformed.
static FileContent replay_certificates(const Classification& classes, std::string_view bytes,
                                       const Execution& execution) {
    Reader reader(bytes);
    reader.take("plcert");
    take_format(reader);
    const std::string_view kind = reader.word();
    reader.end_line();
    if (kind == "classification") return replay_classification(reader, classes);
    if (kind == "problem") return replay_problem(reader, classes);
    if (kind == "degrees") return replay_degrees(reader, classes, execution);
    if (kind == "problems") return replay_problems(reader, execution);
    if (kind == "solutions") return replay_solutions(reader, execution);
    if (kind == "at-most") return replay_at_most(reader, execution);
    if (kind == "model") return replay_model(reader, execution);
    throw Malformed{
        {1, say("found `", printable(kind, 40), "`, expected `classification`, ",
                "`problem`, `problems`, `solutions`, `at-most`, `degrees` or `model`")}};
}

static FileContent replay_content(const Classification& classes, std::string_view bytes,
                                  const Execution& execution) {
    if (bytes.size() > largest_file) return Malformed{{0, "the file is larger than 64 MiB"}};
    try {
        return replay_certificates(classes, bytes, execution);
    } catch (const Malformed& malformed) {
        return malformed;
    }
}

ReplayedFile replay(const Classification& classes, std::string_view name, std::string_view bytes,
                    const Execution& execution) {
    return {printable(name, 4096), sha256(bytes), replay_content(classes, bytes, execution)};
}
} // namespace checker
