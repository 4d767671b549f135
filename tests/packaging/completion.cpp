// Completion, in each shell that is there: what the shell offers after some words.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <set>

namespace {

using Words = std::set<std::string>;

/// The words that a shell offers for the last word of a command line, as one of these does it.
using Complete = Words (*)(const std::string& line);

std::string share(const std::string& name) {
    return (installed() / "share" / name).string();
}

Words words_of(const std::string& text) {
    Words words;
    for (std::string word : lines_of(text)) {
        word.erase(std::min(word.find('\t'), word.size())); // fish: a description
        if (word.ends_with(' ')) word.pop_back();
        if (!word.empty()) words.insert(word);
    }
    return words;
}

/// Runs a script of a shell with the command line in the variable `line`.
Words offered(const std::string& shell, const std::string& line, const std::string& script) {
    const TemporaryFolder folder;
    write_file(folder / "script", script);
    const Outcome outcome = run("cd " + folder.path().string() + " && touch mine.plc && line='" +
                                line + "' timeout 60 " + shell + " script");
    CAPTURE(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    return words_of(outcome.out);
}

Words in_bash(const std::string& line) {
    const std::string program = line.substr(0, line.find(' '));
    return offered("bash", line,
                   "compopt() { :; }\n" // only a shell that someone types into has options
                   "source " +
                       share("bash-completion/completions/" + program) +
                       "\n"
                       "read -r -a COMP_WORDS <<<\"$line\"\n"
                       "if [[ $line == *' ' ]]; then COMP_WORDS+=(''); fi\n"
                       "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                       "_" +
                       program +
                       "\n"
                       "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
}

Words in_fish(const std::string& line) {
    return offered("env XDG_DATA_DIRS=" + share("") + " HOME=. fish --no-config", line,
                   "for folder in " + share("fish/vendor_completions.d") +
                       "/*; source $folder; end\ncomplete -C \"$line\"\n");
}

/// zsh completes only where someone types: here a second zsh in a terminal of its own. Its matches
/// are written down instead of shown.
Words in_zsh(const std::string& line) {
    return offered("zsh -f", line,
                   "zmodload zsh/zpty\n"
                   "zpty inner zsh -f -i\n"
                   "zpty -w inner 'PS1=; fpath=(" +
                       share("zsh/site-functions") +
                       " $fpath)'\n"
                       "zpty -w inner 'autoload -U compinit; compinit -u -D'\n"
                       "zpty -w inner 'compadd() { builtin compadd -A kept \"$@\"; "
                       "print -l -- $kept >>offered; builtin compadd \"$@\" }'\n"
                       "zpty -w inner 'finish() { : >done; }; zle -N finish; "
                       "bindkey \"^I\" complete-word; bindkey \"^X\" finish; : >ready'\n"
                       "until [[ -e ready ]]; do sleep 0.05; done\n"
                       "zpty -w -n inner \"$line\"$'\\t\\x18'\n"
                       "until [[ -e done ]]; do zpty -r -t inner out; sleep 0.05; done\n"
                       "zpty -d inner\n"
                       "if [[ -e offered ]]; then cat offered; fi\n");
}

void check_completion(const char* shell, Complete complete) {
    if (!has_program(shell)) {
        MESSAGE("left out: " << std::string(shell) << " is not installed");
        return;
    }
    CHECK(complete("plprove cla") == Words{"classification"});
    CHECK(complete("plprove degr") == Words{"degree", "degrees"});
    CHECK(complete("plprove problem --cert") == Words{"--certificate"});
    CHECK(complete("plprove list --format ") == Words{"csv", "json", "notation", "number"});
    CHECK(complete("plprove list --obstruction st") == Words{"star"});
    CHECK(complete("plcheck --err") == Words{"--errata"});
    CHECK(complete("plcheck --verdict not") == Words{"not-minimal"});
    CHECK(complete("plcheck mi") == Words{"mine.plc"});
    CHECK(complete("plprove certify 2394 -o mi") == Words{"mine.plc"});
    CHECK(complete("plprove problem mi").empty()); // a problem is no file
}

} // namespace

TEST_CASE("bash completes commands, options, their values and files") {
    check_completion("bash", in_bash);
}

TEST_CASE("fish completes commands, options, their values and files") {
    check_completion("fish", in_fish);
}

TEST_CASE("zsh completes commands, options, their values and files") {
    check_completion("zsh", in_zsh);
}
