#include "prover/cli/catalogue_commands.h"

#include "prover/catalogue/export.h"
#include "prover/catalogue/spelling.h"
#include "prover/cli/filter_options.h"
#include "prover/cli/general_commands.h"
#include "prover/cli/general_report.h"
#include "prover/system/exit.h"

#include <algorithm>
#include <system_error>

namespace plprove {

namespace {

struct ListRequest {
    Filter filter;
    std::string format = "number";
    std::string family;
    bool count = false;
};

struct ExportRequest {
    std::optional<std::string> database, csv, json;
};

constexpr const char* list_examples =
    "plprove lists the classes that pass all filters. N may be a range: 2..5, 2.. or ..5.\n\n"
    "Examples:\n"
    "  plprove list --minimal --count               how many classes are minimal\n"
    "  plprove list --terminal --one-pin --points ..4\n"
    "                                               at most one pin per point, four points\n"
    "  plprove list --pl0p --minimal --format notation\n"
    "                                               points and lines only, spelled out\n"
    "  plprove list --points-in-views 5,5,3         one view sees 3 points, the others 5\n"
    "  plprove list --minimal --contains '2*Pa/Pa/Pa + -/P/P'\n"
    "                                               what completes these three features\n"
    "  plprove list --terminal --contained-in '5*P/P/P + 5*a/a/a + 5*P/P/a'\n"
    "                                               problems of such features only\n"
    "  plprove list --obstruction epipolar --rank ..7\n"
    "                                               far from minimal\n"
    "  plprove list --five-point --format csv       with all columns (certs/CATALOGUE.md)\n"
    "  plprove list --family projective --minimal --format csv\n"
    "                                               problems for projective cameras\n";

constexpr const char* export_examples =
    "Examples:\n"
    "  plprove export catalogue.db                  an SQLite database of all 143,494 classes\n"
    "  plprove export --csv all.csv --json all.json the same as text\n"
    "  plprove export --csv - | head -3             to standard output\n"
    "  sqlite3 catalogue.db 'SELECT * FROM counts'  ask it (certs/CATALOGUE.md)\n"
    "  plprove export --macaulay2 Chicago           another program finds that it is minimal\n";

std::string list(const ListRequest& request) {
    std::vector<Entry> chosen = catalogue();
    std::erase_if(chosen, [&](const Entry& entry) { return !matches(request.filter, entry); });
    if (request.count) return std::to_string(chosen.size()) + '\n';
    if (request.format == "csv") return to_csv(chosen);
    if (request.format == "json") return to_json(chosen);
    std::string text;
    for (const Entry& entry : chosen)
        text += (request.format == "notation" ? notation(entry.signature)
                                              : std::to_string(entry.number)) +
                '\n';
    return text;
}

/// The problems of a family that pass --minimal and --not-minimal.
std::string list_family(const ListRequest& request) {
    if (request.format == "json")
        throw BadInput("a family is not written as JSON: write --format csv");
    std::vector<ProblemRecord> chosen = certify_family(*family_named(request.family));
    std::erase_if(chosen, [&](const ProblemRecord& certificate) {
        const bool minimal = is_minimal(certificate);
        return (request.filter.minimal && !minimal) || (request.filter.not_minimal && minimal);
    });
    return request.count ? std::to_string(chosen.size()) + '\n' : list_of(chosen, request.format);
}

/// Throws BadInput if an option is given that says nothing of a family.
void refuse_other_filters(const CLI::App& command) {
    const std::vector<std::string> allowed{"--family", "--minimal", "--not-minimal", "--count",
                                           "--format"};
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && std::ranges::find(allowed, option->get_name()) == allowed.end())
            throw BadInput(option->get_name() + " is no filter of a family: leave it out");
}

void export_files(const ExportRequest& request, const Deliver& deliver) {
    if (!request.database && !request.csv && !request.json) return;
    const std::vector<Entry> entries = catalogue();
    if (request.database) deliver(*request.database, to_sqlite(entries));
    if (request.csv) deliver(*request.csv, to_csv(entries));
    if (request.json) deliver(*request.json, to_json(entries));
}

/// Runs `action`. A reader that has seen enough (`| head`) is no failure to report, but not all was
/// written.
int quiet_on_closed_pipe(const std::function<void()>& action) {
    try {
        action();
        return 0;
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::broken_pipe) throw;
        return 1;
    }
}

} // namespace

Command add_list_command(CLI::App& program, Deliver deliver) {
    const auto request = std::make_shared<ListRequest>();
    CLI::App* command =
        program.add_subcommand("list", "List the label classes that pass some filters");
    add_filters(*command, request->filter);
    command
        ->add_option("--format", request->format,
                     "the authors' numbers, the problems in notation, or all columns "
                     "(certs/CATALOGUE.md)")
        ->check(CLI::IsMember({"number", "notation", "csv", "json"}))
        ->capture_default_str();
    command->add_flag("--count", request->count, "print only how many classes there are")
        ->excludes("--format");
    add_family_option(*command, request->family,
                      "instead of label classes: all balanced problems of a paper with complete "
                      "visibility, with calibrated (plmp) or projective cameras");
    command->footer(list_examples);
    return {command, [request, command, deliver = std::move(deliver)] {
                if (!request->family.empty()) refuse_other_filters(*command);
                return quiet_on_closed_pipe([&] {
                    deliver("-", request->family.empty() ? list(*request) : list_family(*request));
                });
            }};
}

Command add_export_command(CLI::App& program, Deliver deliver) {
    const auto request = std::make_shared<ExportRequest>();
    CLI::App* command =
        program.add_subcommand("export", "Write the catalogue of all label classes");
    command->add_option("DATABASE", request->database, "the SQLite database to write")
        ->type_name("FILE");
    command->add_option("--csv", request->csv, "the CSV file to write, - for standard output")
        ->type_name("FILE");
    command->add_option("--json", request->json, "the JSON file to write, - for standard output")
        ->type_name("FILE");
    command->require_option(1, 0);
    command->footer(export_examples);
    return {command, [request, deliver = std::move(deliver)] {
                return quiet_on_closed_pipe([&] { export_files(*request, deliver); });
            }};
}

} // namespace plprove
