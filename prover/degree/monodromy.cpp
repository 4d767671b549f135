#include "prover/degree/monodromy.h"

#include "prover/degree/scene.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace plprove {

Monodromy::Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                     double least, Field field)
    : system_(system), least_(least), field_(field),
      random_(seed, stream), chart_{{random_.complex3(), random_.complex3()}, {}},
      constants_(random_constants(system, random_)), follower_({}) {
    for (Complex& x : chart_.centre)
        x = random_.complex();
    follower_ = PathFollower(tracked_system(system, chart_));
}

Monodromy::Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                     double least)
    : Monodromy(system, seed, stream, least, Field::complex) {
    CameraPoint start;
    for (Complex& x : start)
        x = random_.complex();
    nodes_[0].images = images_of_scene(system, chart_.cameras(start), random_);
    nodes_[1].images = random_neighbour(nodes_[0].images, random_);
    prepare_nodes(seed, stream);
    add(0, start);
}

Monodromy::Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                     const ChooseImages& choose)
    : Monodromy(system, seed, stream, suspicious, Field::real) {
    CameraPoint start;
    for (Complex& x : start)
        x = random_.number(Field::real);
    const QuaternionCameras cameras = standard_chart().cameras(start);
    nodes_[1].images = images_of_scene(system, cameras, random_, Field::real);
    nodes_[0].images = choose(nodes_[1].images, random_);
    prepare_nodes(seed, stream);
    add(1, chart_.point(cameras));
}

void Monodromy::prepare_nodes(std::uint64_t seed, std::uint64_t stream) {
    // A stream of its own: this test has no part in the choice of paths.
    Random others(seed, stream ^ (std::uint64_t{1} << 63U));
    for (Node& node : nodes_) {
        node.vectors = image_vectors(system_, constants_, node.images);
        spurious_.emplace_back(system_, chart_, constants_, node.images, others);
    }
}

int Monodromy::add(std::size_t node, const CameraPoint& zero) {
    SolutionSet& solutions = nodes_[node].solutions;
    const int index = solutions.add(zero);
    if (field_ == Field::real) {
        const CameraPoint other = chart_.point(conjugate(chart_.cameras(zero)));
        if (!solutions.find(other)) solutions.add(other);
    }
    return index;
}

void Monodromy::add_edge() {
    // Short paths are quicker, but have fewer branch points in their loops.
    constexpr int short_edges = 3;
    const Images& images = nodes_[1].images;
    const Images to =
        rephased(images, edges() < short_edges ? Phases::near_one : Phases::any, random_);
    edges_.push_back({to,
                      {moving_images(system_, constants_, nodes_[0].images, to),
                       moving_images(system_, constants_, to, nodes_[0].images)},
                      random_detour(to)});
}

std::array<std::array<TrackedImages, 2>, 2> Monodromy::random_detour(const Images& to) {
    const Images from = nodes_[0].images, middle = detour_midpoint(from, to, random_);
    const auto moving = [&](const Images& a, const Images& b) {
        return moving_images(system_, constants_, a, b);
    };
    return {
        {{moving(from, middle), moving(middle, to)}, {moving(to, middle), moving(middle, from)}}};
}

std::vector<int> Monodromy::match(Edge& edge, int from, int start,
                                  const std::optional<CameraPoint>& end, double least) {
    const auto source = static_cast<std::size_t>(from), target = 1 - source;
    auto &partner = edge.partner[source], &inverse = edge.partner[target];
    int& mine = partner[static_cast<std::size_t>(start)];
    mine = lost;
    if (!end) return {start};
    SolutionSet& set = nodes_[target].solutions;
    const std::optional<int> known = set.find(*end);
    if (!known && nondegeneracy(system_, nodes_[target].vectors, chart_.cameras(*end)) < least)
        return {start};
    const int index = known ? *known : add(target, *end);
    inverse.resize(static_cast<std::size_t>(set.size()), open);
    int& theirs = inverse[static_cast<std::size_t>(index)];
    if (theirs >= 0 && theirs != start) {
        const int other = theirs;
        partner[static_cast<std::size_t>(other)] = theirs = lost;
        return {start, other};
    }
    theirs = start;
    mine = index;
    return {};
}

std::vector<std::size_t> Monodromy::find_spurious(std::size_t node,
                                                  const std::vector<CameraPoint>& zeros) const {
    std::vector<std::size_t> indices;
    std::vector<CameraPoint> suspects;
    for (std::size_t i = 0; i < zeros.size(); ++i)
        if (nondegeneracy(system_, nodes_[node].vectors, chart_.cameras(zeros[i])) < doubtful) {
            indices.push_back(i);
            suspects.push_back(zeros[i]);
        }
    const std::vector<bool> found = spurious_[node].among(suspects);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (found[i]) result.push_back(indices[i]);
    return result;
}

PathFollower::Ends Monodromy::without_spurious(std::size_t node, PathFollower::Ends ends) const {
    std::vector<std::size_t> indices;
    std::vector<CameraPoint> zeros;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] && !nodes_[node].solutions.find(*ends[i])) {
            indices.push_back(i);
            zeros.push_back(*ends[i]);
        }
    for (const std::size_t i : find_spurious(node, zeros))
        ends[indices[i]].reset();
    return ends;
}

