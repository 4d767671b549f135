#include "prover/cli/sections.h"

#include "prover/system/words.h"

#include <iomanip>
#include <sstream>

namespace plprove {

std::ostream& section(std::ostream& out, std::string_view label) {
    return out << std::left << std::setw(label_width) << label;
}

void write_wrapped(std::ostream& out, const std::string& text, std::size_t indent) {
    std::istringstream lines(wrapped(text, text_width - indent));
    bool first = true;
    for (std::string line; std::getline(lines, line); first = false) {
        if (!first) section(out, "");
        out << std::string(indent, ' ') << line << '\n';
    }
}

} // namespace plprove
