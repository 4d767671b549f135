#include "prover/cli/group_table.h"

#include "prover/system/exit.h"

#include <charconv>
#include <fstream>
#include <sstream>

namespace plprove {

namespace {

constexpr const char* head =
    "# How loops of photos permute the solutions, by constraint class. S312: in all ways, 312! in "
    "number. `<S8 wr S2 wr S10`: in some of the ways that\n"
    "# keep blocks together, 10 of 2 of 8 solutions. width: how many solutions the hardest step "
    "has. certified: plcheck certifies it, by Theorem S\n"
    "# or P (proofs/all_permutations.md, proofs/five_shared_points.md) or by certs/groups/*.plc. "
    "evidence: loops that plprove followed numerically (docs/groups.md).\n"
    "number,group,order,width,status\n";

} // namespace

GroupTable::GroupTable(const std::filesystem::path& path) {
    std::ifstream file(path);
    int at = 0;
    for (std::string line; std::getline(file, line);) {
        ++at;
        if (line.starts_with('#') || line.starts_with("number,")) continue;
        std::size_t number = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (error != std::errc{} || *end != ',')
            throw BadInput(path.string() + ":" + std::to_string(at) +
                           ": not a row of a table of groups: give another file, or a new one");
        rows_[number] = line;
    }
}

void GroupTable::add(std::size_t number, const MonodromyGroup& group) {
    std::ostringstream row;
    row << number << ",\"" << group.name() << "\",\"" << group.order() << "\"," << group.width()
        << ",\"evidence\"";
    rows_[number] = row.str();
}

std::string GroupTable::text() const {
    std::string result = head;
    for (const auto& [number, row] : rows_)
        (result += row) += '\n';
    return result;
}

} // namespace plprove
