#include "prover/catalogue/commands.h"

#include "prover/catalogue/export.h"
#include "prover/catalogue/filter.h"
#include "prover/catalogue/spelling.h"

#include <map>
#include <system_error>

namespace plprove {

namespace {

struct ListRequest {
    Filter filter;
    std::string format = "number";
};

struct ExportRequest {
    std::optional<std::string> database, csv, json;
};

struct Flag {
    const char* name;
    bool Filter::*member;
    const char* help;
};

struct RangeOption {
    const char* name;
    std::optional<Range> Filter::*member;
    const char* help;
};

struct ViewsOption {
    const char* name;
    std::optional<Views> Filter::*member;
    const char* help;
};

constexpr Flag flags[] = {
    {"--minimal", &Filter::minimal, "minimal"},
    {"--not-minimal", &Filter::not_minimal, "not minimal"},
    {"--terminal", &Filter::terminal,
     "stands for a terminal problem: minimal, first of its swap class"},
    {"--pl0p", &Filter::pl0p, "free points and free lines only"},
    {"--one-pin", &Filter::one_pin, "at most one pin per point"},
    {"--complete-visibility", &Filter::complete_visibility, "every view sees everything"},
    {"--five-point", &Filter::five_point, "minimal extension of the five-point problem"},
    {"--registration", &Filter::registration, "... that is a camera registration problem"},
    {"--trifocal", &Filter::trifocal, "minimal, linear in the trifocal tensor (66 are terminal)"},
};

constexpr RangeOption ranges[] = {
    {"--points", &Filter::points, "number of points"},
    {"--lines", &Filter::lines, "number of lines, pins and free lines together"},
    {"--pins", &Filter::pins, "number of lines through a point"},
    {"--free-lines", &Filter::free_lines, "number of lines through no point"},
    {"--most-pins", &Filter::most_pins, "largest number of pins of a point"},
    {"--complete-views", &Filter::complete_views, "number of views that see everything"},
    {"--rank", &Filter::rank, "generic rank, 11 where minimal"},
    {"--degree", &Filter::degree, "degree on file, whatever its status"},
};

constexpr ViewsOption view_options[] = {
    {"--points-in-views", &Filter::points_in_views, "points that the views see, in any order"},
    {"--lines-in-views", &Filter::lines_in_views, "lines that the views see, in any order"},
};

const std::map<std::string, ObstructionFilter> obstructions{
    {"none", ObstructionFilter::none},
    {"epipolar", ObstructionFilter::epipolar},
    {"star", ObstructionFilter::star},
    {"any", ObstructionFilter::any}};

const std::map<std::string, DegreeStatus> statuses{{"certified", DegreeStatus::certified},
                                                   {"evidence", DegreeStatus::evidence},
                                                   {"claimed", DegreeStatus::claimed}};

constexpr const char* list_examples =
    "A class is listed if all filters hold; N may also be a range, 2..5, 2.. or ..5.\n\n"
    "Examples:\n"
    "  plprove list --minimal | wc -l               how many classes are minimal\n"
    "  plprove list --terminal --one-pin --points ..4\n"
    "                                               at most one pin per point, four points\n"
    "  plprove list --pl0p --minimal --format notation\n"
    "                                               points and lines only, spelled out\n"
    "  plprove list --points-in-views 5,5,3         one view sees 3 points, the others 5\n"
    "  plprove list --obstruction epipolar --rank ..7\n"
    "                                               not minimal, and by far\n"
    "  plprove list --five-point --format csv       with all columns (certs/CATALOGUE.md)\n";

constexpr const char* export_examples =
    "Examples:\n"
    "  plprove export catalogue.db                  an SQLite database of all 143,494 classes\n"
    "  plprove export --csv all.csv --json all.json the same as text\n"
    "  plprove export --csv - | head -3             to standard output\n"
    "  sqlite3 catalogue.db 'SELECT * FROM counts'  ask it (certs/CATALOGUE.md)\n";

/// Adds an option whose text `parse` turns into a value, or into nothing where it is malformed.
template <class Value, class Parse>
void add_parsed(CLI::App& command, const char* name, std::optional<Value>& value, Parse parse,
                const std::string& shape, const char* help) {
    command
        .add_option_function<std::string>(
            name,
            [&value, parse, name, shape](const std::string& text) {
                value = parse(text);
                if (!value)
                    throw CLI::ValidationError(name,
                                               "expected " + shape + ", found '" + text + "'");
            },
            help)
        ->type_name(shape);
}

/// Adds an option that takes one of the names in `values`.
template <class Value>
void add_choice(CLI::App& command, const char* name, std::optional<Value>& value,
                const std::map<std::string, Value>& values, const std::string& shape,
                const char* help) {
    add_parsed(
        command, name, value,
        [&values](const std::string& text) {
            const auto found = values.find(text);
            return found == values.end() ? std::nullopt : std::optional(found->second);
        },
        shape, help);
}

void add_filters(CLI::App& command, Filter& filter) {
    for (const Flag& flag : flags)
        command.add_flag(flag.name, filter.*flag.member, flag.help);
    command.get_option("--not-minimal")->excludes("--minimal")->excludes("--terminal");
    for (const RangeOption& range : ranges)
        add_parsed(command, range.name, filter.*range.member, parse_range, "N or N..M", range.help);
    for (const ViewsOption& views : view_options)
        add_parsed(command, views.name, filter.*views.member, parse_views, "A,B,C", views.help);
    add_choice(command, "--obstruction", filter.obstruction, obstructions, "none|epipolar|star|any",
               "why it is not minimal: points shared by two views, or a star");
    add_choice(command, "--degree-status", filter.degree_status, statuses,
               "certified|evidence|claimed", "status of the degree on file");
}

std::string list(const ListRequest& request) {
    std::vector<Entry> chosen = catalogue(parse_degrees(degree_lines()));
    std::erase_if(chosen, [&](const Entry& entry) { return !matches(request.filter, entry); });
    if (request.format == "csv") return to_csv(chosen);
    std::string text;
    for (const Entry& entry : chosen)
        text += (request.format == "notation" ? notation(entry.signature)
                                              : std::to_string(entry.number)) +
                '\n';
    return text;
}

void export_files(const ExportRequest& request, const Deliver& deliver) {
    if (!request.database && !request.csv && !request.json) return;
    const std::vector<DegreeRecord> degrees = parse_degrees(degree_lines());
    const std::vector<Entry> entries = catalogue(degrees);
    if (request.database) deliver(*request.database, to_sqlite(entries, degrees));
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
        program.add_subcommand("list", "List the label classes that satisfy some filters");
    add_filters(*command, request->filter);
    command
        ->add_option("--format", request->format,
                     "the authors' numbers, the problems in notation, or a table")
        ->check(CLI::IsMember({"number", "notation", "csv"}))
        ->capture_default_str();
    command->footer(list_examples);
    return {command, [request, deliver = std::move(deliver)] {
                return quiet_on_closed_pipe([&] { deliver("-", list(*request)); });
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
