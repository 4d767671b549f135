#include "prover/cli/degree_report.h"

#include "prover/cli/sections.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

/// What the degree is of: the problem, or its cameras alone.
const char* degree_name(const Decision& decision) {
    return decision.verdict == Verdict::minimal ? "degree" : "camera-degree";
}

void write_degree(std::ostream& out, const DegreeReport& report) {
    const DegreeRun& run = report.run;
    section(out, degree_name(report.decision)) << report.options.degree << ", by theorem\n";
    section(out, "found") << run.degree << (run.complete ? " solutions: all" : " solutions")
                          << '\n';
    section(out, "certificate");
    if (report.certified() > 0)
        out << "of at least " << report.certified()
            << " solutions: certified once plcheck accepts it\n";
    else
        out << "none\n";
}

} // namespace

std::string text_report(const DegreeReport& report) {
    const DegreeRun& run = report.run;
    std::ostringstream out;
    section(out, "problem") << notation(report.decision.problem) << '\n';
    section(out, "number") << '#' << report.decision.classes->label
                           << " of the label classes, computed for constraint class #" << run.number
                           << '\n';
    write_degree(out, report);
    section(out, "tracks") << run.tracks << " paths, " << run.retried << " retried, " << run.failed
                           << " failed\n";
    section(out, "time") << std::fixed << std::setprecision(2) << report.seconds << " s\n";
    for (const std::string& note : run.notes)
        section(out, "note") << note << '\n';
    return out.str();
}

std::string json_report(const DegreeReport& report) {
    const DegreeRun& run = report.run;
    Json json = {
        {"problem", notation(report.decision.problem)},
        {"number", report.decision.classes->label},
        {"notation", notation(problem_of(label_classes()[report.decision.classes->label]))},
        {"constraint_class", run.number},
        {"minimal", report.decision.verdict == Verdict::minimal},
        {"degree", report.options.degree},
        {"found", run.degree},
        {"certificate", report.certified()},
        {"complete", run.complete},
        {"tracks", run.tracks},
        {"retried", run.retried},
        {"failed", run.failed},
        {"seconds", report.seconds},
        {"notes", run.notes},
        {"target", report.options.target},
        {"at_least", report.options.at_least},
        {"seed", report.options.seed}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plprove
