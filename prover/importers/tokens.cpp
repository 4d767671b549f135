#include "prover/importers/tokens.h"

#include "prover/system/words.h"

#include <algorithm>
#include <array>

namespace plprove::importers {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Letters of other alphabets, too: their bytes are beyond ASCII.
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 128;
}

/// How comments begin and end.
struct Comment {
    std::string_view opens, closes, line;
};

Comment comment_in(Language language) {
    if (language == Language::julia) return {"#=", "=#", "#"};
    if (language == Language::matlab) return {"%{", "%}", "%"};
    return {"-*", "*-", "--"};
}

class Tokenizer {
public:
    Tokenizer(std::string_view text, Language language)
        : text_(text), language_(language), comment_(comment_in(language)) {}

    std::vector<Token> run() {
        while (place_ < text_.size())
            step();
        if (!open_.empty()) throw model::ModelError(open_.back().at, "this bracket is not closed");
        add(Token::Kind::new_line, 0);
        add(Token::Kind::end, 0);
        return std::move(tokens_);
    }

private:
    bool begins(std::string_view word) const { return text_.substr(place_).starts_with(word); }

    void step() {
        const char c = text_[place_];
        const bool julia = language_ == Language::julia, matlab = language_ == Language::matlab;
        if (c == '\n') {
            if (open_.empty() || (julia && open_.back().bracket == '[') ||
                (matlab && open_.back().bracket != '('))
                add(Token::Kind::new_line, 0);
            advance(1);
            spaced_ = true;
        } else if (c == ' ' || c == '\t' || c == '\r') {
            advance(1);
            spaced_ = true;
        } else if (begins_block_of_comment()) {
            skip_to(comment_.closes);
        } else if (begins(comment_.line)) {
            skip_line();
        } else if (matlab && begins("...")) { // the line goes on
            skip_line();
            advance(place_ < text_.size() ? 1 : 0);
            spaced_ = true;
        } else if (c == '"' || (matlab && c == '\'' && !is_after_value())) {
            const std::size_t end = text_.find(c, place_ + 1);
            if (end == std::string_view::npos)
                throw model::ModelError(at_, "this text in quotes does not end");
            add(Token::Kind::text, end + 1 - place_);
        } else if (is_digit(c) || (c == '.' && is_digit(next()))) {
            add(Token::Kind::number, number_length());
        } else if (is_letter(c) || (julia && c == '_')) {
            add(Token::Kind::name, name_length());
        } else {
            add_symbol();
        }
    }

    char next() const { return place_ + 1 < text_.size() ? text_[place_ + 1] : '\0'; }

    /// In Matlab, only a line of its own begins one.
    bool begins_block_of_comment() const {
        if (!begins(comment_.opens)) return false;
        const std::size_t rest = text_.find_first_not_of(" \t\r", place_ + comment_.opens.size());
        return language_ != Language::matlab ||
               (rest != std::string_view::npos && text_[rest] == '\n');
    }

    /// Where a quote is a transpose in Matlab, and no text begins.
    bool is_after_value() const {
        if (tokens_.empty() || spaced_) return false;
        const Token& last = tokens_.back();
        return last.kind == Token::Kind::name || last.kind == Token::Kind::number ||
               last.word == ")" || last.word == "]" || last.word == "}" || last.word == "'" ||
               last.word == ".'";
    }

    void skip_line() { advance(std::min(text_.find('\n', place_), text_.size()) - place_); }

    void skip_to(std::string_view end) {
        const std::size_t found = text_.find(end, place_ + 2);
        if (found == std::string_view::npos)
            throw model::ModelError(at_, "this comment does not end");
        advance(found + end.size() - place_);
        spaced_ = true;
    }

    /// Digits, a fraction and an exponent; but 1..5 is a range.
    std::size_t number_length() const {
        std::size_t end = place_;
        const auto digits = [&] {
            while (end < text_.size() && is_digit(text_[end]))
                ++end;
        };
        digits();
        const auto at = [&](std::size_t i) { return i < text_.size() ? text_[i] : '\0'; };
        if (at(end) == '.' && (is_digit(at(end + 1)) || end == place_)) {
            ++end;
            digits();
        }
        if (at(end) == 'e' || at(end) == 'E') {
            const std::size_t sign = at(end + 1) == '-' || at(end + 1) == '+' ? 1 : 0;
            if (is_digit(at(end + 1 + sign))) {
                end += 1 + sign;
                digits();
            }
        }
        return end - place_;
    }

    std::size_t name_length() const {
        std::size_t end = place_;
        const auto is_of_name = [&](char c) {
            return is_letter(c) || is_digit(c) ||
                   (language_ == Language::macaulay2
                        ? c == '\''
                        : c == '_' || (c == '!' && language_ == Language::julia));
        };
        while (end < text_.size() && is_of_name(text_[end]))
            ++end;
        return end - place_;
    }

    void add_symbol() {
        static constexpr std::array<std::string_view, 19> longer{
            "...", "..", "->", "=>", "==", ":=", "//", "<<", "<-", ".*",
            ".^",  "./", ".'", "!=", "~=", "<=", ">=", "&&", "||"};
        for (const std::string_view symbol : longer)
            if (begins(symbol)) return add(Token::Kind::symbol, symbol.size());
        const char c = text_[place_];
        if (std::string_view("([{").find(c) != std::string_view::npos) open_.push_back({at_, c});
        if (const std::size_t kind = std::string_view(")]}").find(c);
            kind != std::string_view::npos) {
            if (open_.empty() || open_.back().bracket != "([{"[kind])
                throw model::ModelError(at_, std::string("found '") + c +
                                                 "' without the bracket that it closes");
            open_.pop_back();
        }
        add(Token::Kind::symbol, 1);
    }

    void add(Token::Kind kind, std::size_t length) {
        tokens_.push_back({kind, std::string(text_.substr(place_, length)), at_, spaced_});
        spaced_ = false;
        advance(length);
    }

    void advance(std::size_t length) {
        for (std::size_t i = 0; i < length; ++i) {
            if (text_[place_ + i] == '\n')
                at_ = {at_.line + 1, 1};
            else
                ++at_.column;
        }
        place_ += length;
    }

    struct Bracket {
        model::Position at;
        char bracket;
    };

    std::string_view text_;
    Language language_;
    Comment comment_;
    std::size_t place_ = 0;
    model::Position at_;
    bool spaced_ = false;
    std::vector<Bracket> open_;
    std::vector<Token> tokens_;
};

} // namespace

std::vector<Token> tokens_of(std::string_view program, Language language) {
    if (program.size() > model::largest_text)
        throw BadInput("a program to import has at most " + std::to_string(model::largest_text) +
                       " bytes: state a smaller problem");
    return Tokenizer(program, language).run();
}

} // namespace plprove::importers
