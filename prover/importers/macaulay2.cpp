#include "prover/importers/expressions.h"
#include "prover/importers/importers.h"

#include <algorithm>
#include <array>
#include <set>

namespace plprove::importers {

namespace {

using model::ModelError;
using Kind = Token::Kind;

/// A ring: the variables of its coefficients, and its own, as the program names them.
struct Ring {
    std::vector<std::string> parameters, variables;
};

class Reader {
public:
    explicit Reader(std::string_view program)
        : tokens_(tokens_of(program, Language::macaulay2)),
          expressions_(tokens_, Language::macaulay2) {
        expressions_.is_ring = [this](const std::string& name) { return rings_.contains(name); };
        expressions_.call = [this](const std::string& name, Value& result) {
            return call(name, result);
        };
        for (const char* field : {"QQ", "ZZ", "RR", "CC"})
            rings_[field] = {};
    }

    Draft run() {
        while (!tokens_.is(Kind::end)) {
            if (!tokens_.at_end_of_statement()) statement();
            if (!tokens_.at_end_of_statement())
                tokens_.fail("an operator or the end of the statement");
            tokens_.take();
        }
        if (!has_ideal_) tokens_.fail("an ideal, such as 'I = ideal(f, g)'");
        Draft& draft = expressions_.draft;
        for (const std::string& name : ring_.parameters)
            draft.data.push_back(expressions_.values.at(name).text);
        for (const std::string& name : ring_.variables)
            draft.unknowns.push_back(expressions_.values.at(name).text);
        draft.equations = scalars(ideal_);
        draft.conditions = conditions_;
        return std::move(draft);
    }

private:
    void statement() {
        if (const std::string name = assigned_name(); !name.empty()) return assignment(name);
        if (tokens_.is("<<") || (tokens_.is(Kind::name) && asks(tokens_.here().word)))
            return tokens_.skip_statement();
        if (tokens_.is_word("scan")) return scan();
        if (tokens_.is_word("if")) return check();
        keep(expressions_.read());
    }

    /// What is asked of a system, or of the program itself, and says nothing of the equations.
    static bool asks(const std::string& word) {
        static const std::set<std::string> words{"dim",
                                                 "degree",
                                                 "codim",
                                                 "gens",
                                                 "gb",
                                                 "betti",
                                                 "print",
                                                 "use",
                                                 "time",
                                                 "decompose",
                                                 "elapsedTime",
                                                 "primaryDecomposition",
                                                 "exit",
                                                 "setRandomSeed",
                                                 "restart",
                                                 "load",
                                                 "needsPackage",
                                                 "clearAll",
                                                 "loadPackage",
                                                 "isPrime",
                                                 "radical",
                                                 "stdio",
                                                 "hilbertPolynomial"};
        return words.contains(word);
    }

    /// The name before `=`, which is taken with it; empty if this is no assignment.
    std::string assigned_name() {
        Tokens ahead = tokens_;
        if (!ahead.is(Kind::name)) return {};
        std::string name = ahead.take().word;
        if (ahead.skip("_") && ahead.is(Kind::number)) name += "_" + ahead.take().word;
        if (!ahead.skip("=") && !ahead.skip(":=")) return {};
        tokens_ = ahead;
        return name;
    }

    void assignment(const std::string& name) {
        tokens_.skip_new_lines();
        const model::Position at = tokens_.here().at;
        if (begins_ring()) {
            rings_[name] = ring();
            return;
        }
        if (tokens_.is(Kind::name) && tokens_.next().word == "->") return function(name);
        if (tokens_.is_word("map") || tokens_.is_word("rank")) return tokens_.skip_statement();
        if (std::ranges::find(ring_.variables, name) != ring_.variables.end() ||
            std::ranges::find(ring_.parameters, name) != ring_.parameters.end())
            throw ModelError(at, "found a new value of the variable '" + name + "'");
        Value value = expressions_.read();
        keep(value);
        expressions_.values[name] = value.is_ideal ? value : expressions_.draft.named(name, value);
    }

    void keep(const Value& value) {
        if (!value.is_ideal) return;
        has_ideal_ = true;
        ideal_ = value;
    }

