// The words of a program in a language of computer algebra, and where they stand.
#pragma once

#include "prover/model/words.h"

#include <string>
#include <string_view>
#include <vector>

namespace plprove::importers {

enum class Language { macaulay2, julia, matlab };

struct Token {
    enum class Kind { name, number, text, symbol, new_line, end };
    Kind kind = Kind::end;
    std::string word;
    model::Position at;
    bool after_space = false;
};

/// The tokens of a program, the last one of the kind `end`. Comments are left out; a new line
/// between brackets is none, but between [ and ] in Julia and Matlab. Throws ModelError for a text
/// or comment that does not end, or if brackets do not fit.
std::vector<Token> tokens_of(std::string_view program, Language language);

} // namespace plprove::importers
