#include "prover/importers/draft.h"

#include <algorithm>

namespace plprove::importers {

namespace {

/// Statements with these names, a few a line.
std::string declarations(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::size_t page_columns = 90;
    std::string text, line;
    for (const std::string& name : names) {
        if (!line.empty() && line.size() + name.size() > page_columns) {
            text += line + '\n';
            line.clear();
        }
        line += (line.empty() ? word + " " : ", ") + name;
    }
    return line.empty() ? text : text + line + '\n';
}

void add_names(std::map<std::string, int>& uses, const std::string& text) {
    for (const model::Line& line : model::lines_of(text))
        for (const model::Word& word : line.words)
            if (model::is_name(word.text)) ++uses[word.text];
}

} // namespace

std::map<std::string, int> Draft::uses() const {
    std::map<std::string, int> result;
    for (const std::vector<Value>* list : {&equations, &conditions})
        for (const Value& value : *list)
            add_names(result, value.text);
    for (auto let = lets_.rbegin(); let != lets_.rend(); ++let)
        if (result.contains(let->name)) add_names(result, let->value);
    return result;
}

void Draft::refuse_other_names(const std::map<std::string, int>& uses) const {
    std::set<std::string> known(data.begin(), data.end());
    known.insert(unknowns.begin(), unknowns.end());
    for (const Let& let : lets_)
        known.insert(let.name);
    for (const auto& [name, count] : uses)
        if (!known.contains(name))
            throw BadInput("the variable '" + name +
                           "' is in an equation, but is neither an unknown nor a parameter of the "
                           "system: name it among its variables or parameters");
}

std::string Draft::new_name(const std::string& name) {
    constexpr std::size_t longest = 30; // what comes after it has room
    std::string base;
    for (const char c : name.substr(0, longest)) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
        base += plain ? c : '_';
    }
    const char first = base.empty() ? '_' : base.front();
    if (first == '_' || (first >= '0' && first <= '9')) base.insert(0, "u");
    std::string candidate = base;
    for (int trial = 0;; ++trial) {
        try {
            scope_.add(candidate, {});
            return candidate;
        } catch (const model::ModelError&) { // a word of the language, or given
            candidate = base + "_" + std::string(trial == 0 ? "" : std::to_string(trial));
        }
    }
}

Value Draft::named(const std::string& name, const Value& value) {
    if (value.is_list) {
        Value result = value;
        for (std::size_t i = 0; i < value.items.size(); ++i)
            result.items[i] = named(name + "_" + std::to_string(i + 1), value.items[i]);
        return result;
    }
    if (value.level == Value::Level::atom) return value;
    const std::string given = new_name(name);
    lets_.push_back({given, value.text});
    return Value::scalar(given);
}

std::string Draft::text(const std::string& source) const {
    const std::map<std::string, int> used = uses();
    refuse_other_names(used);
    std::string lets;
    std::map<std::string, std::string> written_out; // what only one equation is
    for (const Let& let : lets_) {
        const bool is_equation =
            std::ranges::find(equations, let.name, &Value::text) != equations.end();
        if (is_equation && used.at(let.name) == 1)
            written_out[let.name] = let.value;
        else if (used.contains(let.name))
            lets += "let " + let.name + " = " + let.value + '\n';
    }
    std::string text = "# Imported from " + source + '\n';
    if (data.empty())
        text += "# It has no parameters: its coefficients are the data of one example.\n";
    text +=
        "model imported\n" + declarations("data", data) + declarations("unknown", unknowns) + lets;
    for (const Value& equation : equations) {
        const auto value = written_out.find(equation.text);
        text +=
            "equation " + (value == written_out.end() ? equation.text : value->second) + " = 0\n";
    }
    for (const Value& condition : conditions)
        text += "nonzero " + condition.text + '\n';
    return text;
}

} // namespace plprove::importers
