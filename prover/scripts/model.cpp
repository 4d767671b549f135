#include "prover/scripts/model.h"

namespace plprove {

namespace {

std::string letter(int index) {
    return std::string(1, static_cast<char>('a' + index));
}

} // namespace

std::vector<Observation> observations(const Feature& feature) {
    std::vector<Observation> result;
    for (int view = 0; view < feature.views(); ++view) {
        const bool point = feature.sees_point(view);
        if (point) result.push_back({Observation::point, view, 0});
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line))
                result.push_back({point ? Observation::pin : Observation::line, view, line});
    }
    return result;
}

int equation_count(const Features& problem) {
    int count = 0;
    for (const Feature& feature : problem)
        for (int view = 0; view < feature.views(); ++view)
            count += dimension_in_view(feature, view);
    return count;
}

int feature_unknown_count(const Features& problem) {
    int count = 0;
    for (const Feature& feature : problem)
        count += dimension_in_space(feature);
    return count;
}

int camera_unknown_count(const Features& problem) {
    return 6 * (view_count(problem) - 1) - 1;
}

int view_count(const Features& problem) {
    return problem.empty() ? 0 : problem.front().views();
}

std::vector<NamedVector> vectors(const Feature& feature, std::size_t number) {
    const std::string n = std::to_string(number);
    std::vector<NamedVector> result{
        {"X" + n, {"x" + n, "y" + n, feature.has_point ? "z" + n : "1"}}};
    for (int line = 0; line < feature.lines; ++line) {
        const std::string name = n + letter(line);
        result.push_back({"D" + name, {"u" + name, "v" + name, "1"}});
    }
    return result;
}

NamedCamera camera(int view) {
    const std::string n = std::to_string(view + 1);
    return {"P" + n, {"a" + n, "b" + n, "c" + n}, {view == 1 ? "1" : "e" + n, "f" + n, "g" + n}};
}

void append_unknowns(std::vector<std::string>& unknowns,
                     const std::vector<std::string>& coordinates) {
    for (const std::string& name : coordinates)
        if (name != "1") unknowns.push_back(name);
}

} // namespace plprove
