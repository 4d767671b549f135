// The words of the text of a model (certs/FORMAT.md, section 16), and where they stand.
#pragma once

#include "prover/system/exit.h"

#include <string>
#include <string_view>
#include <vector>

namespace plprove::model {

/// Where a word begins in a text; lines and columns count from 1.
struct Position {
    int line = 1;
    int column = 1;
};

/// A model is not well-formed. The message says where, what was found and what is expected.
class ModelError : public BadInput {
public:
    ModelError(Position at, const std::string& message)
        : BadInput("line " + std::to_string(at.line) + ", column " + std::to_string(at.column) +
                   ": " + message) {}
};

struct Word {
    std::string text;
    Position at;
};

/// A line of a model: its words, and where it ends.
struct Line {
    std::vector<Word> words;
    Position end;
};

/// The largest text that is read, in bytes.
inline constexpr std::size_t largest_text = std::size_t{1} << 20U;

/// The lines that have words. A line goes on as long as a bracket is open; `#` begins a comment.
/// Throws ModelError for a character that no word has.
std::vector<Line> lines_of(std::string_view text);

/// Whether the word is a NAME, or a CONSTANT.
bool is_name(const std::string& word);
bool is_constant(const std::string& word);

} // namespace plprove::model
