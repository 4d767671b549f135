#include "tests/checker/general_bounds/projective_problems.h"

#include "checker/general_degrees/scene_system.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>

using namespace checker;

std::vector<DegreeOnFile> projective_degrees() {
    std::vector<DegreeOnFile> degrees;
    for (const OnFile& row : family_degrees_on_file())
        if (row.family == "projective" && std::popcount(problem_of(row.problem).views) > 2)
            degrees.push_back({row.problem, std::stoul(row.degree)});
    REQUIRE(degrees.size() > 200);
    return degrees;
}

std::vector<Numbers> random_views(const Problem& problem, std::size_t views, unsigned seed) {
    Dice dice(seed);
    for (int tries = 0; tries < 1000; ++tries)
        try {
            std::vector<Numbers> images(views);
            for (Numbers& image : images)
                for (std::size_t n = numbers_of_view(problem); n > 0; --n)
                    image.push_back(dice.from_to(-50, 50));
            scene_system(problem, images);
            return images;
        } catch (const Refused&) {
            continue; // too special
        }
    FAIL("no images");
    return {};
}
