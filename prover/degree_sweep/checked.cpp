#include "prover/degree_sweep/checked.h"

#include "prover/system/sha256.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace plprove {

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw std::runtime_error("cannot read " + path.string());
    return content;
}

/// How files of a kind are read, and what plcheck says of them.
struct FileKind {
    std::string name;
    std::string mark; ///< begins the first line of a record, before its name
    char end_of_name;
};

const std::array<FileKind, 2> file_kinds{
    {{"degrees", "\ndegree ", ' '}, {"solutions", "\nproblem ", '\n'}}};

/// The records of a file, by the number of a class or by the problem.
std::map<std::string, std::string> records_of(const std::string& file, const FileKind& kind) {
    std::map<std::string, std::string> records;
    for (std::size_t start = file.find(kind.mark); start != std::string::npos;) {
        const std::size_t next = file.find(kind.mark, start + 1);
        const std::size_t end = next == std::string::npos ? file.size() : next + 1;
        const std::size_t name = start + kind.mark.size();
        const std::size_t end_of_name = file.find(kind.end_of_name, name);
        records[file.substr(name, end_of_name - name)] = file.substr(start + 1, end - start - 1);
        start = next;
    }
    return records;
}

using Json = nlohmann::json;

/// Throws std::runtime_error if the file at `path` is not the one that this item of the report is
/// about.
void require_checked(const std::string& content, const Json& item, const fs::path& path,
                     const fs::path& report) {
    if (sha256(content) != item.at("sha256").get<std::string>())
        throw std::runtime_error(path.string() + " is not the file that " + report.string() +
                                 " is about: run plcheck --json again");
}

/// Adds the records in a file of the folder that plcheck accepted.
void add_accepted(const Json& item, const fs::path& folder, const fs::path& report,
                  std::map<std::string, AcceptedRecord>& accepted) {
    const auto kind =
        std::ranges::find(file_kinds, item.at("kind").get<std::string>(), &FileKind::name);
    if (kind == file_kinds.end() || item.at(kind->name).empty()) return;
    const fs::path path = folder / fs::path(item.at("file").get<std::string>()).filename();
    const std::string content = read(path);
    require_checked(content, item, path, report);
    const std::map<std::string, std::string> records = records_of(content, *kind);
    for (const Json& degree : item.at(kind->name)) {
        const std::string name = degree.contains("class")
                                     ? std::to_string(degree.at("class").get<std::size_t>())
                                     : degree.at("problem").get<std::string>();
        accepted[name] = {sha256(records.at(name)), degree.at("certified_at_least").get<int>()};
    }
}

/// The status of plcheck: 0 if it refused nothing, 1 if something. Throws std::runtime_error if it
/// could not read all.
int status_of(const Json& json, const fs::path& report) {
    const int status = json.at("status").get<int>();
    if (status == 0 || status == 1) return status;
    throw std::runtime_error(report.string() + " has status " + std::to_string(status) +
                             ": plcheck could not read or parse some file. Mend that, and run "
                             "plcheck --json again");
}

} // namespace

Checked::Checked(const fs::path& report, const fs::path& folder) {
    const std::string text = read(report);
    try {
        const Json json = Json::parse(text);
        refused_something_ = status_of(json, report) != 0;
        for (const Json& item : json.at("files"))
            add_accepted(item, folder, report, accepted_);
    } catch (const Json::exception&) {
        throw std::runtime_error(report.string() +
                                 " is no report of plcheck --json on a sweep: write one with "
                                 "plcheck --json");
    } catch (const std::out_of_range&) {
        throw std::runtime_error(report.string() +
                                 " speaks of records that its file lacks: run plcheck --json "
                                 "again");
    }
}

int Checked::certified(const SweepResult& result) const {
    const DegreeRun& run = result.run;
    const auto found =
        accepted_.find(run.problem.empty() ? std::to_string(run.number) : run.problem);
    const bool this_one = found != accepted_.end() && found->second.digest == sha256(result.record);
    return this_one ? found->second.solutions : 0;
}

} // namespace plprove
