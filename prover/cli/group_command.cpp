#include "prover/cli/group_command.h"

#include "prover/catalogue/groups.h"
#include "prover/cli/arguments.h"
#include "prover/cli/group_model.h"
#include "prover/cli/group_report.h"
#include "prover/cli/group_table.h"
#include "prover/cli/problem_report.h"
#include "prover/cli/sections.h"
#include "prover/fibres/group.h"
#include "prover/format/certificate_text.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/many_views/loop_group.h"
#include "prover/problem/five_points.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/in_parts.h"
#include "prover/system/progress.h"
#include "prover/three_views/degree_text.h"
#include "prover/three_views/loop_group.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace plprove {

namespace {

constexpr const char* group_examples =
    "Move the images around a loop: the solutions come back in another order. These\n"
    "permutations are the monodromy group. If it contains all even ones, the problem does not\n"
    "decompose into smaller ones; if it keeps blocks of solutions together, it does. plprove\n"
    "follows the solutions around loops, numerically: what it says is evidence. Of most problems\n"
    "in three calibrated views plcheck certifies the group without any file, by a theorem.\n\n"
    "With -o it looks for a certificate, too: it computes all solutions modulo a prime, for\n"
    "random images (a fibre). The factors of their polynomial are as long as the cycles of a\n"
    "permutation in the group. By them plcheck certifies that the group contains all even\n"
    "permutations, or all that keep some blocks of solutions together (docs/groups.md). One fibre\n"
    "certifies that there are so many solutions.\n\n"
    "Examples:\n"
    "  plprove group Chicago                        takes a second\n"
    "  plprove group 2394 -o chicago.plc            with a certificate, ten seconds\n"
    "  plprove group '3*P/P/P + a/a/a' --json       for machines\n"
    "  plprove group five-point                     two views\n"
    "  plprove group 'projective: 7*P/P' -o file.plc\n"
    "                                               lists of two more papers, certificates, too\n"
    "  plprove group models/five_points.model       a problem that is given by equations; -o FILE\n"
    "                                               certifies the number of solutions, too\n"
    "  plprove group --up-to 300 -o groups.csv      a table of all problems of at most 300\n"
    "                                               solutions; goes on where it was killed\n"
    "  plprove group --families --up-to 100 -o families.csv\n"
    "                                               ... of problems in general\n"
    "  plcheck --expect '2*Pa/Pa/Pa + P/P/P' --group S312 certs/classification.plc chicago.plc\n";

struct GroupRequest {
    std::string spec;
    int up_to = 0;         ///< not 0: in place of a problem, all of at most so many solutions
    bool families = false; ///< those of families in place of classes
    std::string path;
    GroupOptions options;
    bool json = false;
};

struct Asked {
    std::string problem; ///< in notation
    int degree = 0;
    std::string status;                     ///< of the degree: `certified` or `evidence`
    std::optional<ClassNumbers> classes;    ///< in three calibrated views
    std::optional<Problem> in_general = {}; ///< in others
};

/// What came of it.
struct Found {
    std::optional<LoopGroup> by_loops;
    std::optional<GroupSearch> by_fibres; ///< if a certificate was asked for
};

/// Throws BadInput where the degree is not on file.
Asked asked_in_general(const Problem& problem) {
    const std::string name = notation(problem);
    const auto known = many_views::degree_on_file(name);
    if (!known || known->bound != "exact")
        throw BadInput("how many solutions " + name +
                       " has is not on file: give a problem of certs/family-degrees.csv");
    return {name, known->degree, std::string(known->status), {}, problem};
}

/// Throws BadInput where the problem is not minimal, or its degree is not on file.
Asked asked(const std::string& spec) {
    if (const std::optional<Problem> problem = parse_general_spec(spec))
        return asked_in_general(*problem);
    const Decision decision = decide(parse_spec(spec));
    const std::optional<int> degree = degree_of(decision);
    if (!degree)
        throw BadInput(notation(decision.problem) + " is not minimal: give a problem that is");
    if (!decision.classes) return asked_in_general(parse_problem(five_point_problem));
    return {notation(decision.problem), *degree, "certified", decision.classes};
}

void write_loops(std::ostream& out, const std::optional<LoopGroup>& found) {
    section(out, "group");
    if (!found) {
        out << "not known: too many paths were lost; try another --seed\n";
        return;
    }
    out << in_words(found->group) << ": evidence, by " << found->loops << " loops\n";
    write_steps(out, found->group);
}

/// Whether the solutions fall into blocks that loops keep together.
bool decomposes(const std::optional<LoopGroup>& by_loops) {
    return by_loops && by_loops->group.steps.size() > 1;
}

/// Whether fibres may certify the group. They do not say which solutions are together in a block,
/// but for essential matrices of classes.
bool may_be_shown(const Asked& asked, const std::optional<LoopGroup>& by_loops) {
    return !decomposes(by_loops) ||
           (asked.classes && may_be_shown_with_blocks(by_loops->group.name()));
}

/// Why fibres certify no group.
std::string why_no_group(const Asked& asked, const Found& found) {
    if (found.by_fibres->records.empty()) return "none was found; try another --seed";
    if (found.by_fibres->degree == 1) return "there is one solution";
    if (!may_be_shown(asked, found.by_loops))
        return "it does not contain all even permutations, by evidence";
    return "more may, see --fibres";
}

void write_fibres(std::ostream& out, const Asked& asked, const Found& found) {
    section(out, "fibres");
    if (found.by_fibres->group.empty())
        out << "certify no group: " << why_no_group(asked, found) << '\n';
    else
        out << found.by_fibres->group << ": certified once plcheck accepts it\n";
    write_cycles(out, found.by_fibres->cycle_types);
}

/// The group that plcheck certifies, if it does.
std::optional<GroupOnFile> certified_group(const Asked& asked) {
    const auto known = asked.classes ? group_on_file(asked.classes->constraint)
                                     : family_group_on_file(asked.problem);
    return known && known->status == "certified" ? known : std::nullopt;
}

std::string text_report(const Asked& asked, const Found& found) {
    std::ostringstream out;
    section(out, "problem") << asked.problem << '\n';
    section(out, "degree") << asked.degree << ' ' << asked.status << '\n';
    write_loops(out, found.by_loops);
    if (const auto known = certified_group(asked))
        section(out, "certified") << "by plcheck --group '" << known->name << "'\n";
    if (found.by_fibres) write_fibres(out, asked, found);
    return out.str();
}

std::string json_report(const Asked& asked, const Found& found) {
    nlohmann::ordered_json json = {
        {"problem", asked.problem}, {"degree", asked.degree}, {"degree_status", asked.status}};
    if (asked.classes) {
        json["number"] = asked.classes->label;
        json["constraint_class"] = asked.classes->constraint;
    }
    if (found.by_loops)
        json["evidence"] = evidence_json(found.by_loops->group, found.by_loops->loops);
    if (const auto known = certified_group(asked)) json["certified_group"] = known->name;
    if (found.by_fibres)
        json["fibres"] = {{"group", found.by_fibres->group},
                          {"cycle_types", found.by_fibres->cycle_types}};
    return json.dump(2) + "\n";
}

std::optional<LoopGroup> search_by_loops(const Asked& problem, std::uint64_t seed) {
    ProgressLine line("following loops", 0);
    const LoopProgress progress = [&](int loops) { line.show(static_cast<std::size_t>(loops)); };
    if (problem.classes)
        return group_of_loops(problem.classes->constraint, problem.degree, seed, progress);
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    return many_views::group_of_loops(*problem.in_general, problem.degree, seed,
                                      static_cast<int>(threads), progress);
}

GroupSearch search_by_fibres(const Asked& problem, GroupOptions options) {
    ProgressLine line("computing fibres", 0);
    options.progress = [&](int fibres, long bits) {
        line.show(static_cast<std::size_t>(fibres),
                  " so far, the next one to " + std::to_string(bits) + " bits");
    };
    if (problem.classes) return find_group(problem.classes->constraint, problem.degree, options);
    return find_group(*problem.in_general, problem.degree, options);
}

/// The file of these records.
std::string certificate_of(const Asked& problem, const std::string& records) {
    if (problem.classes) return degree_file(records);
    return certificate_file("solutions", records, "give a problem with fewer solutions");
}

int find_group_of(const GroupRequest& request, const Deliver& deliver) {
    if (request.spec.ends_with(".model"))
        return find_group_of_model({request.spec, request.path, request.options.seed,
                                    request.options.fibres, request.json},
                                   deliver);
    const Asked problem = asked(request.spec);
    Found found{search_by_loops(problem, request.options.seed), {}};
    if (!request.path.empty()) {
        GroupOptions options = request.options;
        if (!may_be_shown(problem, found.by_loops))
            options.fibres = 1; // for the number of solutions
        found.by_fibres = search_by_fibres(problem, options);
        if (!found.by_fibres->records.empty())
            deliver(request.path, certificate_of(problem, found.by_fibres->records));
    }
    if (request.path != "-")
        deliver("-", request.json ? json_report(problem, found) : text_report(problem, found));
    const bool has_certificate = found.by_fibres && !found.by_fibres->records.empty();
    const bool certified =
        has_certificate && (!found.by_fibres->group.empty() || problem.degree == 1);
    return certified || (!found.by_fibres && found.by_loops) ? 0 : exit_failure;
}

/// A row that a table may have.
struct TableRow {
    std::string key;
    int degree = 0;
    std::function<std::optional<LoopGroup>()> find;
};

std::vector<TableRow> rows_of_classes(std::uint64_t seed) {
    std::vector<TableRow> rows;
    for (const auto& [number, degree] : degrees_on_file())
        rows.push_back(
            {std::to_string(number), degree, [=] { return group_of_loops(number, degree, seed); }});
    return rows;
}

std::vector<TableRow> rows_of_families(std::uint64_t seed) {
    std::vector<TableRow> rows;
    for (const std::string_view line : many_views::family_degree_lines()) {
        const many_views::DegreeOnFile known = many_views::parse_family_degree(line);
        const Problem problem = parse_problem(known.problem);
        const bool is_label_class = problem.views == 3 && local_features(problem);
        if (known.bound != "exact" || is_label_class) continue;
        rows.push_back({'"' + std::string(known.problem) + '"', known.degree, [=] {
                            return many_views::group_of_loops(problem, known.degree, seed, 1);
                        }});
    }
    return rows;
}

/// Adds rows to a table, by a thread a core, those of few solutions first. The file is written
/// every few seconds.
int make_table(const GroupRequest& request, const Deliver& deliver) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::seconds between_writes(2);
    std::vector<TableRow> missing = request.families ? rows_of_families(request.options.seed)
                                                     : rows_of_classes(request.options.seed);
    std::vector<std::string> keys;
    for (const TableRow& row : missing)
        keys.push_back(row.key);
    GroupTable table(request.path, request.families ? head_of_families : head_of_classes, keys);
    std::erase_if(missing, [&](const TableRow& row) {
        return row.degree > request.up_to || table.has(row.key);
    });
    std::ranges::stable_sort(missing, {}, &TableRow::degree);
    ProgressLine line("groups", missing.size());
    std::mutex mutex; // guards what follows, and the table
    std::size_t next = 0;
    std::size_t done = 0;
    std::size_t lost = 0;
    Clock::time_point written = Clock::now();
    const auto take = [&] {
        const std::lock_guard lock(mutex);
        return next < missing.size() ? &missing[next++] : nullptr;
    };
    const auto keep = [&](const std::string& key, const std::optional<LoopGroup>& found) {
        const std::lock_guard lock(mutex);
        if (found)
            table.add(key, found->group);
        else
            ++lost;
        line.show(++done);
        if (Clock::now() - written < between_writes) return;
        deliver(request.path, table.text());
        written = Clock::now();
    };
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    in_parts(std::min<std::size_t>(threads, missing.size()), threads,
             [&](std::size_t, std::size_t) {
                 while (const TableRow* row = take())
                     keep(row->key, row->find());
             });
    deliver(request.path, table.text());
    line.wipe();
    if (lost == 0) return 0;
    std::cerr << "the groups of " << lost
              << " problems are not known, as too many paths were lost: try another --seed\n";
    return exit_failure;
}

