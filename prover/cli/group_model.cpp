#include "prover/cli/group_model.h"

#include "prover/cli/group_report.h"
#include "prover/cli/model_source.h"
#include "prover/cli/sections.h"
#include "prover/model/group.h"
#include "prover/model/solver/loop_group.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/system/words.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

namespace plprove {

namespace {

using model::GroupSearch;
using model::ModelGroup;
using model::ModelSize;

struct Found {
    std::string name;
    ModelSize size;
    std::optional<ModelGroup> by_loops;
    bool asked_for_fibres = false;
    std::optional<GroupSearch> by_fibres;
    std::string no_fibres; ///< why none were computed; empty if they were

    bool certified() const { return by_fibres && !by_fibres->group.empty(); }
};

/// How many solutions there are, modulo q. Throws BadInput if that is not known.
ModelSize size_of(const model::Model& model, const model::Program& program) {
    if (program.data == 0)
        throw BadInput("the model has no data: a group is of the ways in which solutions move with "
                       "data; make numbers of the equations data");
    if (program.equations.size() != program.unknowns)
        throw BadInput(counted(program.equations.size(), "equation") + " for " +
                       counted(program.unknowns, "unknown") +
                       ": there are solutions to permute only if these are equally many");
    const model::FibreSearch search = model::find_fibre(model, program);
    if (!search.fibre)
        throw BadInput("all solutions for random data were not found: " + search.reason +
                       "; a group needs all of them: state a smaller problem");
    return {static_cast<int>(search.fibre->polynomial.degree()),
            static_cast<int>(search.fibre->count())};
}

std::optional<ModelGroup> search_by_loops(const model::Program& program, const ModelSize& size,
                                          std::uint64_t seed) {
    ProgressLine line("following loops", 0);
    line.show(0);
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    return model::group_of_loops(program, size, seed, threads,
                                 [&](int loops) { line.show(static_cast<std::size_t>(loops)); });
}

/// Why fibres would certify nothing, as far as loops show; empty if they may.
std::string why_smaller(const std::optional<ModelGroup>& by_loops) {
    if (!by_loops) return {};
    if (by_loops->parts.size() > 1) return "loops lead the solutions of each part to its own only";
    const MonodromyGroup& group = by_loops->parts.front();
    const bool is_alternating =
        group.steps.size() == 1 && group.steps.front().kind != GroupStep::Kind::other;
    return is_alternating ? "" : "the group does not contain all even permutations, by evidence";
}

void search_by_fibres(Found& found, const std::string& text, const ModelGroupRequest& request,
                      const Deliver& deliver) {
    found.no_fibres = why_smaller(found.by_loops);
    if (!found.no_fibres.empty()) return;
    const model::Study study = studied(text);
    found.no_fibres = model::why_no_group(study);
    if (!found.no_fibres.empty()) return;
    ProgressLine line("computing fibres", 0);
    found.by_fibres =
        model::find_group(study, request.fibres, [&](std::size_t fibres) { line.show(fibres); });
    line.wipe();
    if (found.certified()) deliver(request.path, model::write(study, found.by_fibres->fibres));
}

void write_loops(std::ostream& out, const std::optional<ModelGroup>& found) {
    section(out, "group");
    if (!found) {
        out << "not known: too many paths were lost; try another --seed\n";
        return;
    }
    const std::string evidence =
        ": evidence, by " + counted(static_cast<std::size_t>(found->loops), "loop");
    if (found->parts.size() == 1) {
        out << in_words(found->parts.front()) << evidence << '\n';
        write_steps(out, found->parts.front());
        return;
    }
    out << "not transitive: the solutions fall into " << found->parts.size()
        << " parts that no loop joins" << evidence << '\n';
    for (const MonodromyGroup& part : found->parts)
        section(out, "part") << counted(static_cast<std::size_t>(part.degree()), "solution") << ": "
                             << in_words(part) << '\n';
}

void write_fibres(std::ostream& out, const Found& found) {
    section(out, "fibres");
    if (!found.by_fibres) {
        out << "none, so there is no certificate: " << found.no_fibres << '\n';
        return;
    }
    if (found.certified())
        out << found.by_fibres->group << ": certified once plcheck accepts it\n";
    else
        out << "certify no group: more may, see --fibres\n";
    write_cycles(out, found.by_fibres->cycle_types);
}

std::string text_report(const Found& found) {
    std::ostringstream out;
    section(out, "model") << found.name << '\n';
    section(out, "solutions") << found.size.values << " modulo a prime";
    if (found.size.values != found.size.solutions)
        out << ", which count for " << found.size.solutions;
    out << '\n';
    write_loops(out, found.by_loops);
    if (found.asked_for_fibres) write_fibres(out, found);
    return out.str();
}

std::string json_report(const Found& found) {
    nlohmann::ordered_json json = {
        {"model", found.name}, {"solutions", found.size.values}, {"solutions_status", "evidence"}};
    if (found.by_loops && found.by_loops->parts.size() == 1) {
        json["evidence"] = evidence_json(found.by_loops->parts.front(), found.by_loops->loops);
    } else if (found.by_loops) {
        json["evidence"] = {{"loops", found.by_loops->loops}};
        for (const MonodromyGroup& part : found.by_loops->parts)
            json["evidence"]["parts"].push_back(
                {{"solutions", part.degree()}, {"group", part.name()}});
    }
    if (found.by_fibres)
        json["fibres"] = {{"group", found.by_fibres->group},
                          {"cycle_types", found.by_fibres->cycle_types}};
    if (!found.no_fibres.empty()) json["no_fibres"] = found.no_fibres;
    return json.dump(2) + '\n';
}

} // namespace

int find_group_of_model(const ModelGroupRequest& request, const Deliver& deliver) {
    const ModelSource source = read_model_source(request.file);
    Found found;
    in_model_file(request.file, [&] {
        const model::Model model = model::read_model(source.text);
        const model::Program program = model::compile(model);
        found.name = model.name;
        found.size = size_of(model, program);
        found.by_loops = search_by_loops(program, found.size, request.seed);
        found.asked_for_fibres = !request.path.empty();
        if (found.asked_for_fibres) search_by_fibres(found, source.text, request, deliver);
        return 0;
    });
    if (request.path != "-") deliver("-", request.json ? json_report(found) : text_report(found));
    return found.certified() || (!found.asked_for_fibres && found.by_loops) ? 0 : exit_failure;
}

} // namespace plprove
