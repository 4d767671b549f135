#include "tests/checker/general_bounds/projective_problems.h"

#include "checker/general_degrees/scene_system.h"

#include <doctest/doctest.h>
#include <fstream>
#include <sstream>

using namespace checker;

std::vector<DegreeOnFile> projective_degrees() {
    std::vector<DegreeOnFile> degrees;
    std::ifstream table(SOURCE_DIR "/certs/family-degrees.csv");
    for (std::string line; std::getline(table, line);) {
        std::istringstream columns(line);
        std::string family, notation, degree;
        std::getline(columns, family, ',');
        std::getline(columns, notation, ',');
        std::getline(columns, degree, ',');
        if (family != "projective") continue;
        if (std::popcount(problem_of(notation).views) > 2)
            degrees.push_back({notation, std::stoul(degree)});
    }
    REQUIRE(degrees.size() > 200);
    return degrees;
}

std::vector<Numbers> random_views(const general::Problem& problem, std::size_t views,
                                  unsigned seed) {
    Dice dice(seed);
    for (int tries = 0; tries < 1000; ++tries)
        try {
            std::vector<Numbers> images(views);
            for (Numbers& image : images)
                for (std::size_t n = general::numbers_of_view(problem); n > 0; --n)
                    image.push_back(dice.from_to(-50, 50));
            general::scene_system(problem, images);
            return images;
        } catch (const Refused&) {
            continue; // too special
        }
    FAIL("no images");
    return {};
}
