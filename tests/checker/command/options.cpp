// The command line of plcheck: what it refuses, and what to write instead.
#include "checker/command/options.h"

#include <doctest/doctest.h>
#include <utility>

using namespace checker;

namespace {

Options parsed(std::vector<std::string> words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    return parse_options(pointers);
}

/// Why the words are refused; empty if they are not.
std::string refusal(const std::vector<std::string>& words) {
    try {
        parsed(words);
        return "";
    } catch (const WrongUsage& wrong) {
        return wrong.reason;
    }
}

} // namespace

TEST_CASE("wrong words on the command line are refused, each for its reason") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
        {{}, "no file given, see --help"},
        {{"--json"}, "no file given, see --help"},
        {{"--threads"}, "--threads needs a value after it, see --help"},
        {{"--expect", "P/P", "--expect", "P/P", "f"}, "--expect stands twice; give it once"},
        {{"--threads", "1025", "f"},
         "--threads 1025 is no number of threads; write 1 to 1024, like --threads 4"},
        {{"--threads", "0", "f"},
         "--threads 0 is no number of threads; write 1 to 1024, like --threads 4"},
        {{"--effort=-1", "f"}, "--effort -1 is no effort; write a number, like --effort 1000000"},
        {{"--json", "--version", "f"},
         "--version stands alone; put -- before files with such names"},
        {{"--jsn", "f"}, "unknown option --jsn, see --help"},
        {{"f", "--json"},
         "--json stands after a file; put options first, or -- before files with such names"},
        {{"--expect", "5*P/P", "--verdict", "perhaps", "f"},
         "unknown verdict perhaps; choose one of minimal, camera-minimal, not-minimal, obstructed, "
         "under-constrained, over-constrained"},
        {{"--expect", "5*P/P", "--verdict", "minimal 2", "f"},
         "unknown verdict minimal 2; choose one of minimal, camera-minimal, not-minimal, "
         "obstructed, under-constrained, over-constrained"},
        {{"--expect", "5*P/P", "--degree", "many", "f"},
         "--degree many is no number of solutions; write 312, or '>=312' in quotes"},
        {{"--expect", "5*P/P", "--degree", "012", "f"},
         "--degree 012 is no number of solutions; write 312, or '>=312' in quotes"},
        {{"--expect", "5*P/P", "f"},
         "say what to expect of the problem: add --verdict minimal, --degree N, or --group S312"},
        {{"--verdict", "minimal", "f"},
         "--verdict, --degree and --group are about a problem; add --expect PROBLEM"},
        {{"--degree", "3", "f"},
         "--verdict, --degree and --group are about a problem; add --expect PROBLEM"},
        {{"--group", "S3", "f"},
         "--verdict, --degree and --group are about a problem; add --expect PROBLEM"},
        {{"--expect", "5*P/P", "--group", "M12", "f"},
         "--group M12 is no group; write S312, or '>=A312' or '<S8 wr S2 wr S10' in quotes"},
        {{"--expect", "5*P/P", "--group", "A312", "f"},
         "--group A312 is no group; write S312, or '>=A312' or '<S8 wr S2 wr S10' in quotes"},
        {{"--expect", "5*P/P", "--group", ">=A0", "f"},
         "--group >=A0 is no group; write S312, or '>=A312' or '<S8 wr S2 wr S10' in quotes"},
        {{"--expect", SOURCE_DIR "/models/p3p.model", "--group", "M12", "f"},
         "--group M12 is no group; write S312, or '>=A312' or '<S8 wr S2 wr S10' in quotes"},
        {{"--classification", "--degree", "3", "f"},
         "--classification expects the whole table; leave out --expect, --verdict, --degree and "
         "--group"},
        {{"--family", "plmp", "--verdict", "minimal", "f"},
         "--family expects a whole family; leave out --expect, --verdict, --degree, --group and "
         "--classification"},
        {{"--expect-list", "mine.txt", "--degree", "3", "f"},
         "--expect-list expects all problems of a list; leave out --expect, --degree, --group, "
         "--classification and --family"},
        {{"--expect-list", "/", "f"}, "--expect-list: / cannot be read"},
        {{"--expect-list", "/dev/null", "f"}, "/dev/null has no problem; write one a line"},
        {{"--expect", "no such.model", "--degree", "3", "f"},
         "--expect no such.model: the file of the model cannot be read"},
    };
    for (const auto& [words, reason] : wrong)
        CHECK(refusal(words) == reason);
    CHECK(refusal({"--expect", "5*Q/P", "--degree", "3", "f"}).starts_with("--expect 5*Q/P: "));
    CHECK(
        refusal({"--family", "plm", "f"}).starts_with("unknown family plm; choose one of plmp, "));
    CHECK(refusal({"--expect", SOURCE_DIR "/models/p3p.model", "--verdict", "obstructed", "f"}) ==
          "of a model one can expect --verdict minimal, --degree N, or --group S10");
}

TEST_CASE("numbers at their limits are taken") {
    CHECK(parsed({"--threads", "1024", "f"}).threads == 1024);
    CHECK(parsed({"--effort", "1", "f"}).effort == 1);
    CHECK(parsed({"--", "--json"}).paths.size() == 1);
    CHECK(refusal({"--expect", "5*P/P", "--verdict", "over-constrained 2", "f"}).empty());
}
