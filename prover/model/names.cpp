#include "prover/model/names.h"

#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

/// Other words of the grammar of files.
const std::vector<std::string>& other_words() {
    static const std::vector<std::string> words{
        "in",       "end",        "vector",    "matrix", "by",         "model",
        "claimed",  "fibre",      "basis",     "rows",   "minor",      "modulus",
        "distinct", "polynomial", "separated", "degree", "elimination"};
    return words;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

} // namespace

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names{"dot",   "norm2",     "cross",    "skew",    "det",
                                                "trace", "transpose", "identity", "rotation"};
    return names;
}

const std::vector<std::string>& statement_words() {
    static const std::vector<std::string> words{"data",     "unknown", "let",   "equation",
                                                "relation", "nonzero", "count", "for"};
    return words;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
    const auto similar = most_similar(word, candidates);
    return similar ? ": did you mean " + in_quotes(*similar) + "?" : std::string{};
}

void Scope::add(const std::string& name, Position at) {
    if (!is_name(name))
        throw ModelError(at, "expected a name, found " + in_quotes(name) +
                                 ": a name is a letter, then at most 39 letters, digits and _");
    if (contains(function_names(), name) || contains(statement_words(), name) ||
        contains(other_words(), name))
        throw ModelError(at, in_quotes(name) + " is a word of the language: choose another name");
    if (has(name))
        throw ModelError(at, in_quotes(name) + " has a meaning already: choose another name");
    names_.push_back(name);
}

bool Scope::has(const std::string& name) const {
    return contains(names_, name);
}

void Scope::require(const std::string& name, Position at) const {
    if (has(name)) return;
    std::string advice = did_you_mean(name, names_);
    if (advice.empty()) advice = did_you_mean(name, function_names());
    if (advice.empty()) advice = ": give it by data, unknown or let in a line before";
    throw ModelError(at, "found " + in_quotes(name) + ", which has no meaning here" + advice);
}

} // namespace plprove::model
