#include "prover/cli/recommend_command.h"

#include "prover/cli/input_file.h"
#include "prover/estimator/choices.h"
#include "prover/problem/notation.h"
#include "prover/system/exit.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::json;

constexpr const char* recommend_examples =
    "MATCHES is what photos share, in the notation of problems; it may have more features than "
    "any\n"
    "minimal problem. Or it is a file for `plprove solve`: only what each photo sees counts, not "
    "where.\n"
    "The columns: how many solutions the problem has; the time of one sample, on one core; the\n"
    "time until one may be expected to lead to rotations within 5 degrees of the truth, where\n"
    "30 % of the matches are wrong; and how far off the rotations of the best solution are.\n"
    "Half a pixel of noise is on images with a focal length of 800 pixels.\n\n"
    "Examples:\n"
    "  plprove recommend '9*Pa/Pa/Pa + 4*P/P/-'     13 points, nine with a line each\n"
    "  plprove recommend images.json --json         for machines\n";

/// What a view sees of a feature, as notation has it.
std::string sight_of(const Json& view) {
    if (view.is_null()) return "-";
    std::string sight = view.contains("point") ? "P" : "";
    if (view.contains("lines"))
        for (const auto& [letter, line] : view.at("lines").items())
            sight += letter;
    return sight.empty() ? "-" : sight;
}

/// The notation of what the features of a file show. Throws BadInput if that is no file of images.
std::string features_in_file(const std::string& path) {
    const std::string text = content_of(path);
    try {
        std::string sum;
        const Json images = Json::parse(text);
        for (const Json& feature : images.at("features")) {
            std::string sights;
            for (const Json& view : feature.at("views"))
                sights += (sights.empty() ? "" : "/") + sight_of(view);
            sum += (sum.empty() ? "" : " + ") + sights;
        }
        return sum;
    } catch (const Json::exception&) {
        throw BadInput(path + " has no list of features with views: docs/solve.md describes such "
                              "files, and `plprove solve --example Chicago` writes one");
    }
}

/// Matches that show what the features say, all at the same place: places do not count here.
Matches matches_of(const Features& features) {
    const auto views = static_cast<std::size_t>(features.front().views());
    Matches matches;
    matches.intrinsics.resize(views);
    const Segment seen{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    for (const Feature& feature : features) {
        std::vector<std::size_t> lines;
        for (int line = 0; line < feature.lines; ++line) {
            lines.push_back(matches.lines.size());
            LineMatch& match = matches.lines.emplace_back(views);
            for (std::size_t v = 0; v < views; ++v)
                if (feature.sees_line(static_cast<int>(v), line)) match[v] = seen;
        }
        if (!feature.has_point) continue;
        PointMatch& match = matches.points.emplace_back(views);
        for (std::size_t v = 0; v < views; ++v)
            if (feature.sees_point(static_cast<int>(v))) match[v] = seen.begin;
        matches.lines_through.push_back(lines);
    }
    return matches;
}

std::string text_report(const Features& features, const std::vector<Choice>& found) {
    if (found.empty())
        return notation(features) + " has too few matches for any problem on the list: five points "
                                    "that two views share are enough\n";
    std::size_t width = std::string("problem").size();
    for (const Choice& choice : found)
        width = std::max(width, notation(choice.problem).size());
    std::ostringstream out;
    out << std::left << std::setw(static_cast<int>(width)) << "problem" << std::right
        << "  solutions   a sample  a right one  error\n";
    for (const Choice& choice : found)
        out << std::left << std::setw(static_cast<int>(width)) << notation(choice.problem)
            << std::right << std::fixed << std::setw(11) << choice.degree << std::setprecision(1)
            << std::setw(8) << choice.milliseconds << " ms" << std::setprecision(0) << std::setw(10)
            << choice.expected << " ms" << std::setprecision(1) << std::setw(6) << choice.error
            << "\u00b0\n";
    return out.str();
}

std::string json_report(const Features& features, const std::vector<Choice>& found) {
    nlohmann::ordered_json offers = nlohmann::ordered_json::array();
    for (const Choice& choice : found)
        offers.push_back({{"problem", notation(choice.problem)},
                          {"degree", choice.degree},
                          {"sample_ms", choice.milliseconds},
                          {"expected_ms", choice.expected},
                          {"rotation_error_degrees", choice.error}});
    return nlohmann::ordered_json{{"matches", notation(features)}, {"problems", offers}}.dump(2) +
           '\n';
}

struct RecommendRequest {
    std::string matches;
    std::string path = "-";
    bool json = false;
};

} // namespace

Command add_recommend_command(CLI::App& program, const Deliver& deliver) {
    const auto request = std::make_shared<RecommendRequest>();
    CLI::App* app = program.add_subcommand(
        "recommend", "List the minimal problems that matches between photos offer, fastest first");
    app->add_option("MATCHES", request->matches, "what the photos show, or a file with images")
        ->required();
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->capture_default_str();
    app->add_flag("--json", request->json, "print JSON");
    app->footer(recommend_examples);
    return {app, [request, deliver] {
                const std::string& matches = request->matches;
                const Features features =
                    parse_features(names_file(matches) ? features_in_file(matches) : matches);
                const std::vector<Choice> found = choices(matches_of(features));
                deliver(request->path, request->json ? json_report(features, found)
                                                     : text_report(features, found));
                return 0;
            }};
}

} // namespace plprove
