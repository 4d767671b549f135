#include "prover/degree_sweep/sweep_result.h"

#include "prover/format/certificate_text.h"
#include "prover/system/sha256.h"
#include "prover/three_views/degree_text.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view run_mark = "# run ";
constexpr std::string_view digest_mark = " sha256 ";
constexpr std::size_t longest_run_line = 16000; // leaves room for the mark in a line of the format

Json json_of(const SweepResult& result) {
    const DegreeRun& run = result.run;
    Json json = {{"number", run.number}};
    if (!run.problem.empty()) json["problem"] = run.problem;
    json.update(Json{{"degree", run.degree},
                     {"complete", run.complete},
                     {"tracks", run.tracks},
                     {"retried", run.retried},
                     {"failed", run.failed},
                     {"seconds", result.seconds},
                     {"seed", result.seed},
                     {"attempts", Json::array()},
                     {"record", sha256(result.record)},
                     {"notes", run.notes}});
    for (const auto& [target, fibre] : result.attempts) {
        Json& attempt = json["attempts"].emplace_back(Json{{"target", target}});
        if (fibre) attempt["fibre"] = true;
    }
    if (result.fibre) json["fibre"] = true;
    return json;
}

std::string ascii(const Json& json) {
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// The run line is not what run_line() writes; caught in this file, as Json::exception is.
class BadRunLine : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

constexpr std::int64_t largest_integer = std::numeric_limits<std::int64_t>::max();

std::int64_t integer(const Json& json, std::int64_t least, std::int64_t most) {
    const bool beyond = json.is_number_unsigned() && json.get<std::uint64_t>() > largest_integer;
    if (!json.is_number_integer() || beyond) throw BadRunLine("no integer, or too large");
    const auto value = json.get<std::int64_t>();
    if (value < least || value > most) throw BadRunLine("out of range");
    return value;
}

int count(const Json& json) {
    return static_cast<int>(integer(json, 0, std::numeric_limits<int>::max()));
}

std::uint64_t large_count(const Json& json) {
    return static_cast<std::uint64_t>(integer(json, 0, largest_integer));
}

/// The JSON text of the line, whose digest must agree.
std::string_view undamaged(std::string_view text) {
    const std::size_t end = text.rfind(digest_mark);
    if (end == text.npos) throw BadRunLine("no digest");
    const std::string_view json = text.substr(0, end);
    if (text.substr(end + digest_mark.size()) != sha256(std::string(json)))
        throw BadRunLine("another digest");
    return json;
}

/// Throws Json::exception or BadRunLine.
SweepResult result_of(const Json& json) {
    SweepResult result;
    DegreeRun& run = result.run;
    run.number = large_count(json.at("number"));
    run.problem = json.value("problem", "");
    run.degree = count(json.at("degree"));
    json.at("complete").get_to(run.complete);
    run.tracks = large_count(json.at("tracks"));
    run.retried = large_count(json.at("retried"));
    run.failed = large_count(json.at("failed"));
    json.at("seconds").get_to(result.seconds);
    if (!(result.seconds >= 0)) throw BadRunLine("a time below zero");
    if (!json.at("seed").is_number_unsigned()) throw BadRunLine("no seed");
    json.at("seed").get_to(result.seed);
    for (const Json& attempt : json.at("attempts"))
        result.attempts.push_back({count(attempt.at("target")), attempt.value("fibre", false)});
    result.fibre = json.value("fibre", false);
    json.at("notes").get_to(run.notes);
    return result;
}

} // namespace

SweepResult sweep_result(DegreeRun run, const DegreeOptions& options, double seconds) {
    SweepResult result;
    result.seed = options.seed;
    result.attempts = {{options.target, options.fibre}};
    result.seconds = seconds;
    if (run.certificate && !run.certificate->solutions.empty())
        result.record = write_record(*run.certificate);
    if (!run.record.empty()) result.record = std::move(run.record);
    result.fibre = options.fibre && !result.record.empty();
    run.certificate.reset();
    run.record.clear();
    result.run = std::move(run);
    return result;
}

SweepResult merged(SweepResult old, SweepResult recent) {
    std::set<Attempt> attempts(old.attempts.begin(), old.attempts.end());
    attempts.insert(recent.attempts.begin(), recent.attempts.end());
    SweepResult best = std::move(old.run.degree > recent.run.degree ? old : recent);
    best.attempts = {attempts.begin(), attempts.end()};
    return best;
}

bool attempted(const SweepResult& result, const DegreeOptions& options) {
    return std::ranges::count(result.attempts, Attempt{options.target, options.fibre}) > 0;
}

bool fulfils(const SweepResult& result, const DegreeOptions& options) {
    if (options.fibre) return result.fibre;
    return result.run.complete || (options.target > 0 && result.run.degree >= options.target);
}

std::string file_of(bool family, std::string_view records) {
    if (!family) return degree_file(records);
    return certificate_file("solutions", records, "ask for fewer solutions with --target");
}

std::string run_line(const SweepResult& result) {
    Json json = json_of(result);
    std::string line = ascii(json);
    for (Json& notes = json["notes"]; line.size() > longest_run_line; line = ascii(json))
        notes.erase(notes.size() - 1);
    return line;
}

std::string write(const SweepResult& result) {
    const std::string json = run_line(result);
    std::string lines(run_mark);
    lines.append(json).append(digest_mark).append(sha256(json)) += '\n';
    return file_of(!result.run.problem.empty(), lines + result.record);
}

std::optional<SweepResult> parse_sweep_result(std::istream& file, bool whole) {
    std::string head, line;
    if (!std::getline(file, head)) return std::nullopt;
    if (!std::getline(file, line) || !line.starts_with(run_mark)) return std::nullopt;
    try {
        const std::string_view text = std::string_view(line).substr(run_mark.size());
        const Json json = Json::parse(undamaged(text));
        SweepResult result = result_of(json);
        if (head + '\n' != file_of(!result.run.problem.empty(), "")) return std::nullopt;
        if (!whole) return result;
        result.record.assign(std::istreambuf_iterator<char>(file), {});
        if (sha256(result.record) == json.at("record").get<std::string>()) return result;
    } catch (const Json::exception&) {
    } catch (const BadRunLine&) {
        // as of a file that another program wrote, or a disk damaged
    }
    return std::nullopt;
}

std::optional<SweepResult> read_sweep_result(const std::filesystem::path& path, bool whole) {
    std::error_code ignored; // what cannot be looked at cannot be read
    if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt; // a pipe would hang
    std::ifstream file(path, std::ios::binary);
    return parse_sweep_result(file, whole);
}

} // namespace plprove
