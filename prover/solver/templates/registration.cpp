#include "prover/solver/templates/registration.h"

#include "prover/minimal/obstruction.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace plprove::templates {

namespace {

void add_feature(Registration& type, std::array<int, 3>& rays, const Feature& feature, int third) {
    const int i = (third + 1) % 3;
    const int j = (third + 2) % 3;
    if (!feature.has_point) {
        ++type.lines;
        return;
    }
    int lines_in_space = 0; // pins that the third view sees and the pair determines
    int lines_on_image = 0; // pins that the third view sees, known only to pass through the point
    for (int pin = 0; pin < feature.lines; ++pin)
        if (feature.sees_line(third, pin)) {
            const bool known = feature.sees_line(i, pin) && feature.sees_line(j, pin);
            ++(known ? lines_in_space : lines_on_image);
        }
    const auto sees_some_pin = [&](int view) {
        return feature.sights[static_cast<std::size_t>(view)].pins != 0;
    };
    const bool by_i = feature.sees_point(i);
    const bool by_j = feature.sees_point(j);
    const bool located = (by_i && by_j) || (by_i && sees_some_pin(j)) || (by_j && sees_some_pin(i));
    if (!feature.sees_point(third)) {
        type.lines += lines_in_space;
        type.incidences += lines_on_image;
    } else if (located) {
        type.stars.push_back(lines_in_space);
    } else if (by_i || by_j) {
        ++rays[static_cast<std::size_t>(by_i ? i : j)];
    } else {
        type.groups.push_back(1);
    }
}

} // namespace

Registration relative_pose() {
    Registration type;
    type.groups = {5};
    return type;
}

Registration registration(const Signature& signature, int third) {
    Registration type;
    std::array<int, 3> rays{};
    for (std::size_t f = 0; f < feature_count; ++f)
        for (int n = 0; n < signature[f]; ++n)
            add_feature(type, rays, standard_features()[f], third);
    for (const int count : rays)
        if (count > 0) type.groups.push_back(count);
    std::ranges::sort(type.stars);
    std::ranges::sort(type.groups);
    return type;
}

std::map<Registration, int> registration_types(const std::vector<Signature>& classes) {
    std::map<Registration, int> counts;
    for (const Signature& signature : classes) {
        const Features problem = problem_of(signature);
        if (obstruction(problem).deficiency() > 0) continue;
        const std::array<int, 3> shared = shared_points(problem); // by the pairs 12, 13, 23
        std::set<Registration> types;
        for (int third = 0; third < 3; ++third)
            if (shared[static_cast<std::size_t>(2 - third)] == 5)
                types.insert(registration(signature, third));
        for (const Registration& type : types)
            ++counts[type];
    }
    return counts;
}

std::string describe(const Registration& type) {
    const auto list = [](const std::vector<int>& numbers) {
        std::string text;
        for (const int number : numbers)
            text += ' ' + std::to_string(number);
        return text.empty() ? " none" : text;
    };
    return "stars" + list(type.stars) + ", lines " + std::to_string(type.lines) + ", incidences " +
           std::to_string(type.incidences) + ", transversals" + list(type.groups);
}

} // namespace plprove::templates
