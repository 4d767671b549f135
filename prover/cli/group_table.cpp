#include "prover/cli/group_table.h"

#include "prover/system/exit.h"

#include <fstream>
#include <set>
#include <sstream>

namespace plprove {

const std::string_view head_of_classes =
    "# How loops of photos permute the solutions, by constraint class. S312: in all ways, 312! in "
    "number. `<S8 wr S2 wr S10`: in some of the ways that\n"
    "# keep blocks together, 10 of 2 of 8 solutions. width: how many solutions the hardest step "
    "has. certified: plcheck certifies it, by Theorem S\n"
    "# or P (proofs/all_permutations.md, proofs/five_shared_points.md) or by fibres "
    "(certs/groups). "
    "evidence: loops that plprove followed numerically (docs/groups.md).\n"
    "number,group,order,width,status\n";

const std::string_view head_of_families =
    "# How loops of photos permute the solutions of problems in family-degrees.csv, as groups.csv "
    "says it of problems in three calibrated views. certified:\n"
    "# plcheck certifies it by fibres (certs/solutions), that of 5*P/P by theorem, or there is one "
    "solution for certain. evidence: loops that plprove\n"
    "# followed numerically (docs/groups.md).\n"
    "problem,group,order,width,status\n";

GroupTable::GroupTable(const std::filesystem::path& path, std::string_view head,
                       std::vector<std::string> keys)
    : head_(head), keys_(std::move(keys)) {
    const std::set<std::string> allowed(keys_.begin(), keys_.end());
    std::ifstream file(path);
    int at = 0;
    for (std::string line; std::getline(file, line);) {
        ++at;
        if (line.starts_with('#') || head_.ends_with("\n" + line + "\n")) continue;
        const std::string key = line.substr(0, line.find(','));
        if (key == line || !allowed.contains(key))
            throw BadInput(path.string() + ":" + std::to_string(at) +
                           ": not a row of a table of groups: give another file, or a new one");
        rows_[key] = line;
    }
}

void GroupTable::add(const std::string& key, const MonodromyGroup& group) {
    std::ostringstream row;
    row << key << ",\"" << group.name() << "\",\"" << group.order() << "\"," << group.width()
        << ",\"evidence\"";
    rows_[key] = row.str();
}

std::string GroupTable::text() const {
    std::string result(head_);
    for (const std::string& key : keys_)
        if (const auto row = rows_.find(key); row != rows_.end()) (result += row->second) += '\n';
    return result;
}

} // namespace plprove
