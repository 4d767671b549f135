#include "prover/model/words.h"

#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_of_name(char c) {
    return is_letter(c) || is_digit(c) || c == '_';
}

/// Goes through the text, a word at a time.
class Splitter {
public:
    explicit Splitter(std::string_view text) : text_(text) {}

    std::vector<Line> run() {
        while (place_ < text_.size())
            step();
        end_line();
        return std::move(lines_);
    }

private:
    void step() {
        const char c = text_[place_];
        if (c == '\n') {
            if (open_ == 0) end_line();
            ++place_;
            at_ = {at_.line + 1, 1};
        } else if (c == ' ' || c == '\t' || c == '\r') {
            advance(1);
        } else if (c == '#') {
            advance(std::min(text_.find('\n', place_), text_.size()) - place_);
        } else {
            add_word(length_of_word());
        }
    }

    /// How long the word is that begins here.
    std::size_t length_of_word() const {
        const char c = text_[place_];
        if (is_letter(c)) return length_while(is_of_name);
        if (is_digit(c)) return length_while(is_digit);
        if (text_.substr(place_, 2) == "..") return 2;
        if (std::string_view("=~,:[]()+-*/^").find(c) != std::string_view::npos) return 1;
        std::string message = "found the character ";
        message +=
            c >= ' ' && c <= '~' ? in_quotes(std::string_view(&c, 1)) : "of another alphabet";
        throw ModelError(at_, message + ", which no word has: write names, whole numbers and "
                                        "= ~ , : [ ] ( ) + - * / ^ .. only");
    }

    std::size_t length_while(bool (*accepted)(char)) const {
        std::size_t end = place_;
        while (end < text_.size() && accepted(text_[end]))
            ++end;
        return end - place_;
    }

    void add_word(std::size_t length) {
        std::string word(text_.substr(place_, length));
        if (word == "(" || word == "[") ++open_;
        if ((word == ")" || word == "]") && open_ > 0) --open_;
        words_.push_back({std::move(word), at_});
        advance(length);
    }

    void advance(std::size_t characters) {
        place_ += characters;
        at_.column += static_cast<int>(characters);
    }

    void end_line() {
        if (!words_.empty()) lines_.push_back({std::move(words_), at_});
        words_.clear();
        open_ = 0;
    }

    std::string_view text_;
    std::size_t place_ = 0;
    Position at_;
    int open_ = 0; // brackets
    std::vector<Word> words_;
    std::vector<Line> lines_;
};

} // namespace

std::vector<Line> lines_of(std::string_view text) {
    if (text.size() > largest_text)
        throw BadInput("a model has at most " + std::to_string(largest_text) +
                       " bytes: state a smaller problem");
    return Splitter(text).run();
}

bool is_name(const std::string& word) {
    constexpr std::size_t longest = 40;
    return !word.empty() && is_letter(word.front()) && word.size() <= longest &&
           std::ranges::all_of(word, is_of_name);
}

bool is_constant(const std::string& word) {
    constexpr std::size_t longest = 6;
    return !word.empty() && word.size() <= longest && std::ranges::all_of(word, is_digit) &&
           (word == "0" || word.front() != '0');
}

} // namespace plprove::model
