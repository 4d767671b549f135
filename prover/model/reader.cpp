// Reading the statements of a model.
#include "prover/model/model.h"
#include "prover/model/read_expression.h"
#include "prover/system/words.h"

#include <algorithm>
#include <sstream>

namespace plprove::model {

namespace {

using Kind = Statement::Kind;

class Reader {
public:
    explicit Reader(std::vector<Line> lines) : lines_(std::move(lines)) {}

    Model run() {
        Model model;
        if (lines_.empty())
            throw ModelError({},
                             "expected 'model' and a name, found nothing: begin with a line such "
                             "as 'model p3p'");
        model.name = read_heading();
        if (next_ < lines_.size() && lines_[next_].words.front().text == "claimed") {
            Cursor cursor(lines_[next_++]);
            cursor.take();
            model.claimed = cursor.integer(1, 999'999);
            end(cursor);
        }
        while (next_ < lines_.size())
            model.statements.push_back(statement());
        if (model.statements.empty())
            throw ModelError(lines_.back().end, "expected a statement, such as 'data x', found the "
                                                "end of the text");
        for (const Line& line : lines_)
            model.lines.push_back(words_of(line));
        return model;
    }

private:
    static std::string words_of(const Line& line) {
        std::string text;
        for (const Word& word : line.words)
            text += (text.empty() ? "" : " ") + word.text;
        return text;
    }

    std::string read_heading() {
        Cursor cursor(lines_[next_++]);
        cursor.expect("model");
        if (!is_name(cursor.word())) cursor.fail("the name of the model");
        std::string name = cursor.take();
        end(cursor);
        return name;
    }

    static void end(const Cursor& cursor) {
        if (!cursor.at_end()) cursor.fail("the end of the line");
    }

    Statement statement() {
        Cursor cursor(lines_[next_++]);
        Statement result;
        result.at = cursor.at();
        const std::string word = cursor.take();
        if (word == "data" || word == "unknown")
            read_variables(result, word == "data" ? Kind::data : Kind::unknown, cursor);
        else if (word == "let")
            read_let(result, cursor);
        else if (word == "equation" || word == "relation")
            read_equation(result, word == "equation", cursor);
        else if (word == "nonzero" || word == "count")
            read_list(result, word == "nonzero" ? Kind::nonzero : Kind::count, cursor);
        else if (word == "for")
            read_loop(result, cursor);
        else
            fail_on_statement(word, result.at);
        return result;
    }

    [[noreturn]] static void fail_on_statement(const std::string& word, Position at) {
        std::string advice = did_you_mean(word, statement_words());
        if (word == "end") advice = ": no loop is open";
        throw ModelError(at,
                         "expected data, unknown, let, equation, relation, nonzero, count or for, "
                         "found " +
                             in_quotes(word) + advice);
    }

    void read_variables(Statement& result, Kind kind, Cursor& cursor) {
        result.kind = kind;
        if (loops_ > 0)
            throw ModelError(result.at,
                             "data and unknowns stand outside of loops: give a list, such "
                             "as x[1..5]");
        do
            result.variables.push_back(read_variable(cursor));
        while (cursor.skip(","));
        end(cursor);
    }

    Variable read_variable(Cursor& cursor) {
        Variable variable;
        variable.at = cursor.at();
        variable.name = cursor.take();
        names_.all.add(variable.name, variable.at);
        while (cursor.skip("[")) {
            cursor.expect("1");
            cursor.expect("..");
            variable.shape.push_back(cursor.integer(1, largest_size));
            cursor.expect("]");
        }
        if (!cursor.skip(":")) return variable;
        const bool matrix = cursor.is("matrix");
        if (!matrix && !cursor.is("vector")) cursor.fail("vector or matrix");
        cursor.take();
        variable.shape.push_back(cursor.integer(1, largest_size));
        if (matrix) {
            cursor.expect("by");
            variable.shape.push_back(cursor.integer(1, largest_size));
        }
        return variable;
    }

    void read_let(Statement& result, Cursor& cursor) {
        result.kind = Kind::let;
        const Position at = cursor.at();
        result.name = cursor.take();
        cursor.expect("=");
        result.expressions.push_back(read_sum(cursor, names_));
        names_.all.add(result.name, at);
        end_of_sum(cursor);
    }

    void read_equation(Statement& result, bool equation, Cursor& cursor) {
        result.expressions.push_back(read_sum(cursor, names_));
        const bool proportional = equation && cursor.is("~");
        if (!proportional && !cursor.is("="))
            cursor.fail(equation ? "an operator, '=' or '~'" : "an operator or '='");
        cursor.take();
        result.expressions.push_back(read_sum(cursor, names_));
        result.kind = proportional ? Kind::proportional
                      : equation   ? Kind::equation
                                   : Kind::relation;
        end_of_sum(cursor);
    }

    void read_list(Statement& result, Kind kind, Cursor& cursor) {
        result.kind = kind;
        do
            result.expressions.push_back(read_sum(cursor, names_));
        while (cursor.skip(","));
        end_of_sum(cursor);
    }

    static void end_of_sum(const Cursor& cursor) {
        if (!cursor.at_end()) cursor.fail("an operator or the end of the line");
    }

    void read_loop(Statement& result, Cursor& cursor) {
        result.kind = Kind::loop;
        const Position at = cursor.at();
        result.name = cursor.take();
        cursor.expect("in");
        result.first = read_index(cursor, names_);
        cursor.expect("..");
        result.last = read_index(cursor, names_);
        end(cursor);
        const std::size_t kept = names_.all.size();
        names_.all.add(result.name, at);
        names_.loops.add(result.name, at);
        ++loops_;
        if (loops_ > deepest_loop)
            throw ModelError(result.at, "at most 20 loops stand in each other");
        while (next_ < lines_.size() && lines_[next_].words.front().text != "end")
            result.body.push_back(statement());
        if (next_ == lines_.size())
            throw ModelError(lines_.back().end, "expected 'end' of the loop in line " +
                                                    std::to_string(result.at.line) +
                                                    ", found the end of the text");
        Cursor last(lines_[next_++]);
        last.take();
        end(last);
        --loops_;
        names_.loops.forget(names_.loops.size() - 1);
        names_.all.forget(kept);
    }

    static constexpr int largest_size = 100;
    static constexpr int deepest_loop = 20;

    std::vector<Line> lines_;
    std::size_t next_ = 0;
    Names names_;
    int loops_ = 0;
};

} // namespace

Model read_model(std::string_view text) {
    return Reader(lines_of(text)).run();
}

std::vector<std::string> opening_comments(const std::string& text) {
    std::vector<std::string> comments;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && line.starts_with('#');)
        if (!has_control_character(line))
            comments.push_back(line.substr(std::min(line.find_first_not_of("# "), line.size())));
    return comments;
}

} // namespace plprove::model
