#include "checker/family/isomorphism.h"

#include <algorithm>

namespace checker {
static PointType type_of(const Problem& problem, const Point& point) {
    PointType type{.seen_by = point.seen_by};
    for (const std::size_t n : point.lines)
        type.lines.push_back({problem.lines[n].points.size(), problem.lines[n].seen_by});
    std::ranges::sort(type.lines);
    return type;
}

Invariant invariant(const Problem& problem) {
    Invariant result{problem.cameras->name, problem.views, {}, {}};
    for (const Point& point : problem.points)
        result.points.push_back(type_of(problem, point));
    std::ranges::sort(result.points);
    for (const Line& line : problem.lines)
        if (line.points.empty()) result.free_lines.push_back(line.seen_by);
    std::ranges::sort(result.free_lines);
    return result;
}

/// Two problems side by side: the points and lines of the first, then those of the second, are
/// nodes of a graph. A point and a line on it are neighbours.
struct Graph {
    std::vector<Indices> neighbours{};
    Indices colours{}; // a renaming takes each node to one of the same colour

    std::size_t size() const { return neighbours.size(); }
};

/// Makes equal keys, and only these, equal colours. Returns how many there are.
static std::size_t colour(Graph& graph, const std::vector<Indices>& keys) {
    std::map<Indices, std::size_t> numbers;
    graph.colours.clear();
    for (const Indices& key : keys)
        graph.colours.push_back(numbers.try_emplace(key, numbers.size()).first->second);
    return numbers.size();
}

static Graph graph_of(const Problem& a, const Problem& b) {
    Graph graph;
    std::vector<Indices> keys;
    const auto add = [&](const Indices& neighbours, std::size_t first, const Indices& key) {
        Indices& own = graph.neighbours.emplace_back();
        for (const std::size_t neighbour : neighbours)
            own.push_back(first + neighbour);
        keys.push_back(key);
    };
    for (const Problem* problem : {&a, &b}) {
        const std::size_t points = graph.size(), lines = points + problem->points.size();
        for (const Point& point : problem->points)
            add(point.lines, lines, {0, point.seen_by});
        for (const Line& line : problem->lines)
            add(line.points, points, {1, line.seen_by});
    }
    colour(graph, keys);
    return graph;
}

/// Takes the steps if there are enough; else none is left.
static bool take(std::size_t& steps, std::size_t needed) {
    const bool enough = needed <= steps;
    steps = enough ? steps - needed : 0;
    return enough;
}

/// Tells nodes apart by the colours of their neighbours, until this tells no more apart. False if
/// it takes more steps, one for each node each time.
static bool refine(Graph& graph, std::size_t& steps) {
    for (std::size_t before = 0, now = 1; before < now;) {
        if (!take(steps, graph.size())) return false;
        std::vector<Indices> keys;
        for (std::size_t node = 0; node < graph.size(); ++node) {
            Indices& key = keys.emplace_back();
            for (const std::size_t neighbour : graph.neighbours[node])
                key.push_back(graph.colours[neighbour]);
            std::ranges::sort(key);
            key.push_back(graph.colours[node]);
        }
        before = std::exchange(now, colour(graph, keys));
    }
    return true;
}

/// A renaming of the first problem as the second, while it is being found.
struct Search {
    const Graph& graph;
    std::size_t second = 0; // the first node of the second problem
    std::size_t& steps;
    /// Whether a node is left if nodes with one neighbour or none are taken away again and again.
    /// What is taken away hangs like trees on what is left, and colours decide how.
    std::vector<bool> kept{};
    std::vector<std::optional<std::size_t>> image{}; // of each node of the first problem
    std::vector<bool> is_image{};
};

static std::vector<bool> kept_nodes(const Graph& graph) {
    std::vector<bool> kept(graph.size(), true);
    const auto is_kept = [&](std::size_t node) { return kept[node]; };
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (std::size_t node = 0; node < graph.size(); ++node) {
            if (!kept[node] || std::ranges::count_if(graph.neighbours[node], is_kept) > 1) continue;
            kept[node] = false;
            goes_on = true;
        }
    }
    return kept;
}

/// The nodes that are joined to this one and kept, each after one of its neighbours.
static Indices component(const Search& search, std::size_t start) {
    Indices nodes{start};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const std::size_t neighbour : search.graph.neighbours[nodes[i]])
            if (search.kept[neighbour] && std::ranges::count(nodes, neighbour) == 0)
                nodes.push_back(neighbour);
    return nodes;
}

/// Whether a node may take the place of another, whose neighbours have images in part.
static bool fits(const Search& search, std::size_t node, std::size_t candidate) {
    if (!search.kept[candidate] || search.is_image[candidate]) return false;
    if (search.graph.colours[node] != search.graph.colours[candidate]) return false;
    const Indices& others = search.graph.neighbours[candidate];
    return std::ranges::all_of(search.graph.neighbours[node], [&](std::size_t neighbour) {
        const auto image = search.image[neighbour];
        return !image || std::ranges::count(others, *image) > 0;
    });
}

/// The nodes to try as the image of this one: neighbours of the image of a neighbour, if one has
/// an image.
static Indices candidates(const Search& search, std::size_t node) {
    for (const std::size_t neighbour : search.graph.neighbours[node])
        if (const auto image = search.image[neighbour]) return search.graph.neighbours[*image];
    Indices all;
    for (std::size_t other = search.second; other < search.graph.size(); ++other)
        all.push_back(other);
    return all;
}

/// Finds images for the nodes of a component from this place on.
static bool extend(Search& search, const Indices& nodes, std::size_t place) {
    if (place == nodes.size()) return true;
    const std::size_t node = nodes[place];
    for (const std::size_t candidate : candidates(search, node)) {
        if (!take(search.steps, 1)) return false;
        if (!fits(search, node, candidate)) continue;
        search.image[node] = candidate;
        search.is_image[candidate] = true;
        if (extend(search, nodes, place + 1)) return true;
        search.image[node].reset();
        search.is_image[candidate] = false;
    }
    return false;
}

// A component that has found its image keeps it: any other one that would do is isomorphic to it.
std::optional<bool> isomorphic(const Problem& a, const Problem& b, std::size_t& steps) {
    if (steps == 0) return std::nullopt;
    Graph graph = graph_of(a, b);
    if (!refine(graph, steps)) return std::nullopt;
    const auto second = static_cast<std::ptrdiff_t>(a.points.size() + a.lines.size());
    Indices left(graph.colours.begin(), graph.colours.begin() + second);
    Indices right(graph.colours.begin() + second, graph.colours.end());
    std::ranges::sort(left);
    std::ranges::sort(right);
    if (left != right) return false;
    Search search{graph, left.size(), steps, kept_nodes(graph)};
    search.image.resize(graph.size());
    search.is_image.resize(graph.size());
    for (std::size_t node = 0; node < search.second; ++node) {
        if (!search.kept[node] || search.image[node]) continue;
        if (extend(search, component(search, node), 0)) continue;
        return steps > 0 ? std::optional(false) : std::nullopt;
    }
    return true;
}
} // namespace checker
