#include "prover/cli/two_view_report.h"

#include "prover/cli/sections.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

PoseCount poses_of(const DegreeReport& report) {
    return report.run.five_point_poses.value_or(PoseCount{});
}

/// How many third cameras each relative pose has; 0 if the numbers do not divide.
int third_cameras(const DegreeReport& report) {
    const int poses = poses_of(report).poses;
    if (poses == 0 || report.run.degree % poses != 0) return 0;
    return report.run.degree / poses;
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
    section(out, "") << "`plcheck certs/classification.plc certs/bounds.plc FILE` certifies "
                        "exactly so many, and\n";
    section(out, "") << third_cameras(report) << " third cameras for each relative pose. So there "
                     << "are exactly " << poses_of(report).poses << " relative poses.\n";
}

} // namespace

std::string two_view_report(const DegreeReport& report) {
    const PoseCount poses = poses_of(report);
    const bool complete = report.run.complete();
    std::ostringstream out;
    section(out, "problem") << notation(report.decision.problem) << '\n';
    section(out, "reduced") << notation(report.decision.reduction.reduced) << '\n';
    section(out, "degree") << (complete ? "" : "at least ") << poses.poses << " relative poses, of "
                           << poses.essential_matrices << " essential matrices, as computed\n";
    section(out, "with") << "a third camera: " << extension(report) << ", has "
                         << (complete ? "" : "at least ") << report.run.degree << " solutions\n";
    write_certificate(out, report);
    section(out, "complete") << (complete ? "by evidence, until plcheck has certified it"
                                          : "not known")
                             << '\n';
    section(out, "time") << std::fixed << std::setprecision(2) << report.seconds << " s\n";
    for (const std::string& note : report.run.notes)
        section(out, "note") << note << '\n';
    return out.str();
}

std::string json_two_view_report(const DegreeReport& report) {
    const PoseCount poses = poses_of(report);
    const Json json = {{"problem", notation(report.decision.problem)},
                       {"reduced", notation(report.decision.reduction.reduced)},
                       {"minimal", report.decision.verdict == Verdict::minimal},
                       {"degree", poses.poses},
                       {"essential_matrices", poses.essential_matrices},
                       {"complete", report.run.complete()},
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
