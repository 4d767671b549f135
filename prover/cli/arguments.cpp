#include "prover/cli/arguments.h"

#include "prover/system/words.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace plprove {

namespace {

/// The subcommand that the words name; none if they name none.
const CLI::App* command_of(const CLI::App& program, const std::vector<std::string>& words) {
    for (const CLI::App* command : program.get_subcommands({}))
        if (!words.empty() && command->get_name() == words.front()) return command;
    return nullptr;
}

/// Whether the word is an option of the command that waits for a value.
bool takes_value(const CLI::App* command, const std::string& word) {
    if (command == nullptr || !word.starts_with('-')) return false;
    const CLI::Option* option = command->get_option_no_throw(word);
    return option != nullptr && option->get_items_expected_max() > 0;
}

bool takes_filter(const std::string& word) {
    return word == "--classes" || word == "--also";
}

/// A problem whose first view sees nothing of its first feature.
bool begins_like_a_problem(const std::string& word) {
    return word.starts_with("-/");
}

/// The names of the options, with their dashes.
std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options({}))
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

std::string call(const CLI::App& program, const CLI::App* command) {
    return program.get_name() + (command == nullptr ? "" : " " + command->get_name());
}

std::string help_of(const CLI::App& program, const CLI::App* command) {
    return "`" + call(program, command) + " --help` lists " +
           (command == nullptr ? "all commands" : "its options");
}

std::string unknown_option(const CLI::App& program, const CLI::App* command,
                           const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const std::vector<std::string> names = option_names(command == nullptr ? program : *command);
    const std::optional<std::string> meant = most_similar(name, names);
    return "`" + call(program, command) + "` has no option " + in_quotes(name) + ": " +
           (meant ? "did you mean " + *meant + "?" : help_of(program, command));
}

std::string unknown_command(const CLI::App& program, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    const std::optional<std::string> meant = most_similar(word, names);
    return "there is no command " + in_quotes(word) + ": " +
           (meant ? "did you mean `" + program.get_name() + " " + *meant + "`?"
                  : help_of(program, nullptr));
}

/// Advice where the command got more words than it takes.
std::string unexpected_words(const CLI::App& program, const CLI::App& command,
                             const std::vector<std::string>& extras) {
    const auto option =
        std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with('-'); });
    if (option != extras.end()) return unknown_option(program, &command, *option);
    if (command.get_option_no_throw("PROBLEM") == nullptr)
        return "did not expect " + in_quotes(extras.back()) + ": " + help_of(program, &command);
    return "the problem has blanks: put it into quotes, such as " + call(program, &command) +
           " 'P/P/P + 4*a/a/a'";
}

} // namespace

std::vector<std::string> words_of(int argc, char** argv) {
    return {argv + std::min(argc, 1), argv + argc};
}

std::vector<std::string> for_cli11(const CLI::App& program, std::vector<std::string> words) {
    const CLI::App* command = command_of(program, words);
    std::vector<std::string> result;
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool has_next = i + 1 < words.size();
        const bool tied =
            has_next && (takes_filter(words[i]) ||
                         (takes_value(command, words[i]) && begins_like_a_problem(words[i + 1])));
        if (words[i] == "--") {
            problems.insert(problems.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                            words.end());
            break;
        }
        if (tied) {
            result.push_back(words[i] + '=' + words[i + 1]);
            ++i;
        } else if (begins_like_a_problem(words[i])) {
            problems.push_back(words[i]);
        } else {
            result.push_back(words[i]);
        }
    }
    if (!problems.empty()) result.emplace_back("--");
    result.insert(result.end(), problems.begin(), problems.end());
    std::ranges::reverse(result);
    return result;
}

std::string usage_advice(const CLI::App& program, const std::vector<std::string>& words,
                         const CLI::ParseError& error) {
    const CLI::App* command = command_of(program, words);
    if (words.empty())
        return "say what to do, such as `plprove problem 2394`: " + help_of(program, nullptr);
    if (command == nullptr && words.front().starts_with('-'))
        return unknown_option(program, nullptr, words.front());
    if (command == nullptr) return unknown_command(program, words.front());
    const std::vector<std::string> extras = command->remaining();
    if (!extras.empty()) return unexpected_words(program, *command, extras);
    std::string message = error.what();
    std::ranges::replace(message, '\n', ' ');
    return message + ": " + help_of(program, command);
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
    command
        .add_option_function<std::string>(
            "--seed",
            [&seed](const std::string& text) {
                const char* end = text.data() + text.size();
                const auto [stop, error] = std::from_chars(text.data(), end, seed);
                if (error != std::errc{} || stop != end)
                    throw CLI::ValidationError(
                        "--seed", "expected a whole number from 0 to " +
                                      std::to_string(std::numeric_limits<std::uint64_t>::max()) +
                                      ", found " + in_quotes(text));
            },
            "draw other random images")
        ->type_name("N")
        ->default_str(std::to_string(seed));
}

} // namespace plprove
