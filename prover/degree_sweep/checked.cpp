#include "prover/degree_sweep/checked.h"

#include "prover/system/sha256.h"

#include <charconv>
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

/// The records of a file of degrees, by class.
std::map<std::size_t, std::string> records_of(const std::string& file) {
    constexpr std::string_view mark = "\ndegree ";
    std::map<std::size_t, std::string> records;
    for (std::size_t start = file.find(mark); start != std::string::npos;) {
        const std::size_t next = file.find(mark, start + 1);
        const std::size_t end = next == std::string::npos ? file.size() : next + 1;
        std::size_t number = 0;
        std::from_chars(file.data() + start + mark.size(), file.data() + end, number);
        records[number] = file.substr(start + 1, end - start - 1);
        start = next;
    }
    return records;
}

} // namespace

Checked::Checked(const fs::path& report, const fs::path& folder) {
    const std::string text = read(report);
    try {
        const nlohmann::json json = nlohmann::json::parse(text);
        for (const auto& file : json.at("files")) {
            if (file.at("kind") != "degrees" || file.at("degrees").empty()) continue;
            const fs::path path = folder / fs::path(file.at("file").get<std::string>()).filename();
            const std::string content = read(path);
            if (sha256(content) != file.at("sha256").get<std::string>())
                throw std::runtime_error(path.string() + " is not the file that " +
                                         report.string() + " is about: run plcheck --json again");
            const std::map<std::size_t, std::string> records = records_of(content);
            for (const auto& degree : file.at("degrees")) {
                const auto number = degree.at("class").get<std::size_t>();
                digests_[number] = sha256(records.at(number));
            }
        }
        const nlohmann::json none = nlohmann::json::array();
        for (const auto& [number, degree] :
             json.value("certified_exactly", none).get<std::vector<std::pair<std::size_t, int>>>())
            exact_[number] = degree;
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(report.string() +
                                 " is no report of plcheck --json on degrees: write one with "
                                 "plcheck --json");
    } catch (const std::out_of_range&) {
        throw std::runtime_error(report.string() +
                                 " speaks of classes that its file lacks: run plcheck --json "
                                 "again");
    }
}

std::optional<int> Checked::exact(std::size_t number) const {
    const auto found = exact_.find(number);
    return found == exact_.end() ? std::nullopt : std::optional(found->second);
}

bool Checked::accepts(const ClassResult& result) const {
    const auto found = digests_.find(result.run.number);
    return found != digests_.end() && found->second == sha256(result.record);
}

} // namespace plprove
