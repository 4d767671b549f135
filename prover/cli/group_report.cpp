#include "prover/cli/group_report.h"

#include "prover/cli/sections.h"

#include <nlohmann/json.hpp>

namespace plprove {

namespace {

/// `10, then 2, then 8 solutions`.
std::string steps_in_words(const MonodromyGroup& group) {
    std::string words;
    for (const GroupStep& step : group.steps)
        words += (words.empty() ? "" : ", then ") + std::to_string(step.solutions);
    return words + (group.degree() == 1 ? " solution" : " solutions");
}

std::string lengths_in(const CycleType& cycle_type) {
    std::string words;
    for (const int length : cycle_type)
        words += (words.empty() ? "" : " ") + std::to_string(length);
    return words;
}

} // namespace

std::string in_words(const MonodromyGroup& group) {
    if (group.steps.size() == 1 && group.steps.front().kind == GroupStep::Kind::other)
        return "a primitive subgroup of S" + std::to_string(group.degree());
    const std::string name = group.name();
    return name.starts_with('<') ? "a subgroup of " + name.substr(1) : name;
}

void write_steps(std::ostream& out, const MonodromyGroup& group) {
    section(out, "order") << group.order() << '\n';
    section(out, "steps") << steps_in_words(group) << '\n';
    section(out, "width") << group.width() << '\n';
}

void write_cycles(std::ostream& out, const std::vector<CycleType>& cycle_types) {
    for (const CycleType& cycle_type : cycle_types)
        section(out, "cycles") << lengths_in(cycle_type) << '\n';
}

nlohmann::ordered_json evidence_json(const MonodromyGroup& group, int loops) {
    nlohmann::ordered_json json = {{"group", group.name()},
                                   {"order", group.order()},
                                   {"width", group.width()},
                                   {"loops", loops}};
    for (const GroupStep& step : group.steps)
        json["steps"].push_back(step.solutions);
    return json;
}

} // namespace plprove
