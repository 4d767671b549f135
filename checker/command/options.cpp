#include "checker/command/options.h"

#include <thread>

namespace checker {
static constexpr std::size_t most_threads = 1024;

/// The arguments that are left to read.
class Arguments {
public:
    explicit Arguments(std::span<char* const> values) : values_(values) {}

    bool empty() const { return next_ == values_.size(); }
    const char* take() { return values_[next_++]; }
    std::string_view peek() const { return values_[next_]; }

    /// Takes the value of an option, which follows it, or `=` in it.
    std::string_view value_of(std::string_view option) {
        const std::size_t equals = option.find('=');
        if (equals != option.npos) return option.substr(equals + 1);
        if (empty()) throw WrongUsage{say(option, " needs a value after it, see --help")};
        return take();
    }

private:
    std::span<char* const> values_;
    std::size_t next_ = 0;
};

static void set(std::optional<std::string_view>& words, std::string_view option,
                std::string_view value) {
    if (words) throw WrongUsage{say(option, " stands twice; give it once")};
    words = value;
}

static std::size_t parse_threads(std::string_view text) {
    const auto threads = parse_number(text);
    if (!threads || *threads > most_threads)
        throw WrongUsage{say("--threads ", printable(text, 40),
                             " is no number of threads; write 1 to ", most_threads,
                             ", like --threads 4")};
    return *threads;
}

static std::uint64_t parse_effort(std::string_view text) {
    const auto effort = parse_number(text);
    if (!effort)
        throw WrongUsage{say("--effort ", printable(text, 40),
                             " is no effort; write a number, like --effort 1000000")};
    return *effort;
}

/// Whether the argument is this option, which has a value.
static bool is(std::string_view argument, std::string_view option) {
    return argument.substr(0, argument.find('=')) == option;
}

static void take_option(Arguments& arguments, Options& options, ExpectedWords& expected) {
    const std::string_view option = arguments.take();
    if (option == "--json")
        options.json = true;
    else if (option == "--quiet")
        options.quiet = true;
    else if (option == "--table")
        options.table = true;
    else if (option == "--errata")
        options.errata = true;
    else if (option == "--why")
        options.why = true;
    else if (option == "--classification")
        expected.classification = true;
    else if (is(option, "--expect"))
        set(expected.problem, "--expect", arguments.value_of(option));
    else if (is(option, "--expect-list"))
        set(expected.list, "--expect-list", arguments.value_of(option));
    else if (is(option, "--verdict"))
        set(expected.verdict, "--verdict", arguments.value_of(option));
    else if (is(option, "--degree"))
        set(expected.degree, "--degree", arguments.value_of(option));
    else if (is(option, "--group"))
        set(expected.group, "--group", arguments.value_of(option));
    else if (is(option, "--threads"))
        options.threads = parse_threads(arguments.value_of(option));
    else if (is(option, "--effort"))
        options.effort = parse_effort(arguments.value_of(option));
    else if (is(option, "--family"))
        set(expected.family, "--family", arguments.value_of(option));
    else if (option == "--version" || option == "--help" || option == "-h")
        throw WrongUsage{say(option, " stands alone; put -- before files with such names")};
    else
        throw WrongUsage{say("unknown option ", printable(option, 40), ", see --help")};
}

Options parse_options(std::span<char* const> values) {
    Arguments arguments(values);
    Options options;
    ExpectedWords expected;
    while (!arguments.empty() && arguments.peek().starts_with('-') && arguments.peek() != "--")
        take_option(arguments, options, expected);
    const bool only_files = !arguments.empty() && arguments.peek() == "--";
    if (only_files) arguments.take();
    while (!arguments.empty()) {
        if (!only_files && arguments.peek().starts_with('-'))
            throw WrongUsage{say(printable(arguments.peek(), 40),
                                 " stands after a file; put options "
                                 "first, or -- before files with such names")};
        options.paths.push_back(arguments.take());
    }
    options.expectation = expectation_of(expected);
    if (options.threads == 0)
        options.threads =
            std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
    if (options.paths.empty()) throw WrongUsage{"no file given, see --help"};
    return options;
}
} // namespace checker
