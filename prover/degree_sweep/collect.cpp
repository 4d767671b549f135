#include "prover/degree_sweep/collect.h"

#include "prover/catalogue/degrees.h"
#include "prover/degree_sweep/write.h"
#include "prover/system/atomic_file.h"

#include <algorithm>
#include <tuple>

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
    if (selection.checked) return selection.checked->accepts(result);
    return selection.below == 0 || (result.complete() && result.degree() < selection.below) ||
           selection.also.contains(result.run.number);
}

/// The degree as computed, and why to believe that it is no lower bound only.
DegreeRecord computed_record(const ClassResult& result) {
    if (!result.complete())
        return {result.run.number, result.degree(), DegreeBound::at_least, DegreeStatus::evidence,
                "plprove degrees"};
    const CompletenessEvidence& evidence = *result.run.evidence;
    return {result.run.number, result.degree(), DegreeBound::exact, DegreeStatus::evidence,
            std::to_string(evidence.edges) + " edges; " +
                (evidence.trace_exponent ? "trace 1e" + std::to_string(*evidence.trace_exponent)
                                         : "no trace test")};
}

/// What plcheck certified of the class, if it did: that its degree is exact, or a lower bound.
std::optional<DegreeRecord> certified_record(const ClassResult& result, const Checked& checked) {
    const std::size_t number = result.run.number;
    if (const std::optional<int> degree = checked.exact(result))
        return DegreeRecord{number, *degree, DegreeBound::exact, DegreeStatus::certified,
                            "plcheck: lower and upper bound"};
    if (!checked.accepts(result)) return std::nullopt;
    return DegreeRecord{number, result.shown, DegreeBound::at_least, DegreeStatus::certified,
                        "plcheck: lower bound"};
}

/// The comments at the head of certs/degrees.csv, without their marks.
std::string remark_on_file() {
    std::string remark;
    for (std::string_view line : degree_lines()) {
        if (!line.starts_with('#')) break;
        line.remove_prefix(line.starts_with("# ") ? 2 : 1);
        remark.append(line) += '\n';
    }
    return remark;
}

void add_claims(std::vector<DegreeRecord>& records) {
    for (DegreeRecord& record : parse_degrees(degree_lines()))
        if (record.status == DegreeStatus::claimed) records.push_back(std::move(record));
}

/// By class, certified before evidence before claimed.
auto order(const DegreeRecord& record) {
    return std::tuple(record.number, -static_cast<int>(record.status));
}

} // namespace

Collected collect(const SweepFolder& folder, const Selection& selection, std::size_t file_size) {
    Collected collected;
    Parts parts(folder.path(), file_size);
    std::vector<DegreeRecord> records;
    std::string runs;
    for (const std::size_t number : folder.numbers()) {
        const std::optional<ClassResult> result = folder.read(number, true);
        if (!result) {
            collected.damaged.push_back(number);
            continue;
        }
        runs += run_line(*result) + '\n';
        if (result->degree() == 0) continue;
        ++collected.classes;
        collected.exact += result->complete();
        std::optional<DegreeRecord> certified;
        if (selection.checked) certified = certified_record(*result, *selection.checked);
        // A lower bound that is certified need not be said twice.
        if (!certified || result->complete() || certified->degree < result->degree())
            records.push_back(computed_record(*result));
        if (certified) records.push_back(std::move(*certified));
        if (!selects(selection, *result)) continue;
        ++collected.certificates;
        collected.solutions += static_cast<std::uint64_t>(result->shown);
        parts.add(result->record);
    }
    add_claims(records);
    std::ranges::sort(records, {}, order);
    collected.files = parts.finish();
    write_atomically(folder.path() / "degrees.csv", write_degrees(records, remark_on_file()));
    write_atomically(folder.path() / "runs.jsonl", runs);
    return collected;
}

} // namespace plprove