int run_group(const GroupRequest& request, const Deliver& deliver) {
    if (request.up_to == 0 && request.spec.empty())
        throw BadInput("no problem is given: name one, or give --up-to and -o");
    if (request.up_to == 0 && request.families)
        throw BadInput("--families makes a table: give --up-to and -o, too");
    if (request.up_to == 0) return find_group_of(request, deliver);
    if (!request.spec.empty()) throw BadInput("--up-to takes no problem: leave one of them out");
    if (request.path.empty() || request.path == "-")
        throw BadInput("--up-to adds to a file: name it by -o");
    return make_table(request, deliver);
}

} // namespace

Command add_group_command(CLI::App& program, Deliver deliver) {
    const auto request = std::make_shared<GroupRequest>();
    CLI::App* command = program.add_subcommand(
        "group", "Find how the solutions of a minimal problem are permuted, with a certificate");
    command->add_option("PROBLEM", request->spec,
                        "as for `plprove problem`; in general, one of certs/family-degrees.csv; or "
                        "the file of a model, whose name ends with .model");
    command
        ->add_option("--up-to", request->up_to,
                     "in place of a problem: all with at most so many solutions, into a table")
        ->check(CLI::Range(1, largest_target));
    command->add_flag("--families", request->families,
                      "... of certs/family-degrees.csv, but those in three calibrated views");
    command
        ->add_option("--fibres", request->options.fibres,
                     "give up after so many sets of images (default: 30)")
        ->check(CLI::Range(1, 10'000));
    add_seed(*command, request->options.seed);
    command->add_flag("--json", request->json, "print JSON");
    command->add_option("-o,--output", request->path,
                        "also look for a certificate, and write it to this file (- for standard "
                        "output, alone)");
    command->footer(group_examples);
    return {command,
            [request, deliver = std::move(deliver)] { return run_group(*request, deliver); }};
}

} // namespace plprove
