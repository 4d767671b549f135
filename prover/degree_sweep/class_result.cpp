#include "prover/degree_sweep/class_result.h"

#include "prover/degree_sweep/write.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view run_mark = "# run ";
constexpr std::size_t longest_run_line = 16000; // leaves room for the mark in a line of the format

Json json_of(const ClassResult& result) {
    const DegreeRun& run = result.run;
    Json json = {
        {"number", run.number},      {"degree", run.degree},      {"complete", run.complete()},
        {"edges", nullptr},          {"trace_exponent", nullptr}, {"certified", result.certified},
        {"tracks", run.tracks},      {"retried", run.retried},    {"failed", run.failed},
        {"seconds", result.seconds}, {"seed", result.seed},       {"attempts", Json::array()},
        {"notes", run.notes}};
    for (const Attempt& attempt : result.attempts)
        json["attempts"].push_back(
            {{"target", attempt.target}, {"certificate", attempt.certificate}});
    if (run.evidence) {
        json["edges"] = run.evidence->edges;
        if (run.evidence->trace_exponent) json["trace_exponent"] = *run.evidence->trace_exponent;
    }
    return json;
}

std::string ascii(const Json& json) {
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// Whether this is the first line of the file. Sweeps of version 1.0 wrote the same records under
/// the number of format 1: they remain valid, and are written again under the present one.
bool is_head(const std::string& line) {
    return line + '\n' == degree_file("") || line == "plcert 1 degrees";
}

/// Throws Json::exception.
ClassResult result_of(const Json& json) {
    ClassResult result;
    DegreeRun& run = result.run;
    json.at("number").get_to(run.number);
    json.at("degree").get_to(run.degree);
    if (json.at("complete").get<bool>()) run.evidence = {json.at("edges").get<int>(), std::nullopt};
    if (const Json& exponent = json.at("trace_exponent"); run.evidence && !exponent.is_null())
        run.evidence->trace_exponent = exponent.get<int>();
    json.at("certified").get_to(result.certified);
    json.at("tracks").get_to(run.tracks);
    json.at("retried").get_to(run.retried);
    json.at("failed").get_to(run.failed);
    json.at("seconds").get_to(result.seconds);
    json.at("seed").get_to(result.seed);
    for (const Json& attempt : json.at("attempts"))
        result.attempts.push_back(
            {attempt.at("target").get<int>(), attempt.at("certificate").get<bool>()});
    json.at("notes").get_to(run.notes);
    return result;
}

/// Whether the text is a record of this class with so many solutions.
bool is_whole(const ClassResult& result) {
    if (result.record.empty()) return result.certified == 0;
    std::istringstream lines(result.record);
    int solutions = 0;
    for (std::string line; std::getline(lines, line);)
        solutions += line.starts_with("real ") ? 1 : line.starts_with("pair ") ? 2 : 0;
    return solutions == result.certified && result.record.back() == '\n' &&
           result.record.starts_with("degree " + std::to_string(result.run.number) + ' ');
}

} // namespace

ClassResult class_result(DegreeRun run, const DegreeOptions& options, double seconds) {
    ClassResult result;
    result.seed = options.seed;
    result.attempts = {{options.target, options.certificate}};
    result.seconds = seconds;
    if (run.certificate && !run.certificate->solutions.empty()) {
        result.certified = run.certificate->degree();
        result.record = write_record(*run.certificate);
    }
    run.certificate.reset();
    result.run = std::move(run);
    return result;
}

ClassResult merged(ClassResult old, ClassResult recent) {
    if (std::pair(old.run.complete(), old.run.degree) >
        std::pair(recent.run.complete(), recent.run.degree)) {
        recent.run = std::move(old.run);
        recent.seconds = old.seconds;
    }
    if (old.certified > recent.certified) {
        recent.certified = old.certified;
        recent.record = std::move(old.record);
    }
    std::ranges::copy(old.attempts, std::back_inserter(recent.attempts));
    std::ranges::sort(recent.attempts);
    recent.attempts.erase(std::unique(recent.attempts.begin(), recent.attempts.end()),
                          recent.attempts.end()); // clang 14 knows no subranges
    return recent;
}

bool attempted(const ClassResult& result, const DegreeOptions& options) {
    return std::ranges::any_of(result.attempts, [&](const Attempt& attempt) {
        return attempt.target == options.target && attempt.certificate >= options.certificate;
    });
}

bool fulfils(const ClassResult& result, const DegreeOptions& options) {
    const bool enough = options.target > 0 && result.degree() >= options.target;
    if (!enough && !result.complete()) return false;
    return !options.certificate || result.certified >= (enough ? options.target : result.degree());
}

std::string run_line(const ClassResult& result) {
    Json json = json_of(result);
    std::string line = ascii(json);
    for (Json& notes = json["notes"]; line.size() > longest_run_line; line = ascii(json))
        notes.erase(notes.size() - 1);
    return line;
}

std::string write(const ClassResult& result) {
    std::string lines(run_mark);
    lines.append(run_line(result)) += '\n';
    return degree_file(lines + result.record);
}

std::optional<ClassResult> read_class_result(const std::filesystem::path& path, bool whole) {
    std::ifstream file(path, std::ios::binary);
    std::string head, line;
    if (!std::getline(file, head) || !is_head(head)) return std::nullopt;
    if (!std::getline(file, line) || !line.starts_with(run_mark)) return std::nullopt;
    try {
        ClassResult result = result_of(Json::parse(line.substr(run_mark.size())));
        if (!whole) return result;
        result.record.assign(std::istreambuf_iterator<char>(file), {});
        if (is_whole(result)) return result;
    } catch (const Json::exception&) {
        // as of a file that another program wrote, or a disk damaged
    }
    return std::nullopt;
}

} // namespace plprove
