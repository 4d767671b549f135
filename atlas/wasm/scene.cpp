#include "atlas/wasm/answers.h"

namespace atlas {

using namespace plprove;

Json scene_of(const Problem& problem) {
    Json lines = Json::array();
    for (const Line& line : problem.lines)
        lines.push_back({{"points", line.points}, {"seen", line.seen}});
    return {{"views", problem.views}, {"points", problem.points}, {"lines", lines}};
}

Json scene_of(const Features& problem) {
    Json points = Json::array(), lines = Json::array();
    int views = 0;
    for (const Feature& feature : problem) {
        views = feature.views();
        ViewSet seen = 0;
        for (int view = 0; view < views; ++view)
            seen |= ViewSet{feature.sees_point(view)} << view;
        Json on = Json::array();
        if (feature.has_point) {
            on.push_back(points.size());
            points.push_back(seen);
        }
        for (int line = 0; line < feature.lines; ++line)
            lines.push_back({{"points", on}, {"seen", views_of(feature, line)}});
    }
    return {{"views", views}, {"points", points}, {"lines", lines}};
}

} // namespace atlas
