// A model that is being written from a program in another language.
#pragma once

#include "prover/importers/value.h"
#include "prover/model/names.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace plprove::importers {

class Draft {
public:
    /// A name of the model for this name of the program: the same, as far as the language of models
    /// has it.
    std::string new_name(const std::string& name);
    /// The value with names for all scalars that are no atoms; `let` statements give them.
    Value named(const std::string& name, const Value& value);

    std::vector<std::string> data, unknowns;
    std::vector<Value> equations, conditions;

    /// The text of the model, with the `let` statements that it needs. `source` says what was
    /// imported. Throws BadInput if a variable is used that is neither data nor unknown.
    std::string text(const std::string& source) const;

private:
    struct Let {
        std::string name, value;
    };

    /// How often equations, conditions, and the `let` statements that they need have each name.
    std::map<std::string, int> uses() const;
    void refuse_other_names(const std::map<std::string, int>& uses) const;

    model::Scope scope_;
    std::vector<Let> lets_;
};

} // namespace plprove::importers
