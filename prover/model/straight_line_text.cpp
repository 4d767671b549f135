#include "prover/model/straight_line_text.h"

#include <array>
#include <charconv>

namespace plprove::model {

namespace {

/// How often each step is used.
std::vector<int> uses(const DataProgram& program, const std::vector<std::size_t>& wanted) {
    std::vector<int> result(program.steps().size());
    for (const std::size_t step : wanted)
        ++result[step];
    for (std::size_t i = result.size(); i-- > 0;) {
        const DataProgram::Step& step = program.steps()[i];
        if (result[i] == 0 || step.kind <= StepKind::datum) continue;
        ++result[step.left];
        if (step.kind != StepKind::negative) ++result[step.right];
    }
    return result;
}

std::string literal(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// An expression: whether it is a sum, so that it needs brackets as a factor.
struct Text {
    std::string text;
    bool is_sum = false;

    std::string as_factor() const { return is_sum ? "(" + text + ")" : text; }
};

} // namespace

StraightLineText straight_line_text(const DataProgram& program,
                                    const std::vector<std::size_t>& wanted,
                                    const std::vector<std::string>& data) {
    constexpr std::size_t longest = 40; // of an expression that gets no name
    const std::vector<int> used = uses(program, wanted);
    std::vector<Text> texts(used.size());
    const auto text_of = [&](const DataProgram::Step& step) -> Text {
        const Text& left = texts[step.left];
        const Text& right = texts[step.right];
        switch (step.kind) {
        case StepKind::literal:
            return {literal(step.literal), step.literal < 0};
        case StepKind::datum:
            return {data[step.left]};
        case StepKind::negative:
            return {"-" + left.as_factor(), true};
        case StepKind::sum:
            return {left.text + " + " + right.as_factor(), true};
        case StepKind::difference:
            return {left.text + " - " + right.as_factor(), true};
        case StepKind::product:
            break;
        }
        return {left.as_factor() + "*" + right.as_factor()};
    };
    StraightLineText result;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i] == 0) continue;
        const DataProgram::Step& step = program.steps()[i];
        texts[i] = text_of(step);
        const bool is_short = used[i] == 1 && texts[i].text.size() <= longest;
        if (step.kind <= StepKind::datum || is_short) continue;
        std::string name = "_" + std::to_string(result.assignments.size() + 1);
        result.assignments.emplace_back(name, std::move(texts[i].text));
        texts[i] = {std::move(name)};
    }
    for (const std::size_t step : wanted)
        result.values.push_back(texts[step].text);
    return result;
}

} // namespace plprove::model
