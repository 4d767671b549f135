// A table of groups, one class or problem a line: `2394,"S312","312!",312,"evidence"`
// (certs/groups.csv, certs/family-groups.csv).
#pragma once

#include "prover/groups/monodromy_group.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plprove {

/// What a table begins with, comments and the names of its columns: a table of constraint classes,
/// by their numbers; and of problems of families, in notation.
extern const std::string_view head_of_classes;
extern const std::string_view head_of_families;

class GroupTable {
public:
    /// The rows of a file; none if it is not there. The keys are the first cells that rows may
    /// have, in order. Throws BadInput where a line is no row.
    GroupTable(const std::filesystem::path& path, std::string_view head,
               std::vector<std::string> keys);

    bool has(const std::string& key) const { return rows_.contains(key); }
    /// Adds a group that is known by evidence.
    void add(const std::string& key, const MonodromyGroup& group);
    /// The file.
    std::string text() const;

private:
    std::string_view head_;
    std::vector<std::string> keys_;
    std::map<std::string, std::string> rows_; ///< whole lines, by key
};

} // namespace plprove
