// The words that the language of models has, and the names that a model gives.
#pragma once

#include "prover/model/words.h"

#include <optional>
#include <string>
#include <vector>

namespace plprove::model {

/// The functions, and the words that begin statements.
const std::vector<std::string>& function_names();
const std::vector<std::string>& statement_words();

/// ": did you mean 'x'?" if a candidate is like the word, else nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// The names that mean something in a place of the text.
class Scope {
public:
    /// Gives the name a meaning. Throws ModelError if it is no NAME, or has one already.
    void add(const std::string& name, Position at);
    /// Forgets the names after the first `kept`.
    void forget(std::size_t kept) { names_.resize(kept); }
    std::size_t size() const { return names_.size(); }
    bool has(const std::string& name) const;
    const std::vector<std::string>& names() const { return names_; }
    /// Throws ModelError if the name has no meaning.
    void require(const std::string& name, Position at) const;

private:
    std::vector<std::string> names_;
};

} // namespace plprove::model
