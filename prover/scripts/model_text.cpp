#include "prover/scripts/model_text.h"

#include "prover/scripts/layout.h"

namespace plprove {

void ModelText::comment(const std::string& text) {
    text_ += plprove::comment("#", text);
}

void ModelText::line(const std::string& statement, const std::string& remark) {
    constexpr std::size_t column_of_remark = 34;
    std::string line = std::string(2 * depth_, ' ') + statement;
    if (!remark.empty()) {
        line.resize(std::max(line.size() + 1, column_of_remark), ' ');
        line += "# " + remark;
    }
    text_ += line + '\n';
}

void ModelText::begin_loop(const std::string& name, const std::string& bounds) {
    line("for " + name + " in " + bounds);
    ++depth_;
}

void ModelText::end_loop() {
    --depth_;
    line("end");
}

std::string in_brackets(const std::string& sum) {
    return sum.find(' ') == std::string::npos ? sum : "(" + sum + ")";
}

} // namespace plprove
