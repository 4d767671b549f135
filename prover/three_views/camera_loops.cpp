#include "prover/three_views/camera_loops.h"

#include "prover/three_views/scene.h"

#include <utility>

namespace plprove {

CameraLoops::CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                         double least, Field field)
    : system_(system), least_(least), field_(field),
      random_(seed, stream), chart_{{random_.complex3(), random_.complex3()}, {}},
      constants_(random_constants(system, random_)), follower_({}) {
    for (Complex& x : chart_.centre)
        x = random_.complex();
    follower_ = PathFollower(tracked_system(system, chart_));
}

CameraLoops::CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                         double least)
    : CameraLoops(system, seed, stream, least, Field::complex) {
    for (Complex& x : start_)
        x = random_.complex();
    nodes_[0].images = images_of_scene(system, chart_.cameras(start_), random_);
    nodes_[1].images = random_neighbour(nodes_[0].images, random_);
    prepare_nodes(seed, stream);
}

CameraLoops::CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                         const ChooseImages& choose)
    : CameraLoops(system, seed, stream, suspicious, Field::real) {
    CameraPoint point;
    for (Complex& x : point)
        x = random_.number(Field::real);
    const QuaternionCameras cameras = standard_chart().cameras(point);
    nodes_[1].images = images_of_scene(system, cameras, random_, Field::real);
    nodes_[0].images = choose(nodes_[1].images, random_);
    prepare_nodes(seed, stream);
    start_ = chart_.point(cameras);
}

void CameraLoops::prepare_nodes(std::uint64_t seed, std::uint64_t stream) {
    // A stream of its own: this test has no part in the choice of paths.
    Random others(seed, stream ^ (std::uint64_t{1} << 63U));
    for (Node& node : nodes_) {
        node.vectors = image_vectors(system_, constants_, node.images);
        spurious_.emplace_back(system_, chart_, constants_, node.images, others);
    }
}

TrackedImages CameraLoops::moving(const Images& from, const Images& to) const {
    return moving_images(system_, constants_, from, to);
}

std::array<CameraLoops::Legs, 2> CameraLoops::random_detour(const Images& to) {
    const Images& from = nodes_[0].images;
    const Images middle = detour_midpoint(from, to, random_);
    return {
        {{moving(from, middle), moving(middle, to)}, {moving(to, middle), moving(middle, from)}}};
}

void CameraLoops::add_edge() {
    // Short paths are quicker, but have fewer branch points in their loops.
    constexpr std::size_t short_edges = 3;
    const Phases phases = edges_.size() < short_edges ? Phases::near_one : Phases::any;
    const Images to = rephased(nodes_[1].images, phases, random_);
    const Images& from = nodes_[0].images;
    edges_.push_back({to, {moving(from, to), moving(to, from)}, random_detour(to)});
}

PathEnds<CameraPoint> CameraLoops::follow(Direction direction,
                                          const std::vector<CameraPoint>& starts) {
    const Edge& edge = edges_[static_cast<std::size_t>(direction.edge)];
    return follower_.follow_quickly(edge.images[static_cast<std::size_t>(direction.from)], starts);
}

PathEnds<CameraPoint> CameraLoops::follow_again(Direction direction, int attempt,
                                                const std::vector<CameraPoint>& starts) {
    if (counts().retried + starts.size() > most_again_) return PathEnds<CameraPoint>(starts.size());
    const Edge& edge = edges_[static_cast<std::size_t>(direction.edge)];
    const auto from = static_cast<std::size_t>(direction.from);
    if (attempt == 1)
        return follower_.follow_detours(
            {edge.detour[from], [&] { return random_detour(edge.to)[from]; }}, starts);
    // Solutions nearly as degenerate as rounding do occur. Any way leads to other images, but an
    // edge matches all solutions only if all follow the same: hence still more digits.
    auto ends = follower_.follow_double_double(edge.images[from], starts);
    fill(ends, starts,
         [&](const auto& left) { return follower_.follow_triple_double(edge.images[from], left); });
    return ends;
}

std::vector<bool> CameraLoops::refused(int node, const std::vector<CameraPoint>& zeros,
                                       bool again) const {
    const auto at = static_cast<std::size_t>(node);
    std::vector<bool> result(zeros.size());
    std::vector<std::size_t> indices;
    std::vector<CameraPoint> suspects;
    for (std::size_t i = 0; i < zeros.size(); ++i) {
        const double value = nondegeneracy(system_, nodes_[at].vectors, chart_.cameras(zeros[i]));
        result[i] = !again && value < least_;
        if (value >= doubtful || result[i]) continue;
        indices.push_back(i);
        suspects.push_back(zeros[i]);
    }
    const std::vector<bool> found = spurious_[at].among(suspects);
    for (std::size_t i = 0; i < indices.size(); ++i)
        result[indices[i]] = found[i];
    return result;
}

std::optional<CameraPoint> CameraLoops::companion(const CameraPoint& zero) const {
    if (field_ == Field::complex) return std::nullopt;
    return chart_.point(conjugate(chart_.cameras(zero)));
}

Monodromy<CameraLoops> camera_monodromy(CameraLoops loops, Monodromy<CameraLoops>::Report report) {
    const CameraPoint start = loops.start();
    const int node = loops.start_node();
    Monodromy<CameraLoops> monodromy(std::move(loops), near_at_path_ends, std::move(report));
    monodromy.add(node, start);
    return monodromy;
}

} // namespace plprove
