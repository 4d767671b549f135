// What a sweep keeps of a class, or of a problem of a family: one file, which is a valid file of
// certificates (certs/FORMAT.md, sections 9 and 14) with the rest of the run in a comment, so that
// both appear at a stroke. The comment has a digest of the record below, and ends with one of its
// own: they show damage.
//
//     plcert 2 degrees
//     # run {"number":2394,"degree":312,...} sha256 5f70bf18...
//     degree 2394 evidence none
//     ...
#pragma once

#include "prover/three_views/degree.h"

#include <compare>
#include <filesystem>
#include <istream>
#include <string>

namespace plprove {

/// What a run looked for.
struct Attempt {
    int target = 0; ///< as in DegreeOptions
    bool fibre = false;

    friend auto operator<=>(const Attempt&, const Attempt&) = default;
};

/// What is known of a class or problem from runs with one seed. `run` is the one that found most;
/// its certificate is empty: `record` is its text, which shows run.degree solutions.
struct SweepResult {
    std::uint64_t seed = 0;
    std::vector<Attempt> attempts; ///< all of them, ascending
    DegreeRun run;
    double seconds = 0; ///< that `run` took
    bool fibre = false; ///< whether the record is a fibre
    std::string record; ///< empty if no solution was found
};

SweepResult sweep_result(DegreeRun run, const DegreeOptions& options, double seconds);

/// What is known from both: no certificate is ever lost.
SweepResult merged(SweepResult old, SweepResult recent);

/// Whether the options were tried. A run that stopped short will do so again.
bool attempted(const SweepResult& result, const DegreeOptions& options);

/// Whether the result is what the options want: all solutions, or the number that the target asks
/// for.
bool fulfils(const SweepResult& result, const DegreeOptions& options);

/// A file of certificates: of problems of a family, or of classes.
std::string file_of(bool family, std::string_view records);

/// One JSON object, in one line without its end; ASCII.
std::string run_line(const SweepResult& result);

/// The file.
std::string write(const SweepResult& result);

/// Reads such a file back, `record` only if `whole`. Nothing where there is none or it is damaged:
/// where the first lines are not what write() writes, or, if `whole`, the record has another
/// digest.
std::optional<SweepResult> read_sweep_result(const std::filesystem::path& path, bool whole);

/// The same from the bytes of such a file.
std::optional<SweepResult> parse_sweep_result(std::istream& file, bool whole);

} // namespace plprove
