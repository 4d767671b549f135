#include "checker/command/expected.h"

#include "checker/conclusion/group.h"
#include "checker/family/family.h"
#include "checker/model/program.h"
#include "checker/problem/notation.h"

#include <fstream>

namespace checker {
std::optional<std::size_t> parse_number(std::string_view digits) {
    std::size_t number = 0;
    const char* const end_of_digits = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), end_of_digits, number);
    const bool read = error == std::errc{} && end == end_of_digits;
    if (!read || number == 0 || digits[0] == '0') return std::nullopt;
    return number;
}

/// Two of the verdicts may say by how much: `over-constrained 2`.
static std::string checked_verdict(std::string_view verdict) {
    const std::size_t blank = verdict.find(' ');
    const std::string_view word = verdict.substr(0, blank);
    const bool known = std::ranges::find(expected_verdicts, word) != expected_verdicts.end();
    const bool sound = blank == verdict.npos || (word.ends_with("er-constrained") &&
                                                 parse_number(verdict.substr(blank + 1)));
    if (known && sound) return std::string(verdict);
    std::string all;
    for (const std::string_view one : expected_verdicts)
        all += (all.empty() ? "" : ", ") + std::string(one);
    throw WrongUsage{say("unknown verdict ", printable(verdict, 40), "; choose one of ", all)};
}

/// Reads N, or >=N.
static ExpectedDegree parse_degree(std::string_view text) {
    const bool exactly = !text.starts_with(">=");
    const auto solutions = parse_number(exactly ? text : text.substr(2));
    if (!solutions)
        throw WrongUsage{say("--degree ", printable(text, 40),
                             " is no number of solutions; write 312, or '>=312' in quotes")};
    return {exactly, *solutions};
}

/// Reads S312, >=A312, <S2 wr S10, <S8 wr S2 wr S10 or S2 wr S136.
static std::string parse_group(std::string_view text) {
    constexpr std::string_view of_five_points = " wr S2 wr S10", of_pairs = "S2 wr S";
    if (text == group_of_five_points) return std::string(text);
    std::string_view number = text;
    if (text.starts_with(of_pairs))
        number.remove_prefix(of_pairs.size());
    else if (text.starts_with('S'))
        number.remove_prefix(1);
    else if (text.starts_with(">=A"))
        number.remove_prefix(3);
    else if (text.starts_with("<S") && text.ends_with(of_five_points))
        number = text.substr(2, text.size() - 2 - of_five_points.size());
    if (number.size() < text.size() && parse_number(number)) return std::string(text);
    throw WrongUsage{say("--group ", printable(text, 40),
                         " is no group; write S312, or '>=A312' or '<S8 wr S2 wr S10' in quotes")};
}

/// Whether only section 13 of FORMAT.md may spell this: a kind of cameras, shared lines, many
/// views.
static bool only_in_general(std::string_view notation) {
    const auto is_shared = [](char c) { return c >= 'A' && c <= 'Z' && c != 'P'; };
    const std::string_view feature = notation.substr(0, notation.find('+'));
    return notation.find(':') != notation.npos || std::ranges::any_of(notation, is_shared) ||
           std::ranges::count(feature, '/') > 2;
}

/// The problem by section 13 if only that may spell it, else by section 1. The option, and the line
/// of a list, are named where it is refused.
static ExpectedProblem parse_expected(std::string_view notation, const std::string& where) {
    const bool in_general = only_in_general(notation);
    try {
        return {.notation = printable(notation, 4096),
                .problem = parse_problem(notation, in_general ? section_13 : section_1),
                .in_general = in_general};
    } catch (const Malformed& malformed) {
        throw WrongUsage{say(where, printable(notation, 200), ": ", malformed.complaint.reason,
                             "; write it like '2*Pa/Pa/Pa + P/P/P', in quotes")};
    }
}

static Expectation list_of(const ExpectedWords& words) {
    if (words.problem || words.degree || words.group || words.classification || words.family)
        throw WrongUsage{"--expect-list expects all problems of a list; leave out --expect, "
                         "--degree, --group, --classification and --family"};
    const std::string file(*words.list);
    std::ifstream stream(file);
    WholeList expected{.file = printable(file, 4096)};
    if (words.verdict) expected.verdict = checked_verdict(*words.verdict);
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::string where = say(expected.file, ", line ", number, ": ");
        expected.entries.push_back({number, parse_expected(line, where)});
    }
    if (!stream.eof()) throw WrongUsage{say("--expect-list: ", expected.file, " cannot be read")};
    if (expected.entries.empty())
        throw WrongUsage{say(expected.file, " has no problem; write one a line")};
    return expected;
}

static Expectation family_of(const ExpectedWords& words) {
    if (words.problem || words.verdict || words.degree || words.group || words.classification)
        throw WrongUsage{"--family expects a whole family; leave out --expect, --verdict, "
                         "--degree, --group and --classification"};
    if (!cameras_of_family(*words.family)) {
        std::string names;
        for (const CameraModel* cameras : camera_models())
            names += say(names.empty() ? "" : ", ", family_name(*cameras));
        throw WrongUsage{
            say("unknown family ", printable(*words.family, 40), "; choose one of ", names)};
    }
    return WholeFamily{std::string(*words.family)};
}

/// What is expected of the model in a file.
static Expectation model_of(const ExpectedWords& words) {
    const std::string file(*words.problem);
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream)
        throw WrongUsage{
            say("--expect ", printable(file, 200), ": the file of the model cannot be read")};
    if (words.verdict && *words.verdict != "minimal")
        throw WrongUsage{"of a model one can expect --verdict minimal, --degree N, or --group S10"};
    ExpectedModel expected{.file = printable(file, 4096), .text = lines_of_model(text)};
    if (words.degree) expected.degree = parse_degree(*words.degree);
    if (words.group) expected.group = parse_group(*words.group);
    return expected;
}

Expectation expectation_of(const ExpectedWords& words) {
    if (words.list) return list_of(words);
    if (words.family) return family_of(words);
    if (words.classification) {
        if (words.problem || words.verdict || words.degree || words.group)
            throw WrongUsage{"--classification expects the whole table; leave out --expect, "
                             "--verdict, --degree and --group"};
        return WholeClassification{};
    }
    if (!words.problem) {
        if (words.verdict || words.degree || words.group)
            throw WrongUsage{
                "--verdict, --degree and --group are about a problem; add --expect PROBLEM"};
        return {};
    }
    if (!words.verdict && !words.degree && !words.group)
        throw WrongUsage{"say what to expect of the problem: add --verdict minimal, --degree N, or "
                         "--group S312"};
    if (words.problem->ends_with(".model")) return model_of(words);
    ExpectedProblem expected = parse_expected(*words.problem, "--expect ");
    if (words.verdict) expected.verdict = checked_verdict(*words.verdict);
    if (words.degree) expected.degree = parse_degree(*words.degree);
    if (words.group) expected.group = parse_group(*words.group);
    return expected;
}
} // namespace checker
