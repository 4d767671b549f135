#include "prover/cli/describe.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace plprove {

namespace {

/// ` HEADING: --a --b` with the names in order; nothing if there are none. CLI11 keeps the options
/// in the order of their addresses.
std::string list_of(const char* heading, const std::set<CLI::Option*>& options) {
    std::set<std::string> names;
    for (const CLI::Option* option : options)
        names.insert(option->get_name());
    std::string text;
    for (const std::string& name : names)
        text += ' ' + name;
    return names.empty() ? text : std::string(" ") + heading + ':' + text;
}

/// What the help says of the value of an option, and of what goes with it.
std::string value_of(const CLI::Option& option) {
    std::string text;
    if (option.get_type_size() != 0) {
        text = option.get_type_name();
        if (!option.get_default_str().empty()) text += '=' + option.get_default_str();
        if (option.get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
        if (option.get_required()) text += " REQUIRED";
    }
    text += list_of("Needs", option.get_needs()) + list_of("Excludes", option.get_excludes());
    return text.starts_with(' ') ? text.substr(1) : text;
}

/// The text with blanks in place of line ends, and none at its end.
std::string in_one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string describe_option(const CLI::Option& option) {
    const bool operand = option.get_positional();
    const std::string names = option.get_name(operand, !operand);
    return std::string(operand ? "operand" : "option") + '\t' + names + '\t' + value_of(option) +
           '\t' + in_one_line(option.get_description()) + '\n';
}

std::string describe_all_but_commands(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options())
        text += describe_option(*option);
    std::istringstream footer(app.get_footer());
    for (std::string line; std::getline(footer, line);)
        text += "text\t" + line + '\n';
    return text;
}

std::string heading(const char* kind, const CLI::App& app) {
    return std::string(kind) + '\t' + app.get_name() + '\t' + in_one_line(app.get_description()) +
           '\n';
}

} // namespace

std::string describe(const CLI::App& program) {
    std::string text = heading("program", program) + describe_all_but_commands(program);
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        text += heading("command", *command) + describe_all_but_commands(*command);
    return text;
}

} // namespace plprove
