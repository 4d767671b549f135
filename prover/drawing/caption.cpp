#include "prover/drawing/caption.h"

#include "prover/system/words.h"

namespace plprove {

std::vector<std::string> caption(const Features& problem, std::size_t columns) {
    const std::string text = notation(problem);
    std::vector<std::string> lines(1);
    for (std::size_t begin = 0; begin < text.size();) {
        // A summand with the " + " before it, if any.
        std::size_t end = text.find(" + ", begin + 1);
        if (end == std::string::npos) end = text.size();
        const std::string summand = text.substr(begin, end - begin);
        if (begin > 0 && lines.back().size() + summand.size() > columns)
            lines.push_back(summand.substr(1));
        else
            lines.back() += summand;
        begin = end;
    }
    return lines;
}

std::string describe(const Features& problem) {
    int points = 0;
    int pins = 0;
    int free_lines = 0;
    for (const Feature& feature : problem) {
        points += feature.has_point ? 1 : 0;
        (feature.has_point ? pins : free_lines) += feature.lines;
    }
    const int views = problem.empty() ? 0 : problem.front().views();
    return counted(points, "point") + ", " + counted(pins, "pin") + " and " +
           counted(free_lines, "free line") + " in " + counted(views, "view");
}

} // namespace plprove
