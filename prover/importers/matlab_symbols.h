// The symbols of a Matlab program that is imported: what becomes data and unknowns of the model.
#pragma once

#include "prover/importers/arrays.h"
#include "prover/importers/draft.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plprove::importers {

class MatlabSymbols {
public:
    explicit MatlabSymbols(Draft& draft) : draft_(draft) {}

    /// A symbol with this name, the same one each time.
    Value symbol(const std::string& name, model::Position at);

    static bool has_function(const std::string& name);
    /// The value of a function that makes symbols (sym, gbs_Matrix, create_vars) or chooses numbers
    /// by chance (randi, rand, randn), which get names after `target`. `text` is what the arguments
    /// have in quotes; empty if none. Nothing if no such function has the name.
    std::optional<Array> call(const std::string& name, const std::string& text,
                              const std::vector<Array>& arguments, const std::string& target,
                              model::Position at);

    /// Says which of the symbols are unknown. Without it, all are.
    void set_unknowns(const std::vector<std::string>& names, model::Position at);
    /// Tells the draft which names are data, and which are unknown.
    void declare();

private:
    bool has(const std::string& name) const;
    std::string new_name(const std::string& name, model::Position at);
    Array symbols(const std::string& format, Sizes sizes, model::Position at);
    Array random(const std::string& name, Sizes sizes, model::Position at);

    Draft& draft_;
    std::vector<std::pair<std::string, std::string>> symbols_; // names there, and in the model
    std::vector<std::string> random_, unknowns_;
    bool has_unknowns_ = false;
};

} // namespace plprove::importers