    bool begins_ring() const {
        return tokens_.is(Kind::name) && (rings_.contains(tokens_.here().word) ||
                                          tokens_.is_word("frac") || tokens_.is_word("GF"));
    }

    /// QQ[a, b][x, y], frac(QQ[a])[x], ZZ/p, frac R.
    Ring ring() {
        Ring result;
        if (tokens_.is_word("frac")) {
            tokens_.take();
            const bool bracket = tokens_.skip("(");
            result = ring();
            if (bracket) tokens_.expect(")");
        } else if (tokens_.is_word("GF")) {
            tokens_.take();
            tokens_.expect("(");
            tokens_.integer();
            tokens_.expect(")");
        } else {
            if (!begins_ring()) tokens_.fail("a ring, such as QQ[x, y]");
            const std::string name = tokens_.take().word;
            result = rings_.at(name);
            if (name == "RR" || name == "CC") {
                if (tokens_.skip("_")) tokens_.integer();
            }
        }
        if (tokens_.skip("/")) {
            if (!tokens_.is(Kind::number))
                tokens_.fail("a prime number: quotient rings have "
                             "equations of their own");
            tokens_.take();
        }
        while (tokens_.is("[")) {
            tokens_.take();
            result.parameters.insert(result.parameters.end(), result.variables.begin(),
                                     result.variables.end());
            result.variables = variables();
            declare(result);
        }
        return result;
    }

    /// Only the variables of the last ring are names.
    void declare(const Ring& ring) {
        for (const auto* names : {&ring_.parameters, &ring_.variables})
            for (const std::string& name : *names)
                if (std::ranges::find(ring.parameters, name) == ring.parameters.end())
                    expressions_.values.erase(name);
        for (const std::string& name : ring.variables) {
            if (std::ranges::find(ring.parameters, name) != ring.parameters.end())
                throw ModelError(tokens_.here().at, "the variable '" + name + "' is given twice");
            expressions_.values[name] = Value::scalar(expressions_.draft.new_name(name));
        }
        ring_ = ring;
    }

    std::vector<std::string> variables() {
        constexpr std::size_t most = 1000;
        std::vector<std::string> names;
        tokens_.skip_new_lines();
        while (!tokens_.skip("]")) {
            if (tokens_.is(Kind::name) && tokens_.next().word == "=>") {
                skip_option();
            } else {
                const bool braces = tokens_.skip("{");
                const Variable first = variable();
                const std::vector<std::string> more =
                    tokens_.skip("..") ? between(first, variable()) : std::vector{first.text()};
                names.insert(names.end(), more.begin(), more.end());
                if (braces) tokens_.skip("}");
            }
            if (names.size() > most)
                throw ModelError(tokens_.here().at, "a ring to import has at most 1000 variables");
            if (!tokens_.skip(",") && !tokens_.is("]")) tokens_.fail("',' or ']'");
        }
        std::vector<std::string> sorted = names;
        std::ranges::sort(sorted);
        if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
            throw ModelError(tokens_.here().at, "the variable '" + *twice + "' is given twice");
        return names;
    }

    /// MonomialOrder => Lex says nothing of the equations.
    void skip_option() {
        int open = 0;
        while (open > 0 || (!tokens_.is(",") && !tokens_.is("]"))) {
            if (tokens_.is("{") || tokens_.is("(")) ++open;
            if (tokens_.is("}") || tokens_.is(")")) --open;
            tokens_.take();
        }
    }

    struct Variable {
        std::string name;
        std::vector<int> indices;
        model::Position at;

        std::string text() const {
            std::string result = name;
            for (const int index : indices)
                result += "_" + std::to_string(index);
            return result;
        }
    };

    Variable variable() {
        Variable result{{}, {}, tokens_.here().at};
        result.name = tokens_.name("a variable");
        if (!tokens_.skip("_")) return result;
        if (!tokens_.skip("(")) {
            result.indices = {tokens_.integer()};
            return result;
        }
        do
            result.indices.push_back(tokens_.integer());
        while (tokens_.skip(","));
        tokens_.expect(")");
        return result;
    }

