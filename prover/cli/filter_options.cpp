#include "prover/cli/filter_options.h"

#include "prover/problem/notation.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

namespace plprove {

namespace {

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
    {"--degree", &Filter::degree, "degree, of a minimal class"},
    {"--width", &Filter::width, "solutions of its hardest step, where its group is known"},
};

constexpr ViewsOption view_options[] = {
    {"--points-in-views", &Filter::points_in_views, "points that the views see, in any order"},
    {"--lines-in-views", &Filter::lines_in_views, "lines that the views see, in any order"},
};

struct PartOption {
    const char* name;
    std::optional<std::vector<Part>> Filter::*member;
    const char* help;
};

constexpr PartOption part_options[] = {
    {"--contains", &Filter::contains, "has these features, in some order of the views"},
    {"--contained-in", &Filter::contained_in, "has no other features, nor more of them"},
};

const std::map<std::string, ObstructionFilter> obstructions{
    {"none", ObstructionFilter::none},
    {"epipolar", ObstructionFilter::epipolar},
    {"star", ObstructionFilter::star},
    {"any", ObstructionFilter::any}};

/// Adds an option whose text `parse` turns into a value, or into nothing where it is malformed.
template <class Value, class Parse>
CLI::Option* add_parsed(CLI::App& command, const char* name, std::optional<Value>& value,
                        Parse parse, const std::string& shape, const char* help) {
    return command
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

/// Adds an option that takes a problem: classes that contain some of its features, or are contained
/// in it.
void add_part(CLI::App& command, const char* name, std::optional<std::vector<Part>>& value,
              const char* help) {
    command
        .add_option_function<std::string>(
            name,
            [&value, name](const std::string& text) {
                try {
                    value = parse_part(text);
                } catch (const NotationError& error) {
                    throw CLI::ValidationError(name, error.what());
                }
            },
            help)
        ->type_name("PROBLEM");
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

/// `pl0p` as `--pl0p`, for each word that is an option then.
std::vector<std::string> with_dashes(const std::string& text, const CLI::App& command) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;)
        words.push_back(command.get_option_no_throw("--" + word) ? "--" + word : word);
    return words;
}

/// `#2394`, `2394,6723` or `100..200`. Throws std::invalid_argument.
void add_numbers(std::vector<Range>& numbers, const std::string& text) {
    std::istringstream stream(text);
    for (std::string number; std::getline(stream, number, ',');) {
        const auto range =
            parse_range(std::string_view(number).substr(number.starts_with('#') ? 1 : 0));
        if (!range)
            throw std::invalid_argument("'" + number +
                                        "' is neither a filter nor a number or range of classes: "
                                        "`plprove list --help` has the filters");
        numbers.push_back(*range);
    }
}

} // namespace

CLI::Option* add_range_option(CLI::App& command, const char* name, std::optional<Range>& range,
                              const char* help) {
    return add_parsed(command, name, range, parse_range, "N or N..M", help);
}

void add_filters(CLI::App& command, Filter& filter) {
    for (const Flag& flag : flags)
        command.add_flag(flag.name, filter.*flag.member, flag.help);
    command.get_option("--not-minimal")->excludes("--minimal")->excludes("--terminal");
    for (const RangeOption& range : ranges)
        add_range_option(command, range.name, filter.*range.member, range.help);
    for (const ViewsOption& views : view_options)
        add_parsed(command, views.name, filter.*views.member, parse_views, "A,B,C", views.help);
    for (const PartOption& part : part_options)
        add_part(command, part.name, filter.*part.member, part.help);
    add_choice(command, "--obstruction", filter.obstruction, obstructions, "none|epipolar|star|any",
               "why it is not minimal: points shared by two views, or a star");
}

ClassFilter parse_class_filter(const std::string& text) {
    ClassFilter result;
    CLI::App command;
    command.set_help_flag();
    add_filters(command, result.filter);
    std::vector<std::string> numbers;
    command.add_option("NUMBER", numbers);
    std::vector<std::string> words = with_dashes(text, command);
    if (words.empty())
        throw std::invalid_argument(
            "found nothing: name filters of `plprove list`, or numbers of classes");
    std::ranges::reverse(words); // as CLI11 wants them
    try {
        command.parse(words);
    } catch (const CLI::ParseError& error) {
        throw std::invalid_argument(error.what());
    }
    for (const std::string& number : numbers)
        add_numbers(result.numbers, number);
    const std::vector<const CLI::Option*> given = std::as_const(command).get_options(
        [](const CLI::Option* option) { return option->count() > 0 && !option->get_positional(); });
    result.by_number_only = given.empty();
    return result;
}

} // namespace plprove
