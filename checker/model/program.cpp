#include "checker/model/program.h"

#include <optional>
#include <set>

namespace checker {
static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_name(std::string_view word) {
    return !word.empty() && word.size() <= 40 && is_letter(word[0]) &&
           std::ranges::all_of(word,
                               [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

/// Words that are no names of values.
static bool is_reserved(std::string_view word) {
    static const std::set<std::string_view> reserved{
        "model", "claimed", "data",      "unknown", "let",  "equation", "relation", "nonzero",
        "count", "for",     "in",        "end",     "by",   "vector",   "matrix",   "dot",
        "cross", "det",     "transpose", "trace",   "skew", "norm2",    "identity", "rotation"};
    return reserved.contains(word);
}

namespace {
using Kind = Expression::Kind;

/// Takes a model word by word, and keeps its lines.
class Parser {
public:
    explicit Parser(Reader& reader) : reader_(reader) {}

    Program program() {
        Program result;
        take("model");
        result.name = name();
        end_line();
        if (reader_.comes("claimed")) {
            take("claimed");
            result.claimed = static_cast<std::size_t>(integer(1, 999'999));
            end_line();
        }
        result.statements = statements(false);
        if (result.statements.empty()) reader_.fail(reader_.word(), "a statement of a model");
        result.text = std::move(text_);
        return result;
    }

private:
    std::string word() {
        const std::string found(reader_.word());
        if (!text_.empty() && text_.back() != '\n') text_ += ' ';
        text_ += found;
        return found;
    }

    void take(std::string_view expected) {
        if (const std::string found = word(); found != expected)
            reader_.fail(found, say('`', expected, '`'));
    }

    /// Whether this is the next word; then it is taken.
    bool taken(std::string_view expected) {
        const bool comes = reader_.comes(expected);
        if (comes) word();
        return comes;
    }

    void end_line() {
        reader_.end_line();
        text_ += '\n';
    }

    int integer(int low, int high) {
        const int found = reader_.small_integer(low, high);
        if (!text_.empty() && text_.back() != '\n') text_ += ' ';
        text_ += std::to_string(found);
        return found;
    }

    std::size_t size() { return static_cast<std::size_t>(integer(1, 100)); }

    std::string name() {
        const std::string found = word();
        if (!is_name(found) || is_reserved(found)) reader_.fail(found, "a name");
        return found;
    }

    /// Data and unknowns stand outside of loops.
    std::vector<Statement> statements(bool in_loop) {
        std::vector<Statement> all;
        while (true) {
            if (!in_loop && reader_.comes("data"))
                declare(all, Statement::Kind::data);
            else if (!in_loop && reader_.comes("unknown"))
                declare(all, Statement::Kind::unknown);
            else if (std::optional<Statement> next = statement())
                all.push_back(std::move(*next));
            else
                return all;
        }
    }

    void declare(std::vector<Statement>& all, Statement::Kind kind) {
        const std::size_t line = reader_.line();
        word();
        do {
            Statement next{.kind = kind, .line = line, .name = name()};
            while (taken("[")) {
                take("1");
                take("..");
                next.shape.push_back(size());
                take("]");
            }
            if (taken(":")) {
                const bool is_matrix = reader_.comes("matrix");
                take(is_matrix ? "matrix" : "vector");
                next.shape.push_back(size());
                if (is_matrix) {
                    take("by");
                    next.shape.push_back(size());
                }
            }
            all.push_back(std::move(next));
        } while (taken(","));
        end_line();
    }

    /// The next statement but `data` and `unknown`; none if no such comes.
    std::optional<Statement> statement() {
        Statement next{.line = reader_.line()};
        if (taken("let")) {
            next.name = name();
            take("=");
            next.parts.push_back(sum());
        } else if (taken("equation")) {
            next.parts.push_back(sum());
            next.kind = reader_.comes("~") ? Statement::Kind::proportional : Statement::Kind::equal;
            take(reader_.comes("~") ? "~" : "=");
            next.parts.push_back(sum());
        } else if (taken("relation")) {
            next.kind = Statement::Kind::relation;
            next.parts.push_back(sum());
            take("=");
            next.parts.push_back(sum());
        } else if (reader_.comes("nonzero") || reader_.comes("count")) {
            next.kind = word() == "count" ? Statement::Kind::count : Statement::Kind::nonzero;
            next.parts = sums();
        } else if (taken("for")) {
            loop(next);
        } else {
            return std::nullopt;
        }
        end_line();
        return next;
    }

    void loop(Statement& next) {
        next.kind = Statement::Kind::loop;
        next.name = name();
        take("in");
        next.parts.push_back(index());
        take("..");
        next.parts.push_back(index());
        end_line();
        const Depth depth(*this);
        next.body = statements(true);
        take("end");
    }

    std::vector<Expression> sums() {
        std::vector<Expression> all{sum()};
        while (taken(","))
            all.push_back(sum());
        return all;
    }

    Expression sum() {
        const Depth depth(*this);
        const bool negative = taken("-");
        Expression all{.kind = Kind::sum};
        all.parts.push_back(negative ? with(Kind::minus, product()) : product());
        while (reader_.comes("+") || reader_.comes("-")) {
            const bool minus = word() == "-";
            all.parts.push_back(minus ? with(Kind::minus, product()) : product());
        }
        return alone(std::move(all));
    }

    Expression product() {
        Expression all = with(Kind::product, power());
        while (reader_.comes("*") || reader_.comes("/")) {
            const bool over = word() == "/";
            all.parts.push_back(over ? with(Kind::over, power()) : power());
        }
        return alone(std::move(all));
    }

    Expression power() {
        Expression base = atom();
        if (!taken("^")) return base;
        Expression result = with(Kind::power, std::move(base));
        result.number = integer(1, 20);
        return result;
    }

    Expression atom() {
        Expression found = with(Kind::item, simple_atom());
        while (taken("[")) {
            found.parts.push_back(index());
            take("]");
        }
        return alone(std::move(found));
    }

    Expression simple_atom() {
        if (taken("(")) {
            Expression inner = sum();
            take(")");
            return inner;
        }
        if (taken("[")) {
            Expression list{.kind = Kind::list, .parts = sums()};
            take("]");
            return list;
        }
        Expression found = constant_or_name();
        if (found.kind != Kind::name || !taken("(")) return found;
        found.kind = Kind::call;
        found.parts = sums();
        take(")");
        return found;
    }

    Expression constant_or_name() {
        if (reader_.comes_digit()) return {.number = integer(0, 999'999)};
        const std::string found = word();
        const bool is_function = is_reserved(found) && reader_.comes("(");
        if (!is_name(found) || (is_reserved(found) && !is_function))
            reader_.fail(found, "a constant, a name, `(` or `[`");
        return {.kind = Kind::name, .name = found};
    }

    Expression index() {
        Expression all = with(Kind::sum, constant_or_name());
        while (reader_.comes("+") || reader_.comes("-")) {
            const bool minus = word() == "-";
            all.parts.push_back(minus ? with(Kind::minus, constant_or_name()) : constant_or_name());
        }
        return alone(std::move(all));
    }

    static Expression with(Kind kind, Expression part) {
        Expression result{.kind = kind};
        result.parts.push_back(std::move(part));
        return result;
    }

    /// The only part, if it stands for itself.
    static Expression alone(Expression all) {
        if (all.parts.size() > 1 || all.parts[0].kind == Kind::minus) return all;
        Expression part = std::move(all.parts[0]);
        return part;
    }

    /// One more level of brackets or loops while it lives: a limit for the machine's stack.
    struct Depth {
        explicit Depth(Parser& parser) : depth(parser.depth_) {
            if (++depth > 100) parser.reader_.fail("more", "at most 100 brackets in each other");
        }
        ~Depth() { --depth; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        int& depth;
    };

    Reader& reader_;
    std::string text_{};
    int depth_ = 0;
};
} // namespace

Program read_program(Reader& reader) {
    return Parser(reader).program();
}

/// The length of the word at the start of a text that begins with no blank.
static std::size_t word_length(std::string_view text) {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
    if (text.starts_with("..")) return 2;
    const auto end = std::find_if_not(text.begin(), text.end(), is_part);
    return std::max<std::size_t>(1, static_cast<std::size_t>(end - text.begin()));
}

std::string lines_of_model(std::string_view text) {
    std::string lines;
    int open = 0; // brackets
    while (!text.empty()) {
        if (text[0] == '#') text.remove_prefix(std::min(text.find('\n'), text.size()));
        const std::size_t length = text.empty() ? 0 : word_length(text);
        const std::string_view word = text.substr(0, length);
        text.remove_prefix(length);
        const bool in_line = !lines.empty() && lines.back() != '\n';
        if (word == "\n") {
            if (in_line && open == 0) lines += '\n';
        } else if (word != " " && word != "\t" && word != "\r" && !word.empty()) {
            if (in_line) lines += ' ';
            lines += word;
            open += (word == "(" || word == "[") - (word == ")" || word == "]");
        }
    }
    return !lines.empty() && lines.back() != '\n' ? lines + '\n' : lines;
}
} // namespace checker
