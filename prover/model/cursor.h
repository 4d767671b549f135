// A place among the words of a line, for readers.
#pragma once

#include "prover/model/words.h"
#include "prover/system/words.h"

#include <string>

namespace plprove::model {

class Cursor {
public:
    explicit Cursor(const Line& line) : line_(&line) {}

    bool at_end() const { return place_ == line_->words.size(); }
    /// The word here, empty at the end of the line.
    std::string word() const { return at_end() ? std::string{} : line_->words[place_].text; }
    Position at() const { return at_end() ? line_->end : line_->words[place_].at; }
    bool is(std::string_view expected) const { return !at_end() && word() == expected; }

    /// The word here, and goes on.
    std::string take() {
        std::string taken = word();
        ++place_;
        return taken;
    }

    /// Goes on if this word is here.
    bool skip(std::string_view expected) {
        if (!is(expected)) return false;
        ++place_;
        return true;
    }

    /// Throws ModelError unless this word is here; goes on.
    void expect(const std::string& expected) {
        if (!skip(expected)) fail("'" + expected + "'");
    }

    /// An integer from `least` to `most`; throws ModelError if it is not here.
    int integer(int least, int most) {
        const int value = is_constant(word()) ? std::stoi(word()) : -1;
        if (value < least || value > most)
            fail("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        ++place_;
        return value;
    }

    [[noreturn]] void fail(const std::string& expected, const std::string& advice = "") const {
        const std::string found = at_end() ? "the end of the line" : in_quotes(word());
        throw ModelError(at(), "expected " + expected + ", found " + found + advice);
    }

private:
    const Line* line_;
    std::size_t place_ = 0;
};

} // namespace plprove::model
