// Fuzzed: the reader of images for `plprove solve`. What is accepted are images of the problem that
// they name, in finite numbers; what is not is refused with a message that names the file.
#include "prover/solver/images_file.h"
#include "prover/system/exit.h"
#include "prover/system/words.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <cmath>

using namespace plprove;

namespace {

void require_fit(std::string_view message) {
    require(message.starts_with("fuzzed: "), "a message that does not name the file");
    require(message.size() < 1000, "a long message");
    require(std::ranges::all_of(message, [](char c) { return c >= ' ' && c <= '~'; }),
            "a message unfit for a terminal");
}

/// A view sees of a feature what the problem says, and no more; but for shared lines.
void require_sight(const GivenSighting& sighting, const Feature& feature, int view) {
    require(sighting.point.has_value() == feature.sees_point(view), "a point too many, or missing");
    require(std::ssize(sighting.lines) == feature.lines, "lines of another feature");
    for (int line = 0; line < feature.lines; ++line) {
        const bool shared = line < std::ssize(feature.shared);
        require(sighting.lines[static_cast<std::size_t>(line)].has_value() ==
                    (!shared && feature.sees_line(view, line)),
                "a line too many, or missing");
    }
}

void require_sense(const GivenImages& images) {
    const auto views = static_cast<std::size_t>(images.problem.front().views());
    require(images.calibration.size() == views, "another number of cameras");
    require(images.features.size() == images.problem.size(), "another number of features");
    require(images.names.size() == images.problem.size(), "a feature without its name");
    for (std::size_t f = 0; f < images.problem.size(); ++f) {
        require(images.features[f].size() == views, "a feature in another number of views");
        for (std::size_t view = 0; view < views; ++view)
            require_sight(images.features[f][view], images.problem[f], static_cast<int>(view));
    }
}

/// What the solver does with images before it tracks paths.
void prepare(const GivenImages& images) {
    refuse_degenerate(images);
    const ConsistentImages exact = consistent(images);
    require(exact.moved >= 0, "a distance below zero");
    rounded(images, exact);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    GivenImages images;
    try {
        images = read_images(text, "fuzzed", std::nullopt);
    } catch (const BadInput& error) {
        require_fit(error.what());
        return 0;
    }
    require_sense(images);
    if (images.problem.size() > 20) return 0; // to make them consistent takes longer than to read
    try {
        prepare(images);
    } catch (const BadInput& error) { // degenerate images
        require(!has_control_character(error.what()), "a message that moves the cursor");
    }
    return 0;
}