bool Monodromy::follow_edge(Edge& edge, int from, int most) {
    const auto source = static_cast<std::size_t>(from);
    auto& partner = edge.partner[source];
    partner.resize(static_cast<std::size_t>(nodes_[source].solutions.size()), open);
    std::vector<int> starting;
    std::vector<CameraPoint> starts;
    for (int i = 0; i < nodes_[source].solutions.size() && std::ssize(starting) < most; ++i)
        if (partner[static_cast<std::size_t>(i)] == open) {
            starting.push_back(i);
            starts.push_back(nodes_[source].solutions[i]);
        }
    if (starting.empty()) return false;
    const auto ends =
        without_spurious(1 - source, follower_.follow_quickly(edge.images[source], starts));
    for (std::size_t k = 0; k < starting.size(); ++k)
        std::ranges::copy(match(edge, from, starting[k], ends[k], least_),
                          std::back_inserter(edge.postponed[source]));
    return true;
}

void Monodromy::follow_detours(Edge& edge, int from, const std::vector<int>& starting,
                               const std::vector<CameraPoint>& starts,
                               const PathFollower::Ends& ends) {
    const auto source = static_cast<std::size_t>(from), target = 1 - source;
    const auto [again, indices] = without_end(starts, ends);
    const auto detoured = without_spurious(
        target, follower_.follow_detours(
                    {edge.detour[source], [&] { return random_detour(edge.to)[source]; }}, again));
    for (std::size_t k = 0; k < indices.size(); ++k) {
        if (!detoured[k]) continue;
        // Past a branch point a detour leads elsewhere: to where the straight way leads another
        // path, which takes precedence, or where it would lead another one that is lost.
        const std::optional<int> known = nodes_[target].solutions.find(*detoured[k]);
        const bool taken = known && std::ssize(edge.partner[target]) > *known &&
                           edge.partner[target][static_cast<std::size_t>(*known)] >= 0;
        if (!taken) match(edge, from, starting[indices[k]], detoured[k], 0);
    }
}

bool Monodromy::follow_postponed() {
    bool found = false;
    for (Edge& edge : edges_)
        for (const int from : {0, 1}) {
            const auto source = static_cast<std::size_t>(from);
            std::vector<int> starting;
            std::vector<CameraPoint> starts;
            for (const int i : std::exchange(edge.postponed[source], {}))
                if (edge.partner[source][static_cast<std::size_t>(i)] == lost) {
                    starting.push_back(i);
                    starts.push_back(nodes_[source].solutions[i]);
                }
            const int before = nodes_[1 - source].solutions.size();
            // Solutions nearly as degenerate as rounding do occur. Any way leads to other images,
            // but an edge matches all solutions only if all follow the same: hence still more
            // digits.
            auto ends = follower_.follow_double_double(edge.images[source], starts);
            fill(ends, starts, [&](const auto& left) {
                return follower_.follow_triple_double(edge.images[source], left);
            });
            ends = without_spurious(1 - source, std::move(ends));
            for (std::size_t k = 0; k < starting.size(); ++k)
                match(edge, from, starting[k], ends[k], 0);
            follow_detours(edge, from, starting, starts, ends);
            if (nodes_[1 - source].solutions.size() > before) found = true;
        }
    return found;
}

void Monodromy::run(int edges, int target) {
    while (this->edges() < edges)
        add_edge();
    do {
        bool moving = true;
        while (moving) {
            moving = false;
            for (const int from : {0, 1})
                for (Edge& edge : edges_) {
                    // Not many more than are wanted, but enough to fill the lanes.
                    const int wanted = target - nodes_[0].solutions.size();
                    if (target > 0 && wanted <= 0) return;
                    const int most =
                        target > 0 ? std::max(16, wanted) : std::numeric_limits<int>::max();
                    if (follow_edge(edge, from, most)) moving = true;
                    if (progress_) progress_({solutions().size(), this->edges()});
                }
        }
    } while (follow_postponed());
}

bool Monodromy::follow_some(int target) {
    const int known = solutions().size();
    // The first edge and conjugation reach nearly all solutions from a few. The others lead to
    // these: so they are followed for some solutions at a time, enough to fill the lanes.
    int most = std::max(16, (target - known) / 2);
    for (Edge& edge : edges_) {
        for (const int from : {0, 1})
            if (follow_edge(edge, from, most)) return true;
        most = std::max(16, known / 32);
    }
    return false;
}

void Monodromy::find(int target, int most_edges) {
    while (solutions().size() < target) {
        if (progress_) progress_({solutions().size(), edges()});
        if (follow_some(target) || follow_postponed()) continue;
        if (edges() == most_edges) return;
        add_edge();
    }
}

int Monodromy::unmatched(const Edge& edge) const {
    int count = 0;
    for (const std::size_t node : {0U, 1U}) {
        count += nodes_[node].solutions.size() - static_cast<int>(edge.partner[node].size());
        count += static_cast<int>(
            std::ranges::count_if(edge.partner[node], [](int partner) { return partner < 0; }));
    }
    return count;
}

int Monodromy::unmatched() const {
    int count = 0;
    for (const Edge& edge : edges_)
        count += unmatched(edge);
    return count;
}

int Monodromy::bijective_edges() const {
    return static_cast<int>(
        std::ranges::count_if(edges_, [&](const Edge& edge) { return unmatched(edge) == 0; }));
}

int Monodromy::spurious_solutions() const {
    return static_cast<int>(find_spurious(0, nodes_[0].solutions.points()).size());
}

} // namespace plprove