    /// a..d, x_1..x_5, x_(1,1)..x_(2,3): the last index runs first.
    static std::vector<std::string> between(const Variable& first, const Variable& last) {
        constexpr std::size_t most = 1000;
        std::vector<std::string> names;
        if (first.indices.empty() && last.indices.empty() && first.name.size() == 1 &&
            last.name.size() == 1) {
            for (int c = first.name[0]; c <= last.name[0]; ++c)
                names.emplace_back(1, static_cast<char>(c));
        } else if (first.name == last.name && first.indices.size() == last.indices.size()) {
            Variable next = first;
            while (next.indices.front() <= last.indices.front() && names.size() <= most) {
                names.push_back(next.text());
                for (std::size_t i = next.indices.size(); i-- > 0;) {
                    if (++next.indices[i] <= last.indices[i] || i == 0) break;
                    next.indices[i] = first.indices[i];
                }
            }
        }
        if (names.empty())
            throw ModelError(first.at, "this is no range of variables, such as a..d or x_1..x_5");
        return names;
    }

    /// f -> numerator promote(f, F) leaves the zeros as they are; other functions are not read.
    void function(const std::string& name) {
        const model::Position at = tokens_.here().at;
        const std::string argument = tokens_.take().word;
        tokens_.take();
        std::string body;
        while (!tokens_.at_end_of_statement())
            body += tokens_.take().word + " ";
        const std::string expected = "numerator promote ( " + argument + " , ";
        if (!body.starts_with(expected))
            throw ModelError(at, "functions are not imported: write out what '" + name + "' does");
        numerators_.insert(name);
    }

    /// scan({...}, c -> I = saturate(I, ideal f c)) says what is not 0.
    void scan() {
        const model::Position at = tokens_.take().at;
        tokens_.expect("(");
        const Value list = expressions_.read();
        std::string body;
        while (!tokens_.at_end_of_statement())
            body += tokens_.take().word + " ";
        if (body.find("saturate") == std::string::npos)
            throw ModelError(at, "loops are not imported: write out what they do");
        add_conditions(list);
    }

    /// if ... then error "..." says nothing of the equations.
    void check() {
        const model::Position at = tokens_.here().at;
        bool fails = false;
        while (!tokens_.at_end_of_statement()) {
            const std::string word = tokens_.take().word;
            fails = fails || (word == "then" && tokens_.is_word("error"));
        }
        if (!fails) throw ModelError(at, "choices are not imported: write out what holds");
    }

    void add_conditions(const Value& list) {
        for (const Value& condition : scalars(list))
            conditions_.push_back(condition);
    }

    /// What Macaulay2 alone has.
    bool call(const std::string& name, Value& result) {
        if (name == "ideal") {
            result = argument();
            if (!result.is_list) result = Value::list({result});
            result.is_ideal = true;
        } else if (name == "matrix" || name == "flatten" || name == "toList" ||
                   name == "numerator" || numerators_.contains(name)) {
            result = argument();
        } else if (name == "apply" || name == "saturate") {
            const model::Position at = tokens_.here().at;
            tokens_.expect("(");
            result = expressions_.read();
            tokens_.expect(",");
            if (name == "saturate")
                add_conditions(expressions_.read());
            else if (!numerators_.contains(tokens_.name("the name of a function")))
                throw ModelError(at, "only functions f -> numerator promote(f, F) are imported");
            tokens_.expect(")");
        } else {
            return false;
        }
        return true;
    }

    /// Of a function: with or without brackets.
    Value argument() {
        if (!tokens_.is("(")) return expressions_.argument();
        tokens_.take();
        const std::vector<Value> items = expressions_.list(")");
        return items.size() == 1 ? items[0] : Value::list(items);
    }

    Tokens tokens_;
    Expressions expressions_;
    std::map<std::string, Ring> rings_;
    Ring ring_; // the last one with variables
    std::set<std::string> numerators_;
    Value ideal_;
    bool has_ideal_ = false;
    std::vector<Value> conditions_;
};

} // namespace

std::string from_macaulay2(std::string_view program, const std::string& source) {
    return Reader(program).run().text(source + ", a program for Macaulay2");
}

} // namespace plprove::importers
