#include "prover/cli/two_view_report.h"

#include "prover/cli/sections.h"
#include "prover/problem/five_points.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

/// How many third cameras each relative pose has; 0 if the numbers do not divide.
int third_cameras(const DegreeReport& report) {
    const int found = report.run.degree;
    return found % poses_of_five_points == 0 ? found / poses_of_five_points : 0;
}

std::string extension(const DegreeReport& report) {
    return '#' + std::to_string(report.run.number) + ", " +
           notation(problem_of(label_classes()[report.run.number]));
}

void write_certificate(std::ostream& out, const DegreeReport& report) {
    section(out, "certificate");
    if (report.certified() == 0) {
        out << "none\n";
        return;
    }
    out << "of at least " << report.certified() << " solutions of #" << report.run.number << '\n';
    section(out, "") << "`plcheck certs/classification.plc certs/models/registrations/*.plc FILE` "
                        "certifies just this, and\n";
    section(out, "") << third_cameras(report) << " third cameras for each relative pose. So there "
                     << "are exactly " << poses_of_five_points << " relative poses.\n";
}

} // namespace

std::string two_view_report(const DegreeReport& report) {
    std::ostringstream out;
    section(out, "problem") << notation(report.decision.problem) << '\n';
    section(out, "reduced") << notation(report.decision.reduction.reduced) << '\n';
    section(out, "degree") << poses_of_five_points << " relative poses, by theorem\n";
    section(out, "with") << "a third camera: " << extension(report) << ", " << report.run.degree
                         << " solutions found\n";
    write_certificate(out, report);
    section(out, "time") << std::fixed << std::setprecision(2) << report.seconds << " s\n";
    for (const std::string& note : report.run.notes)
        section(out, "note") << note << '\n';
    return out.str();
}

std::string json_two_view_report(const DegreeReport& report) {
    const Json json = {{"problem", notation(report.decision.problem)},
                       {"reduced", notation(report.decision.reduction.reduced)},
                       {"minimal", report.decision.verdict == Verdict::minimal},
                       {"degree", poses_of_five_points},
                       {"essential_matrices", poses_of_five_points / 2},
                       {"complete", report.run.complete},
                       {"extension", report.run.number},
                       {"extension_degree", report.run.degree},
                       {"third_cameras", third_cameras(report)},
                       {"certificate", report.certified()},
                       {"seconds", report.seconds},
                       {"notes", report.run.notes},
                       {"seed", report.options.seed}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plprove
