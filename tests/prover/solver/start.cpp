// Starts as files: read back as they were, and refused when damaged.
#include "prover/solver/start.h"

#include "prover/solver/placement.h"
#include "prover/system/exit.h"
#include "prover/three_views/path_follower.h"
#include "prover/three_views/scene.h"
#include "tests/support/program.h"

#include <cstdlib>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

/// Sets XDG_CACHE_HOME while it lives.
class CacheIn {
public:
    explicit CacheIn(const std::filesystem::path& folder) {
        if (const char* value = std::getenv("XDG_CACHE_HOME")) before_ = value;
        ::setenv("XDG_CACHE_HOME", folder.c_str(), 1);
    }
    CacheIn(const CacheIn&) = delete;
    CacheIn& operator=(const CacheIn&) = delete;
    ~CacheIn() {
        if (before_)
            ::setenv("XDG_CACHE_HOME", before_->c_str(), 1);
        else
            ::unsetenv("XDG_CACHE_HOME");
    }

private:
    std::optional<std::string> before_;
};

} // namespace

TEST_CASE("a start is read back as it was, and the same seed gives the same start") {
    const Start start = find_start(17, 3);
    CHECK(start.degree() == 64);
    const std::string text = write_start(start);
    const Start again = read_start(text, "17.start");
    CHECK(again.number == 17);
    CHECK(again.solutions == start.solutions);
    CHECK(again.images == start.images);
    CHECK(again.constants == start.constants);
    CHECK(write_start(again) == text);
    CHECK(write_start(find_start(17, 3)) == text);
    CHECK(write_start(find_start(17, 4)) != text);
}

TEST_CASE("the solutions of a start are far from degenerate") {
    const Start start = find_start(17, 0);
    const CameraSystem system = camera_system(label_classes()[17]);
    const auto vectors = image_vectors(system, start.constants, start.images);
    for (const CameraPoint& solution : start.solutions)
        CHECK(nondegeneracy(system, vectors, start.chart.cameras(solution)) > 1e-9);
}

TEST_CASE("a start moves to other images with all its solutions") {
    const Start start = find_start(17, 0);
    const CameraSystem system = camera_system(label_classes()[17]);
    bool moved = false;
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
        const Start other = well_placed(start, seed);
        moved |= other.images != start.images;
        CHECK(other.degree() == 64);
        const auto tracked = tracked_system(system, other.chart);
        const auto at_rest = moving_images(system, other.constants, other.images, other.images);
        for (const auto& zero : accurate_newton(1e-10, tracked, at_rest, other.solutions))
            CHECK(zero);
    }
    CHECK(moved);
}

TEST_CASE("a damaged start is refused") {
    const std::string text = write_start(find_start(17, 0));
    CHECK_THROWS_AS(read_start("", "x"), BadInput);
    CHECK_THROWS_AS(read_start("{}", "x"), BadInput);
    CHECK_THROWS_AS(read_start("[1, 2]", "x"), BadInput);
    CHECK_THROWS_AS(read_start(text.substr(0, text.size() / 2), "x"), BadInput);
    // Any digit of any number.
    int edits = 0;
    for (std::size_t i = 0; i < text.size(); i += 501) {
        if (text[i] < '0' || text[i] > '9') continue;
        std::string edited = text;
        edited[i] = text[i] == '9' ? '1' : static_cast<char>(text[i] + 1);
        CHECK_THROWS_AS(read_start(edited, "x"), BadInput);
        ++edits;
    }
    CHECK(edits > 20);
}

TEST_CASE("the cache keeps a start, and replaces a damaged one") {
    const TemporaryFolder folder;
    const CacheIn cache(folder.path());
    const auto file = folder / "pointline/17.start";
    const Start start = cached_start(17);
    const std::string text = read_file(file);
    CHECK(text == write_start(start));
    write_file(file, text.substr(0, 1000));
    CHECK(cached_start(17).solutions == start.solutions);
    CHECK(read_file(file) == text);
    // One of another class under this name is not taken for it.
    write_file(file, write_start(find_start(12, 0)));
    CHECK(cached_start(17).number == 17);
}

TEST_CASE("a cache that cannot be written is no error") {
    const CacheIn cache("/proc/nowhere");
    CHECK(cached_start(17).degree() == 64);
}
