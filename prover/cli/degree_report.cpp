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
    section(out, "degree") << (run.complete() ? "" : "at least ") << run.degree << ": the "
                           << degree_name(report.decision)
                           << (run.complete() ? "" : ", or a lower bound") << ", as computed\n";
    section(out, "certificate");
    if (report.certified() > 0)
        out << "of at least " << report.certified()
            << " solutions: certified once plcheck accepts it\n";
    else
        out << "none\n";
    section(out, "complete");
    if (run.evidence)
        out << "by evidence, not proved: " << run.evidence->edges
            << " edges permuted the solutions, "
            << (run.evidence->trace_exponent
                    ? "the trace test left 1e" + std::to_string(*run.evidence->trace_exponent)
                    : std::string("no trace test applies"))
            << '\n';
    else if (report.options.target > 0 && run.degree >= report.options.target)
        out << "not known: the run stopped at its target, " << report.options.target << '\n';
    else if (report.options.at_least > 0)
        out << "not known: the run was to find " << report.options.at_least << '\n';
    else
        out << "not known\n";
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
        {"degree", run.degree},
        {"certificate", report.certified()},
        {"complete", run.complete()},
        {"edges", nullptr},
        {"trace_exponent", nullptr},
        {"tracks", run.tracks},
        {"retried", run.retried},
        {"failed", run.failed},
        {"seconds", report.seconds},
        {"notes", run.notes},
        {"target", report.options.target},
        {"at_least", report.options.at_least},
        {"seed", report.options.seed}};
    if (run.evidence) {
        json["edges"] = run.evidence->edges;
        if (run.evidence->trace_exponent) json["trace_exponent"] = *run.evidence->trace_exponent;
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plprove
