// A table of groups, one class a line: `2394,"S312","312!",312,"evidence"` (certs/groups.csv).
#pragma once

#include "prover/groups/monodromy_group.h"

#include <filesystem>
#include <map>
#include <string>

namespace plprove {

class GroupTable {
public:
    /// The rows of a file; none if it is not there. Throws BadInput where a line is no row.
    explicit GroupTable(const std::filesystem::path& path);

    bool has(std::size_t number) const { return rows_.contains(number); }
    /// Adds a class whose group is known by evidence.
    void add(std::size_t number, const MonodromyGroup& group);
    /// The file.
    std::string text() const;

private:
    std::map<std::size_t, std::string> rows_; ///< whole lines, by number
};

} // namespace plprove
