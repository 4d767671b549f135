#include "prover/degree_sweep/collect.h"

#include "prover/system/atomic_file.h"

namespace plprove {

namespace {

namespace fs = std::filesystem;

/// With what the names of the files begin.
std::string stem_of(const std::string& family) {
    return family.empty() ? "degrees" : family;
}

/// Records of certificates, gathered into files of limited size.
class Parts {
public:
    Parts(const SweepFolder& folder, std::size_t file_size)
        : folder_(folder.path()), family_(folder.subject().family), file_size_(file_size) {}

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
    std::string file(const std::string& records) const {
        return file_of(!family_.empty(), records);
    }

    std::size_t head_size() const { return file("").size(); }

    std::string name(std::size_t part) const {
        return stem_of(family_) + (part == 1 ? "" : "-" + std::to_string(part)) + ".plc";
    }

    void write() {
        written_.push_back(name(written_.size() + 1));
        write_atomically(folder_ / written_.back(), file(records_));
        records_.clear();
    }

    fs::path folder_;
    std::string family_;
    std::size_t file_size_;
    std::string records_;
    std::vector<std::string> written_;
};

bool selects(const Selection& selection, const SweepResult& result) {
    if (result.record.empty()) return false;
    if (selection.checked) return selection.checked->certified(result) > 0;
    return selection.below == 0 || (result.run.complete && result.run.degree < selection.below) ||
           selection.also.contains(result.run.number);
}

constexpr const char* head_for_classes =
    "# What a sweep found, one class a line.\n"
    "# number     the class, the first of its constraint class\n"
    "# degree     its degree, which is certified (certs/degrees.csv)\n"
    "# found      how many solutions were found\n"
    "# certified  how many of them plcheck certified from the certificate in this folder; 0 if it\n"
    "#            has not been asked, or refused the certificate\n"
    "number,degree,found,certified\n";

constexpr const char* head_for_family =
    "# What a sweep found, one problem a line, with the columns of certs/family-degrees.csv.\n"
    "# degree     how many solutions were found, each of which the certificate shows\n"
    "# bound      exact: two sets of images gave this number, and most ways agree. at-least: else\n"
    "# certified  how many of them plcheck certified from the certificate in this folder; empty if "
    "it\n"
    "#            has not been asked, or refused the certificate\n"
    "family,problem,degree,bound,status,certified,source\n";

std::string csv_line(const SweepSubject& subject, const SweepResult& result, int certified) {
    const DegreeRun& run = result.run;
    const std::string found = std::to_string(run.degree);
    if (subject.family.empty())
        return std::to_string(run.number) + ',' + std::to_string(subject.at(run.number).degree) +
               ',' + found + ',' + std::to_string(certified) + '\n';
    return subject.family + ',' + run.problem + ',' + found +
           (run.complete ? ",exact" : ",at-least") + ",evidence," +
           (certified > 0 ? std::to_string(certified) : "") + ',' +
           (run.notes.empty() ? "" : run.notes.front()) + '\n';
}

} // namespace

std::string runs_file(const SweepSubject& subject) {
    return (subject.family.empty() ? "" : subject.family + "-") + "runs.jsonl";
}

Collected collect(const SweepFolder& folder, const Selection& selection, std::size_t file_size) {
    const SweepSubject& subject = folder.subject();
    Collected collected;
    Parts parts(folder, file_size);
    std::string csv = subject.family.empty() ? head_for_classes : head_for_family;
    std::string runs;
    for (const std::size_t number : folder.numbers()) {
        const std::optional<SweepResult> result = folder.read(number, true);
        if (!result) {
            collected.damaged.push_back(number);
            continue;
        }
        runs += run_line(*result) + '\n';
        if (result->run.degree == 0) continue;
        ++collected.items;
        collected.exact += result->run.complete;
        csv += csv_line(subject, *result,
                        selection.checked ? selection.checked->certified(*result) : 0);
        if (!selects(selection, *result)) continue;
        ++collected.certificates;
        collected.solutions += static_cast<std::uint64_t>(result->run.degree);
        parts.add(result->record);
    }
    collected.files = parts.finish();
    collected.table = stem_of(subject.family) + ".csv";
    write_atomically(folder.path() / collected.table, csv);
    write_atomically(folder.path() / runs_file(subject), runs);
    return collected;
}

} // namespace plprove
