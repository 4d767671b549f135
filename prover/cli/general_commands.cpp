#include "prover/cli/general_commands.h"

#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <vector>

namespace plprove {

namespace {

/// A problem, and where it stands: `mine.txt, line 5`.
struct ListedProblem {
    std::string place;
    Problem problem;
};

std::vector<ListedProblem> problems_of(std::istream& in, const std::string& name) {
    std::vector<ListedProblem> problems;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::string place = name + ", line " + std::to_string(number);
        try {
            const std::optional<Problem> named = parse_general_spec(line);
            problems.push_back({place, named ? *named : parse_problem(line)});
        } catch (const NotationError& error) {
            throw BadInput(place + ": " + error.what());
        }
    }
    if (problems.empty()) throw BadInput(name + " has no problem: write one a line");
    return problems;
}

CertifiedList certify_all(const std::vector<ListedProblem>& problems) {
    ProgressLine progress("certifying problems", problems.size());
    CertifiedList list;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const auto& [place, problem] = problems[i];
        const auto found = try_to_certify(problem);
        if (const auto* certificate = std::get_if<ProblemRecord>(&found))
            list.certificates.push_back(*certificate);
        else
            list.open.push_back(place + ": " + notation(problem) +
                                " is conjectured not minimal, and not certified: " +
                                explanation(std::get<Undecided>(found)));
        progress.show(i + 1);
    }
    return list;
}

} // namespace

std::vector<ProblemRecord> certify_family(const CameraModel& family) {
    const std::vector<Problem> problems = family_problems(family);
    ProgressLine progress("certifying problems", problems.size());
    std::vector<ProblemRecord> certificates;
    for (const Problem& problem : problems) {
        certificates.push_back(certify(problem));
        progress.show(certificates.size());
    }
    return certificates;
}

CertifiedList certify_listed(const std::string& path) {
    if (path == "-") return certify_all(problems_of(std::cin, "standard input"));
    std::ifstream file(path);
    if (!file) throw BadInput("cannot read " + path + ": name a file with one problem a line");
    return certify_all(problems_of(file, path));
}

CLI::Option* add_family_option(CLI::App& app, std::string& family, const std::string& help) {
    std::vector<std::string> names;
    std::string list;
    for (const CameraModel* cameras : camera_models()) {
        names.emplace_back(family_name(*cameras));
        list += (list.empty() ? " (" : ", ") + names.back();
    }
    // In the help the list has blanks, so that lines can break.
    return app.add_option("--family", family, help + list + ')')
        ->type_name("NAME")
        ->check(CLI::IsMember(names).description(""));
}

} // namespace plprove
