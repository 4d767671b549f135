#include "prover/cli/degrees_command.h"

#include "prover/cli/arguments.h"
#include "prover/cli/filter_options.h"
#include "prover/cli/general_commands.h"
#include "prover/degree_sweep/classes.h"
#include "prover/degree_sweep/collect.h"
#include "prover/degree_sweep/family_degree.h"
#include "prover/degree_sweep/sweep.h"
#include "prover/fibres/class_fibre.h"
#include "prover/problem/complete_visibility.h"
#include "prover/problem/notation.h"
#include "prover/system/exit.h"
#include "prover/system/interruption.h"
#include "prover/system/progress.h"
#include "prover/system/ranks.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <thread>

namespace plprove {

namespace {

constexpr const char* degrees_examples =
    "You may kill a sweep at any moment: the same command goes on where it was. Under mpirun, all "
    "ranks\nshare the work, and the folder. `plprove collect` writes its files again.\n\n"
    "A FILTER has the options of `plprove list`, with or without dashes, and numbers of classes. "
    "plprove computes\na system of equations (a constraint class) if one of its minimal classes "
    "passes one of the filters.\n\n"
    "Examples:\n"
    "  plprove degrees -o sweep                     all 10,073 systems, to 300 solutions\n"
    "  plprove degrees --exact -o sweep             ... then to the end, the small ones first\n"
    "  plprove degrees --fibres --classes 'degree ..300' -o fibres\n"
    "                                               ... as fibres (docs/groups.md)\n"
    "  plprove degrees --exact --classes pl0p -o pl0p\n"
    "                                               the problems with points and lines only\n"
    "  mpirun -n 64 plprove degrees --exact -o sweep\n"
    "                                               the same sweep on 64 cores\n"
    "  plprove degrees --classes 'one-pin points ..3' --classes 2394,6723 -o some\n"
    "  plprove degrees --family shared-focal --target 1000 -o sweep\n"
    "                                               problems of a family (docs/families.md)\n";

constexpr const char* collect_examples =
    "Examples:\n"
    "  plprove collect --below 300 --also pl0p -o sweep\n"
    "                                               write the files again, with fewer "
    "certificates\n"
    "  plcheck --json sweep/degrees*.plc >report\n"
    "                                               replay every certificate\n"
    "  plprove collect --checked report -o sweep    call certified what plcheck accepted\n"
    "  plprove collect --family focal -o sweep      the files of a family\n";

struct DegreesRequest {
    std::string folder;
    DegreeOptions options{300};
    bool exact = false;
    bool fibres = false;
    bool retry = false;
    unsigned threads = 0; ///< 0: what is useful
    std::vector<ClassFilter> classes;
    std::string family;
    bool uncounted = false;     ///< of the family, only problems whose degree is not on file
    std::optional<Range> views; ///< of the family, only problems in so many views
};

struct CollectRequest {
    std::string folder;
    std::string family;
    std::uint64_t seed = 0;
    int below = 0;
    std::vector<ClassFilter> also;
    std::string checked;
};

/// `2 h 5 min`, `3 min`, `12 s`.
std::string duration(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 100) return std::to_string(whole) + " s";
    const long minutes = (whole + 30) / 60;
    if (minutes < 100) return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

std::string rate_and_time_left(const SweepProgress& progress) {
    if (progress.done == 0) return "";
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << ", "
         << static_cast<double>(progress.done) / progress.seconds << " a second, "
         << duration(progress.seconds * (1 - progress.share) / progress.share) << " left";
    return text.str();
}

/// How many threads each rank has, if the user does not say. A rank is meant for one core, since
/// mpirun starts a rank for each core that it may use.
unsigned useful_threads(const Ranks& ranks) {
    return ranks.count > 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
}

/// Computes what is missing; ends the process if a signal asks for that. Rank 0 speaks, of its own
/// share.
void run_sweep(const SweepFolder& folder, const SweepPlan& plan, const Ranks& ranks,
               const ComputeDegree& compute) {
    const Interruption interruption;
    const std::string of_rank = ranks.count > 1 ? " of rank 0" : "";
    std::optional<ProgressLine> line;
    if (ranks.leads()) line.emplace("computing degrees" + of_rank, plan.numbers.size());
    SweepProgress last;
    SweepWatch watch;
    watch.progress = [&](const SweepProgress& progress) {
        last = progress;
        if (line) line->show(progress.done, rate_and_time_left(progress));
    };
    watch.pause = [&] {
        const int signal = interruption.pending();
        if (signal == 0) return;
        if (line) {
            line->wipe();
            std::cerr << "plprove: interrupted: " << last.done << " of " << last.total << ' '
                      << folder.subject().several() << of_rank
                      << " are on file; the same command goes on from there" << std::endl;
        }
        Interruption::end_by(signal);
    };
    sweep(folder, plan, compute, watch);
}

/// ` #4 #6`, and ` ...` for the rest of a long list. Problems have a line each.
std::string names_of(const std::vector<std::size_t>& numbers, const SweepSubject& subject) {
    constexpr std::size_t named_at_most = 10;
    std::string names;
    for (std::size_t i = 0; i < std::min(numbers.size(), named_at_most); ++i)
        names += subject.family.empty() ? " #" + std::to_string(numbers[i])
                                        : "\n  " + subject.at(numbers[i]).problem;
    return names + (numbers.size() > named_at_most ? " ..." : "");
}

/// `1 class`, `2 classes`.
std::string count_of(std::size_t count, const SweepSubject& subject) {
    return std::to_string(count) + ' ' + (count == 1 ? subject.one() : subject.several());
}

/// Says which items have not the result that was asked for. Returns whether all have.
bool all_fulfilled(const SweepFolder& folder, const std::vector<std::size_t>& numbers,
                   const DegreeOptions& options) {
    const SweepSubject& subject = folder.subject();
    std::vector<std::size_t> others;
    for (const std::size_t number : numbers) {
        const std::optional<SweepResult> result = folder.read(number, false);
        if (!result || !fulfils(*result, options)) others.push_back(number);
    }
    if (others.empty()) return true;
    std::cerr << "plprove: " << count_of(others.size(), subject)
              << " fell short:" << names_of(others, subject) << "\n  "
              << (folder.path() / runs_file(subject)).string()
              << " says why; --retry computes them again\n";
    return false;
}

/// Says which files could not be used. Returns whether all could.
bool none_damaged(const std::vector<std::size_t>& damaged, const SweepSubject& subject) {
    if (damaged.empty()) return true;
    std::cerr << "plprove: " << damaged.size()
              << (damaged.size() == 1 ? " file is damaged and was" : " files are damaged and were")
              << " left out:" << names_of(damaged, subject) << "\n  a sweep with --retry computes "
              << (damaged.size() == 1 ? "its " + subject.one() : "their " + subject.several())
              << " again\n";
    return false;
}

/// Writes the files of a collection and says what they have. Returns whether nothing was left out
/// because a file is damaged.
bool write_collection(const SweepFolder& folder, const Selection& selection) {
    const Collected collected = collect(folder, selection);
    const SweepSubject& subject = folder.subject();
    std::cout << "degrees       " << (folder.path() / collected.table).string() << ": "
              << collected.items << ' ' << subject.several() << ", " << collected.exact
              << (subject.family.empty() ? " with all solutions, "
                                         : " with all solutions, by evidence, ")
              << collected.items - collected.exact << " lower bounds only\n"
              << "certificates  ";
    for (const std::string& file : collected.files)
        std::cout << (folder.path() / file).string()
                  << (file == collected.files.back() ? ": " : " ");
    std::cout << collected.certificates << ' ' << subject.several() << ", " << collected.solutions
              << " solutions, "
              << (selection.checked ? "all accepted by plcheck"
                                    : "certified once plcheck accepts them")
              << std::endl;
    if (!std::cout)
        throw std::runtime_error(
            "cannot write to standard output: is it closed, or the disk full?");
    return none_damaged(collected.damaged, subject);
}

/// What the options ask of each item.
DegreeOptions options_of(const DegreesRequest& request) {
    DegreeOptions options = request.options;
    if (request.exact || request.fibres) options.target = 0;
    options.fibre = request.fibres;
    return options;
}

SweepSubject subject_of(const std::string& family) {
    return family.empty() ? all_constraint_classes() : minimal_problems_of(*family_named(family));
}

int collect_results(const CollectRequest& request) {
    const SweepFolder folder(request.folder, subject_of(request.family), request.seed);
    if (folder.numbers().empty())
        throw BadInput("there are no results in " + request.folder +
                       ": run a sweep there first, or name another folder, --family or --seed");
    Selection selection;
    selection.below = request.below;
    if (!request.checked.empty()) selection.checked.emplace(request.checked, folder.path());
    if (!request.also.empty()) {
        const std::vector<std::size_t> also = constraint_classes_of(request.also);
        selection.also = {also.begin(), also.end()};
    }
    const bool whole = write_collection(folder, selection);
    if (selection.checked && selection.checked->refused_something())
        std::cerr << "plprove: plcheck refused something in " << request.checked << ": its "
                  << folder.subject().one() << " has nothing certified in the table\n";
    return whole ? 0 : exit_failure;
}

/// The numbers of what there is to compute.
std::vector<std::size_t> wanted(const DegreesRequest& request, const SweepSubject& subject) {
    if (!request.classes.empty()) return constraint_classes_of(request.classes);
    std::vector<std::size_t> numbers;
    for (const SweepItem& item : subject.items) {
        const bool is_counted = request.uncounted && item.degree > 0;
        const bool has_views =
            !request.views || request.views->contains(parse_problem(item.problem).views);
        if (!is_counted && has_views) numbers.push_back(item.number);
    }
    if (numbers.empty())
        throw BadInput("no problem of " + request.family + " is left: all have " +
                       (request.uncounted ? "a degree on file; leave --uncounted out"
                                          : "other numbers of views; change --views"));
    return numbers;
}

/// The engine for what the options ask. `subject` must outlive it.
ComputeDegree engine_for(const DegreesRequest& request, const SweepSubject& subject,
                         const ComputeDegree& of_classes) {
    if (request.fibres) return compute_class_fibre;
    if (request.family.empty()) return of_classes;
    return [&subject](std::size_t number, const DegreeOptions& options) {
        return compute_family_degree(subject.at(number), options);
    };
}

/// Rank 0 has made the folder.
void require_shared(const std::string& folder) {
    if (!std::filesystem::is_directory(folder))
        throw std::runtime_error("not every rank sees " + folder +
                                 ": name a folder that all machines share");
}

int find_degrees(const DegreesRequest& request, const ComputeDegree& compute) {
    const Ranks ranks = join_ranks();
    const DegreeOptions options = options_of(request);
    const SweepFolder folder(request.folder, subject_of(request.family), options.seed);
    const SweepSubject& subject = folder.subject();
    // What the user has to mend rank 0 finds first, while the others wait.
    std::vector<std::size_t> numbers;
    std::optional<FolderLock> lock;
    if (ranks.leads()) {
        numbers = wanted(request, subject);
        lock.emplace(request.folder);
    }
    ranks.sum(0);
    require_shared(request.folder);
    if (!ranks.leads()) numbers = wanted(request, subject);
    SweepPlan plan = plan_sweep(folder,
                                share_of(subject, numbers, static_cast<std::size_t>(ranks.number),
                                         static_cast<std::size_t>(ranks.count)),
                                options, request.retry);
    plan.threads = request.threads > 0 ? request.threads : useful_threads(ranks);
    const auto begin = std::chrono::steady_clock::now();
    if (!plan.numbers.empty())
        run_sweep(folder, plan, ranks, engine_for(request, subject, compute));
    const std::size_t computed = ranks.sum(plan.numbers.size());
    if (!ranks.leads()) return 0;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    std::cout << "computed      " << count_of(computed, subject) << " in "
              << duration(elapsed.count()) << "; " << numbers.size() - computed
              << " were on file\n";
    const bool whole = write_collection(folder, {});
    const bool fulfilled = all_fulfilled(folder, numbers, options);
    return whole && fulfilled ? 0 : exit_failure;
}

CLI::Option* add_class_filters(CLI::App& command, const char* name,
                               std::vector<ClassFilter>& filters, const char* help) {
    return command
        .add_option_function<std::vector<std::string>>(
            name,
            [&filters, name](const std::vector<std::string>& texts) {
                try {
                    for (const std::string& text : texts)
                        filters.push_back(parse_class_filter(text));
                } catch (const std::invalid_argument& error) {
                    throw CLI::ValidationError(name, error.what());
                }
            },
            help)
        ->type_name("FILTER")
        ->allow_extra_args(false);
}

} // namespace

Command add_degrees_command(CLI::App& program, ComputeDegree compute) {
    const auto request = std::make_shared<DegreesRequest>();
    CLI::App* command = program.add_subcommand(
        "degrees",
        "Compute the degrees of many problems: a sweep, which you may kill and start again");
    command->add_option("-o,--output", request->folder, "the folder of the sweep")
        ->type_name("DIR")
        ->required();
    command
        ->add_option("--target", request->options.target,
                     "stop at this number of solutions of each")
        ->check(CLI::Range(1, largest_target))
        ->capture_default_str();
    command->add_flag("--exact", request->exact, "find all solutions")->excludes("--target");
    command
        ->add_flag("--fibres", request->fibres,
                   "... and certify them without floating point, all at once, modulo a prime")
        ->excludes("--target");
    add_class_filters(*command, "--classes", request->classes,
                      "compute only these classes (default: all)");
    command
        ->add_option("--threads", request->threads,
                     "how many to compute at a time (default: one a core; under mpirun, "
                     "one a rank)")
        ->check(CLI::Range(1, 1024));
    add_seed(*command, request->options.seed);
    command->add_flag("--retry", request->retry,
                      "compute those again that fell short before, or whose file is damaged");
    CLI::Option* const family =
        add_family_option(*command, request->family,
                          "the minimal problems of a family, in place of classes")
            ->excludes("--classes")
            ->excludes("--fibres");
    command
        ->add_flag("--uncounted", request->uncounted,
                   "of the family, only those whose number of solutions is not on file")
        ->needs(family);
    add_range_option(*command, "--views", request->views,
                     "of the family, only those in so many views")
        ->needs(family);
    command->footer(degrees_examples);
    return {command,
            [request, compute = std::move(compute)] { return find_degrees(*request, compute); }};
}

Command add_collect_command(CLI::App& program) {
    const auto request = std::make_shared<CollectRequest>();
    CLI::App* command = program.add_subcommand(
        "collect", "Write the table and the certificates of a sweep, of what its folder has");
    command->add_option("-o,--output", request->folder, "the folder of the sweep")
        ->type_name("DIR")
        ->required();
    add_seed(*command, request->seed);
    command
        ->add_option("--below", request->below,
                     "write only certificates of all solutions where they are fewer than this "
                     "(default: every certificate)")
        ->check(CLI::Range(1, largest_target));
    add_class_filters(*command, "--also", request->also, "... and those of these classes")
        ->needs("--below");
    command
        ->add_option(
            "--checked", request->checked,
            "what `plcheck --json` printed of degrees.plc: keep what plcheck accepted, and "
            "call that certified in degrees.csv")
        ->type_name("REPORT")
        ->excludes("--below");
    add_family_option(*command, request->family, "of the sweep over a family")->excludes("--also");
    command->footer(collect_examples);
    return {command, [request] { return collect_results(*request); }};
}

} // namespace plprove
