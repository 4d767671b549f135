#include "prover/importers/expressions.h"
#include "prover/importers/importers.h"

#include <algorithm>
#include <optional>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;
using Kind = Token::Kind;

/// What `System(...)` was given.
struct System {
    Position at;
    std::vector<Value> equations;
    std::optional<std::vector<Value>> variables;
    std::vector<Value> parameters;
};

class Reader {
public:
    explicit Reader(std::string_view program)
        : tokens_(tokens_of(program, Language::julia)), expressions_(tokens_, Language::julia) {
        expressions_.is_ring = [](const std::string&) { return false; };
        expressions_.call = [](const std::string&, Value&) { return false; };
    }

    Draft run() {
        while (!tokens_.is(Kind::end)) {
            if (!tokens_.at_end_of_statement()) statement();
            if (!tokens_.at_end_of_statement())
                tokens_.fail("an operator or the end of the statement");
            tokens_.take();
        }
        if (!system_) tokens_.fail("a system, such as 'System([f, g])'");
        Draft& draft = expressions_.draft;
        for (const Value& parameter : system_->parameters)
            draft.data.push_back(parameter.text);
        draft.unknowns = unknowns();
        draft.equations = system_->equations;
        return std::move(draft);
    }

private:
    void statement() {
        if (tokens_.is("@")) return variables();
        const bool assigns = tokens_.is(Kind::name) && tokens_.next().word == "=";
        const std::string name = assigns ? tokens_.here().word : "";
        if (assigns) {
            tokens_.take(), tokens_.take();
            tokens_.skip_new_lines();
        }
        if (begins_system()) return system(name);
        // What comes after the system solves it.
        if (system_ || tokens_.is_word("using") || tokens_.is_word("import"))
            return tokens_.skip_statement();
        const Value value = expressions_.read();
        if (assigns) expressions_.values[name] = expressions_.draft.named(name, value);
    }

    /// @var x y a[1:3] m[1:2, 1:2]
    void variables() {
        tokens_.take();
        const Position at = tokens_.here().at;
        const std::string macro = tokens_.name("@var");
        if (macro != "var" && macro != "polyvar")
            throw ModelError(at, "found '@" + macro + "': only @var is imported");
        while (!tokens_.at_end_of_statement()) {
            tokens_.skip(",");
            const std::string name = tokens_.name("a variable");
            std::vector<int> sizes;
            if (tokens_.skip("[")) {
                do {
                    if (tokens_.integer() != 1) tokens_.fail("a range that begins with 1");
                    tokens_.expect(":");
                    sizes.push_back(tokens_.integer());
                } while (tokens_.skip(","));
                tokens_.expect("]");
            }
            expressions_.values[name] = variable(name, sizes);
        }
    }

    Value variable(const std::string& name, std::vector<int> sizes) {
        constexpr std::size_t most = 1000;
        if (names_.size() > most)
            throw ModelError(tokens_.here().at, "a program to import has at most 1000 variables");
        if (sizes.empty()) {
            names_.push_back(expressions_.draft.new_name(name));
            return Value::scalar(names_.back());
        }
        std::vector<Value> items;
        const std::vector<int> rest(sizes.begin() + 1, sizes.end());
        for (int i = 1; i <= sizes.front(); ++i)
            items.push_back(variable(name + "_" + std::to_string(i), rest));
        return Value::list(std::move(items));
    }

    bool begins_system() const { return tokens_.is_word("System") && tokens_.next().word == "("; }

    void system(const std::string& name) {
        System result{tokens_.take().at, {}, {}, {}};
        tokens_.expect("(");
        tokens_.skip_new_lines();
        result.equations = scalars(expressions_.read());
        tokens_.skip_new_lines();
        while (tokens_.skip(",") || tokens_.skip(";")) {
            tokens_.skip_new_lines();
            if (tokens_.is(")")) break;
            const Position at = tokens_.here().at;
            const std::string option = tokens_.name("variables or parameters");
            std::vector<Value> value;
            if (tokens_.skip("="))
                value = scalars(expressions_.read());
            else if (const auto found = expressions_.values.find(option);
                     found != expressions_.values.end())
                value = scalars(found->second);
            if (option == "variables")
                result.variables = value;
            else if (option == "parameters")
                result.parameters = value;
            else
                throw ModelError(at, "found the option '" + option +
                                         "' of a system: there are variables and parameters");
            refuse_unless_names(value, at);
            tokens_.skip_new_lines();
        }
        tokens_.expect(")");
        if (name == "conditions" && system_)
            expressions_.draft.conditions = result.equations;
        else if (!system_)
            system_ = std::move(result);
    }

    void refuse_unless_names(const std::vector<Value>& list, Position at) const {
        for (const Value& item : list)
            if (std::ranges::find(names_, item.text) == names_.end())
                throw ModelError(at, "found '" + item.text + "' where a variable was expected");
    }

    /// Those that the system names, or all variables that are no parameters.
    std::vector<std::string> unknowns() const {
        const auto is_in = [](const std::vector<Value>& list, const std::string& name) {
            return std::ranges::any_of(list, [&](const Value& item) { return item.text == name; });
        };
        std::vector<std::string> result;
        for (const std::string& name : names_) {
            const bool datum = is_in(system_->parameters, name);
            if (!system_->variables ? !datum : is_in(*system_->variables, name))
                result.push_back(name);
        }
        return result;
    }

    Tokens tokens_;
    Expressions expressions_;
    std::vector<std::string> names_; // of all variables, in the model
    std::optional<System> system_;
};

} // namespace

std::string from_julia(std::string_view program, const std::string& source) {
    return Reader(program).run().text(source + ", a program for HomotopyContinuation.jl");
}

} // namespace plprove::importers
