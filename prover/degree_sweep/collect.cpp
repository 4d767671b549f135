#include "prover/degree_sweep/collect.h"

#include "prover/catalogue/degrees.h"
#include "prover/system/atomic_file.h"
#include "prover/three_views/degree_text.h"

namespace plprove {

namespace {

namespace fs = std::filesystem;

/// Records of certificates, gathered into files of limited size.
class Parts {
public:
    Parts(const fs::path& folder, std::size_t file_size) : folder_(folder), file_size_(file_size) {}

    void add(const std::string& record) {
        if (!records_.empty() && head_size() + records_.size() + record.size() > file_size_)
            write();
        records_ += record;
    }

    /// Writes what is left, if only an empty file, and removes what an earlier collection left.
    std::vector<std::string> finish() {
        if (written_.empty() || !records_.empty()) write();
        for (std::size_t part = written_.size() + 1; fs::remove(folder_ / name(part)); ++part) {
        }
        return written_;
    }

private:
    static std::size_t head_size() { return degree_file("").size(); }

    static std::string name(std::size_t part) {
        return part == 1 ? "degrees.plc" : "degrees-" + std::to_string(part) + ".plc";
    }

    void write() {
        written_.push_back(name(written_.size() + 1));
        write_atomically(folder_ / written_.back(), degree_file(records_));
        records_.clear();
    }

    fs::path folder_;
    std::size_t file_size_;
    std::string records_;
    std::vector<std::string> written_;
};

bool selects(const Selection& selection, const ClassResult& result) {
    if (result.record.empty()) return false;
    if (selection.checked) return selection.checked->certified(result) > 0;
    return selection.below == 0 || (result.run.complete && result.run.degree < selection.below) ||
           selection.also.contains(result.run.number);
}

constexpr const char* csv_head =
    "# What a sweep found, one class a line.\n"
    "# number     the class, the first of its constraint class\n"
    "# degree     its degree, which is certified (certs/degrees.csv)\n"
    "# found      how many solutions were found\n"
    "# certified  how many of them plcheck certified from the certificate in this folder; 0 if it\n"
    "#            has not been asked, or refused the certificate\n"
    "number,degree,found,certified\n";

std::string csv_line(const ClassResult& result, int certified) {
    const std::size_t number = result.run.number;
    return std::to_string(number) + ',' + std::to_string(degree_on_file(number).value()) + ',' +
           std::to_string(result.run.degree) + ',' + std::to_string(certified) + '\n';
}

} // namespace

Collected collect(const SweepFolder& folder, const Selection& selection, std::size_t file_size) {
    Collected collected;
    Parts parts(folder.path(), file_size);
    std::string csv = csv_head;
    std::string runs;
    for (const std::size_t number : folder.numbers()) {
        const std::optional<ClassResult> result = folder.read(number, true);
        if (!result) {
            collected.damaged.push_back(number);
            continue;
        }
        runs += run_line(*result) + '\n';
        if (result->run.degree == 0) continue;
        ++collected.classes;
        collected.exact += result->run.complete;
        csv += csv_line(*result, selection.checked ? selection.checked->certified(*result) : 0);
        if (!selects(selection, *result)) continue;
        ++collected.certificates;
        collected.solutions += static_cast<std::uint64_t>(result->run.degree);
        parts.add(result->record);
    }
    collected.files = parts.finish();
    write_atomically(folder.path() / "degrees.csv", csv);
    write_atomically(folder.path() / "runs.jsonl", runs);
    return collected;
}

} // namespace plprove
