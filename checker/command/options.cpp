#include "checker/command/options.h"

namespace checker {
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

/// The parts of an expectation, as they come.
struct Parts {
    std::optional<std::string_view> problem{}, verdict{}, degree{};
    bool classification = false;
};

static void set(std::optional<std::string_view>& part, std::string_view option,
                std::string_view value) {
    if (part) throw WrongUsage{say(option, " stands twice; give it once")};
    part = value;
}

static std::string checked_verdict(std::string_view verdict) {
    const std::string_view word = verdict.substr(0, verdict.find(' '));
    const bool has_number = word.ends_with("er-constrained");
    if ((word == verdict || has_number) &&
        std::ranges::find(expected_verdicts, word) != expected_verdicts.end())
        return std::string(verdict);
    std::string known;
    for (const std::string_view one : expected_verdicts)
        known += (known.empty() ? "" : ", ") + std::string(one);
    throw WrongUsage{say("unknown verdict ", printable(verdict, 40), "; choose one of ", known)};
}

/// Reads N, or >=N.
static ExpectedDegree parse_degree(std::string_view text) {
    ExpectedDegree degree{.exactly = !text.starts_with(">=")};
    const std::string_view digits = degree.exactly ? text : text.substr(2);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), degree.solutions);
    const bool read = error == std::errc{} && end == digits.data() + digits.size();
    if (!read || degree.solutions == 0 || digits[0] == '0')
        throw WrongUsage{say("--degree ", printable(text, 40),
                             " is no number of solutions; write 312, or '>=312' in quotes")};
    return degree;
}

static Expectation expectation_of(const Parts& parts) {
    if (parts.classification) {
        if (parts.problem || parts.verdict || parts.degree)
            throw WrongUsage{"--classification expects the whole table; leave out --expect, "
                             "--verdict and --degree"};
        return WholeClassification{};
    }
    if (!parts.problem) {
        if (parts.verdict || parts.degree)
            throw WrongUsage{"--verdict and --degree are about a problem; add --expect PROBLEM"};
        return {};
    }
    if (!parts.verdict && !parts.degree)
        throw WrongUsage{"say what to expect of the problem: add --verdict minimal, or --degree N"};
    ExpectedProblem expected{.notation = printable(*parts.problem, 4096)};
    try {
        expected.problem = parse_problem(*parts.problem);
    } catch (const Malformed& malformed) {
        throw WrongUsage{say("--expect ", printable(*parts.problem, 200), ": ",
                             malformed.complaint.reason,
                             "; write it like '2*Pa/Pa/Pa + P/P/P', in quotes")};
    }
    if (parts.verdict) expected.verdict = checked_verdict(*parts.verdict);
    if (parts.degree) expected.degree = parse_degree(*parts.degree);
    return expected;
}

/// Whether the argument is this option, which has a value.
static bool is(std::string_view argument, std::string_view option) {
    return argument.substr(0, argument.find('=')) == option;
}

static void take_option(Arguments& arguments, Options& options, Parts& parts) {
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
        parts.classification = true;
    else if (is(option, "--expect"))
        set(parts.problem, "--expect", arguments.value_of(option));
    else if (is(option, "--verdict"))
        set(parts.verdict, "--verdict", arguments.value_of(option));
    else if (is(option, "--degree"))
        set(parts.degree, "--degree", arguments.value_of(option));
    else if (option == "--version" || option == "--help" || option == "-h")
        throw WrongUsage{say(option, " stands alone; put -- before files with such names")};
    else
        throw WrongUsage{say("unknown option ", printable(option, 40), ", see --help")};
}

Options parse_options(std::span<char* const> values) {
    Arguments arguments(values);
    Options options;
    Parts parts;
    while (!arguments.empty() && arguments.peek().starts_with('-') && arguments.peek() != "--")
        take_option(arguments, options, parts);
    const bool only_files = !arguments.empty() && arguments.peek() == "--";
    if (only_files) arguments.take();
    while (!arguments.empty()) {
        if (!only_files && arguments.peek().starts_with('-'))
            throw WrongUsage{say(printable(arguments.peek(), 40),
                                 " stands after a file; put options "
                                 "first, or -- before files with such names")};
        options.paths.push_back(arguments.take());
    }
    options.expectation = expectation_of(parts);
    if (options.paths.empty()) throw WrongUsage{"no file given, see --help"};
    return options;
}
} // namespace checker
