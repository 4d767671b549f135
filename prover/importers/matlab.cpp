#include "prover/importers/importers.h"
#include "prover/importers/matlab_expressions.h"
#include "prover/system/words.h"

#include <set>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;
using Kind = Token::Kind;

class MatlabReader {
public:
    explicit MatlabReader(std::string_view program)
        : tokens_(tokens_of(program, Language::matlab)), symbols_(draft_),
          expressions_(tokens_, symbols_, draft_) {}

    Draft run() {
        while (!tokens_.is(Kind::end) && !ends_program())
            statement();
        const Array equations = result();
        for (const Value& equation : equations.entries)
            if (!equation.is("0")) draft_.equations.push_back(equation);
        symbols_.declare();
        return std::move(draft_);
    }

private:
    /// At the end of the first function, or of the script: functions behind it are not called.
    bool ends_program() const {
        const bool has_begun = has_header_ || !expressions_.values.empty();
        return tokens_.is_word("end") || (has_begun && tokens_.is_word("function"));
    }

    /// The value of the first output, or of `eqs` or `eq`.
    Array result() {
        for (const std::string& name :
             has_header_ ? std::vector{output_} : std::vector<std::string>{"eqs", "eq"}) {
            const auto found = expressions_.values.find(name);
            if (found != expressions_.values.end()) return found->second;
            const auto failed = expressions_.failures.find(name);
            if (failed != expressions_.failures.end()) throw failed->second;
        }
        tokens_.fail("equations, such as 'eqs = [f; g]'");
    }

    /// A statement; it is taken with what ends it.
    void statement() {
        constexpr int most = 20'000;
        if (++steps_ > most)
            throw ModelError(
                tokens_.here().at,
                "the program takes more than 20,000 statements: state a smaller problem");
        const Position at = tokens_.here().at;
        if (tokens_.is_word("function")) return header();
        if (tokens_.is_word("for")) return loop();
        if (tokens_.is_word("if")) return branches();
        if (tokens_.is_word("syms")) return symbols();
        for (const char* word : {"while", "switch", "try", "parfor", "break", "continue", "return",
                                 "eval", "load", "assignin"})
            if (tokens_.is_word(word))
                throw ModelError(at, "found '" + std::string(word) +
                                         "', which is not imported: write out what it does");
        if (assigns()) assignment();
        end_statement();
    }

    /// Whatever else a statement says, such as commands, says nothing of the equations.
    void end_statement() {
        int open = 0;
        while (open > 0 || !(tokens_.at_end_of_statement() || tokens_.is(","))) {
            if (tokens_.is("(") || tokens_.is("[") || tokens_.is("{")) ++open;
            if (tokens_.is(")") || tokens_.is("]") || tokens_.is("}")) --open;
            tokens_.take();
        }
        tokens_.take();
    }

    /// function [eqs, data0] = problem(data0)
    void header() {
        tokens_.take();
        has_header_ = true;
        tokens_.skip("[");
        output_ = tokens_.name("the name of an output");
        while (!tokens_.at_end_of_statement() && !tokens_.is("("))
            tokens_.take();
        while (!tokens_.at_end_of_statement() && !tokens_.is(")")) {
            const Token argument = tokens_.take();
            if (argument.kind != Kind::name) continue;
            fail(argument.word, ModelError(argument.at, "the argument " + in_quotes(argument.word) +
                                                            " has no value: give it random numbers "
                                                            "in 'if nargin < 1'"));
        }
        end_statement();
    }

    /// syms x y real
    void symbols() {
        static const std::set<std::string> kinds{"real", "positive", "integer", "rational",
                                                 "complex"};
        tokens_.take();
        while (tokens_.is(Kind::name)) {
            const Token name = tokens_.take();
            if (kinds.contains(name.word)) continue;
            set(name.word, Array::scalar(symbols_.symbol(name.word, name.at)));
        }
        if (!tokens_.at_end_of_statement()) tokens_.fail("the name of a symbol");
        end_statement();
    }

    /// Whether `=` comes after names and brackets: x =, x(..) =, x.y =, [x, y] =.
    bool assigns() {
        const std::size_t place = tokens_.place();
        int open = 0;
        while (open > 0 || tokens_.is(Kind::name) || tokens_.is(".") || tokens_.is("(") ||
               tokens_.is("[") || tokens_.is("{")) {
            if (tokens_.is("(") || tokens_.is("[") || tokens_.is("{")) ++open;
            if (tokens_.is(")") || tokens_.is("]") || tokens_.is("}")) --open;
            tokens_.take();
        }
        const bool result = tokens_.is("=") && tokens_.place() != place;
        tokens_.go_to(place);
        return result;
    }

    /// What an assignment that is not understood gives has no value, and is refused where it is
    /// used: programs of generators also say what is no equation.
    void assignment() {
        const std::size_t place = tokens_.place();
        if (tokens_.skip("[")) {
            const Position at = tokens_.here().at;
            for (; !tokens_.is("="); tokens_.take())
                if (tokens_.is(Kind::name))
                    fail(tokens_.here().word,
                         ModelError(at, "functions with several values are not imported: write "
                                        "out what this one does"));
            return;
        }
        const std::string name = tokens_.name();
        if (name == "unknown" || name == "unknowns") return unknowns();
        try {
            assign(name);
            if (!tokens_.at_end_of_statement() && !tokens_.is(","))
                tokens_.fail("an operator or the end of the statement");
        } catch (const ModelError& error) {
            fail(name, error);
            tokens_.go_to(place);
        }
    }

