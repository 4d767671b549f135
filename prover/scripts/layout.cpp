#include "prover/scripts/layout.h"

#include <sstream>

namespace plprove {

namespace {

constexpr std::size_t page_columns = 96;

} // namespace

std::string list(const std::vector<std::string>& items, const std::string& indent) {
    std::string text;
    std::string line = indent;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
        if (line.size() > indent.size() && line.size() + 1 + item.size() > page_columns) {
            text += line + "\n";
            line = indent;
        }
        line += (line.size() > indent.size() ? " " : "") + item;
    }
    return text + line;
}

std::string comment(const std::string& sign, const std::string& text) {
    std::istringstream words(text);
    std::string result;
    std::string line = sign;
    for (std::string word; words >> word;) {
        if (line.size() > sign.size() && line.size() + 1 + word.size() > page_columns) {
            result += line + "\n";
            line = sign;
        }
        line += " " + word;
    }
    return result + line + "\n";
}

} // namespace plprove
