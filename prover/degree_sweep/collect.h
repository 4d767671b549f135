// What a sweep found, as files to archive: a table, and the certificates in files of
// certs/FORMAT.md, section 9 for classes, section 14 for problems of a family. The bytes depend on
// the results alone.
#pragma once

#include "prover/degree_sweep/checked.h"
#include "prover/degree_sweep/folder.h"

#include <functional>
#include <set>

namespace plprove {

/// Which certificates go in: of complete items whose degree is below `below` (0: of every one), and
/// of these besides; or else those that plcheck accepted.
struct Selection {
    int below = 0;
    std::set<std::size_t> also;
    std::optional<Checked> checked;
};

struct Collected {
    std::size_t items = 0;            ///< with a degree or a lower bound
    std::size_t exact = 0;            ///< of these, with all solutions
    std::size_t certificates = 0;     ///< items whose certificate is in the files
    std::uint64_t solutions = 0;      ///< that the certificates show
    std::vector<std::size_t> damaged; ///< items whose files could not be used
    std::string table;                ///< the name of the file that has a line for each item
    std::vector<std::string> files;   ///< the names of those with certificates
};

/// The most bytes of a file of certificates.
inline constexpr std::size_t collected_file_size = 60U << 20U;

/// The name of the file that says how each run went.
std::string runs_file(const SweepSubject& subject);

/// Writes into the folder, each file whole or not at all:
/// - degrees.plc, then degrees-2.plc and so on: certificates, ascending, in parts of at most
///   `file_size` bytes (an item is never split). Parts of an earlier collection are removed;
/// - degrees.csv: for each class its degree, how many solutions were found, and how many of them
///   plcheck certified, ascending;
/// - runs.jsonl: how each run went, one JSON object a line.
/// Of a family: focal.plc, focal.csv with the columns of certs/family-degrees.csv, and
/// focal-runs.jsonl.
Collected collect(const SweepFolder& folder, const Selection& selection,
                  std::size_t file_size = collected_file_size);

} // namespace plprove
