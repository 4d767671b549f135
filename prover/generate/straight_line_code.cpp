#include "prover/generate/straight_line_code.h"

#include <array>
#include <charconv>

namespace plprove::generate {

using model::Expressions;
using model::Node;
using model::NodeIndex;
using Kind = Node::Kind;

std::string literal(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

StraightLineCode::StraightLineCode(const Expressions& nodes, const std::vector<NodeIndex>& wanted)
    : nodes_(nodes), uses_(nodes.size()), texts_(nodes.size()) {
    for (const NodeIndex index : wanted)
        ++uses_[index];
    for (std::size_t i = nodes.size(); i-- > 0;) {
        const Node& node = nodes[static_cast<NodeIndex>(i)];
        if (uses_[i] == 0 || node.is_input()) continue;
        ++uses_[node.left];
        if (node.is_binary()) ++uses_[node.right];
    }
}

std::string StraightLineCode::definitions(NodeIndex wanted, const std::string& indent) {
    constexpr std::size_t longest = 60; // of an expression that gets no name
    std::string result;
    std::vector<NodeIndex> open{wanted};
    while (!open.empty()) {
        const NodeIndex index = open.back();
        const Node& node = nodes_[index];
        if (!texts_[index].is_done && !node.is_input()) {
            const std::size_t before = open.size();
            if (node.is_binary() && !texts_[node.right].is_done) open.push_back(node.right);
            if (!texts_[node.left].is_done) open.push_back(node.left);
            if (open.size() > before) continue;
        }
        open.pop_back();
        if (texts_[index].is_done) continue;
        Text text = text_of(index);
        if (!node.is_input() && (uses_[index] > 1 || text.text.size() > longest)) {
            const std::string name = "v" + std::to_string(++names_);
            result += indent + "const auto " + name + " = " + text.text + ";\n";
            text = {name};
        }
        text.is_done = true;
        texts_[index] = std::move(text);
    }
    return result;
}

StraightLineCode::Text StraightLineCode::text_of(NodeIndex index) const {
    const Node& node = nodes_[index];
    const auto item = [&](const char* array) -> Text {
        return {array + ("[" + std::to_string(node.left) + "]")};
    };
    const auto left = [&]() -> const Text& { return texts_[node.left]; };
    const auto right = [&]() -> const Text& { return texts_[node.right]; };
    switch (node.kind) {
    case Kind::constant:
        return {literal(node.value), node.value < 0};
    case Kind::unknown:
        return item("u");
    case Kind::datum:
        return item("d");
    case Kind::speed:
        return item("speed");
    case Kind::sum:
        return {left().text + " + " + right().as_factor(), true};
    case Kind::difference:
        return {left().text + " - " + right().as_factor(), true};
    case Kind::product:
        return {left().as_factor() + "*" + right().as_factor()};
    case Kind::negative:
        return {"-" + left().as_factor(), true};
    case Kind::reciprocal:
        break;
    }
    return {"inverse(" + left().text + ")"};
}

bool StraightLineCode::needs(Kind kind) const {
    for (std::size_t i = 0; i < uses_.size(); ++i)
        if (uses_[i] > 0 && nodes_[static_cast<NodeIndex>(i)].kind == kind) return true;
    return false;
}

} // namespace plprove::generate