    void assign(const std::string& name) {
        if (tokens_.skip("=")) return set(name, named(name, expressions_.read(name)));
        if (!tokens_.is("(")) tokens_.fail("'='");
        const Position at = tokens_.here().at;
        if (const auto failed = expressions_.failures.find(name);
            failed != expressions_.failures.end())
            throw failed->second;
        Array array = expressions_.values[name];
        const std::vector<Index> indices = expressions_.indices(array);
        tokens_.expect("=");
        importers::assign(array, indices, expressions_.read(name), at);
        set(name, named(name, array));
    }

    /// unknown = {'x' 'y'}
    void unknowns() {
        const Position at = tokens_.here().at;
        tokens_.expect("=");
        tokens_.expect("{");
        std::vector<std::string> names;
        while (!tokens_.skip("}")) {
            tokens_.skip(",");
            if (!tokens_.is(Kind::text)) tokens_.fail("the name of a symbol in quotes");
            const std::string text = tokens_.take().word;
            names.push_back(text.substr(1, text.size() - 2));
        }
        symbols_.set_unknowns(names, at);
    }

    void set(const std::string& name, Array value) {
        expressions_.failures.erase(name);
        expressions_.values[name] = std::move(value);
    }

    void fail(const std::string& name, const ModelError& error) {
        expressions_.values.erase(name);
        expressions_.failures.insert_or_assign(name, error);
    }

    /// The array with names for all entries that are no atoms or integers.
    Array named(const std::string& name, Array array) {
        constexpr std::size_t longest = std::size_t{1} << 22U;
        for (std::size_t k = 0; k < array.size(); ++k) {
            Value& entry = array.entries[k];
            if (integer_of(entry) || entry.level == Value::Level::atom) continue;
            written_ += entry.text.size();
            if (written_ > longest)
                throw ModelError(tokens_.here().at,
                                 "this is too long for a model: state a smaller problem");
            const std::string i = std::to_string(array.is_vector() ? k + 1 : k % array.rows + 1);
            const std::string j = array.is_vector() ? "" : "_" + std::to_string(k / array.rows + 1);
            entry = draft_.named(array.is_scalar() ? name : name + "_" + i + j, entry);
        }
        return array;
    }

    /// for i = 1:5 ... end: once for each column.
    void loop() {
        tokens_.take();
        const bool bracket = tokens_.skip("(");
        const std::string name = tokens_.name("the variable of the loop");
        tokens_.expect("=");
        const Array range = named(name, expressions_.read(name));
        if (bracket) tokens_.expect(")");
        if (!tokens_.skip(",") && !tokens_.at_end_of_statement())
            tokens_.fail("the end of the statement");
        const std::size_t body = tokens_.place();
        for (std::size_t j = 0; j < range.columns; ++j) {
            tokens_.go_to(body);
            const auto first = range.entries.begin() + static_cast<std::ptrdiff_t>(j * range.rows);
            set(name, {range.rows, 1, {first, first + static_cast<std::ptrdiff_t>(range.rows)}});
            block();
        }
        tokens_.go_to(body);
        skip_block();
        if (!tokens_.is_word("end")) tokens_.fail("the end of the loop");
        tokens_.take();
    }

    /// if ... elseif ... else ... end: the first one that holds. Here, no arguments are given, and
    /// one output is asked.
    void branches() {
        bool done = false, holds = true;
        do {
            const bool last = tokens_.take().word == "else";
            holds = !done && (last || expressions_.condition());
            if (holds)
                block();
            else
                skip_block();
            done = done || holds;
        } while (tokens_.is_word("elseif") || tokens_.is_word("else"));
        if (!tokens_.is_word("end")) tokens_.fail("the end of 'if'");
        tokens_.take();
    }

    bool ends_block() const {
        return tokens_.is_word("end") || tokens_.is_word("else") || tokens_.is_word("elseif") ||
               tokens_.is(Kind::end);
    }

    void block() {
        constexpr int deepest = 50;
        if (++depth_ > deepest)
            throw ModelError(tokens_.here().at, "more than 50 loops are in each other");
        while (!ends_block())
            statement();
        --depth_;
    }

    void skip_block() {
        static const std::set<std::string> openers{"if", "for", "while", "switch", "try", "parfor"};
        int blocks = 0, open = 0;
        while (!tokens_.is(Kind::end) && (blocks > 0 || open > 0 || !ends_block())) {
            if (tokens_.is("(") || tokens_.is("[") || tokens_.is("{")) ++open;
            if (tokens_.is(")") || tokens_.is("]") || tokens_.is("}")) --open;
            if (open == 0 && tokens_.is(Kind::name)) {
                if (openers.contains(tokens_.here().word)) ++blocks;
                if (tokens_.is_word("end")) --blocks;
            }
            tokens_.take();
        }
    }

    Tokens tokens_;
    Draft draft_;
    MatlabSymbols symbols_;
    MatlabExpressions expressions_;
    std::string output_; // of the function
    bool has_header_ = false;
    std::size_t written_ = 0; // bytes of values with names
    int steps_ = 0, depth_ = 0;
};

} // namespace

std::string from_matlab(std::string_view program, const std::string& source) {
    return MatlabReader(program).run().text(source + ", a program for Matlab");
}

} // namespace plprove::importers
