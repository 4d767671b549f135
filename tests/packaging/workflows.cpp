// What others wrote and this project runs is named by its digest, and what may publish compiles
// nothing.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <regex>
#include <yaml-cpp/yaml.h>

namespace {

namespace fs = std::filesystem;

/// Whether a step is an action that is named by its commit, `./` of the repository itself included.
bool is_pinned(const std::string& action) {
    static const std::regex commit("[A-Za-z0-9_./-]+@[0-9a-f]{40}");
    return action.starts_with("./") || std::regex_match(action, commit);
}

bool has_digest(const std::string& image) {
    static const std::regex digest(".*@sha256:[0-9a-f]{64}");
    return std::regex_match(image, digest);
}

bool may_write(const YAML::Node& permissions) {
    if (!permissions) return true; // the default of a repository may be to write
    if (permissions.IsScalar()) return permissions.as<std::string>() != "read-all";
    for (const auto& permission : permissions)
        if (permission.second.as<std::string>() == "write") return true;
    return false;
}

} // namespace

TEST_CASE("workflows run actions by commit and images by digest, and jobs that may write run only "
          "actions") {
    std::size_t actions = 0, publishing = 0;
    for (const auto& entry : fs::directory_iterator(SOURCE_DIR "/.github/workflows")) {
        CAPTURE(entry.path().string());
        const YAML::Node workflow = YAML::LoadFile(entry.path().string());
        for (const auto& job : workflow["jobs"]) {
            CAPTURE(job.first.as<std::string>());
            const YAML::Node image = job.second["container"];
            if (image)
                CHECK(has_digest((image.IsMap() ? image["image"] : image).as<std::string>()));
            const YAML::Node own = job.second["permissions"];
            const bool writes = may_write(own ? own : workflow["permissions"]);
            publishing += writes;
            for (const YAML::Node& step : job.second["steps"]) {
                CHECK((!writes || !step["run"]));
                if (!step["uses"]) continue;
                ++actions;
                CAPTURE(step["uses"].as<std::string>());
                CHECK(is_pinned(step["uses"].as<std::string>()));
                CHECK((!writes || step["uses"].as<std::string>().starts_with("actions/deploy-")));
            }
        }
    }
    CHECK(actions >= 3);
    CHECK(publishing >= 1);
}

TEST_CASE("the workflow that publishes the atlas says where atlas and repository stand") {
    const std::string build = read_file(SOURCE_DIR "/atlas/build");
    const YAML::Node workflow = YAML::LoadFile(SOURCE_DIR "/.github/workflows/atlas.yml");
    std::size_t builds = 0;
    for (const YAML::Node& step : workflow["jobs"]["build"]["steps"]) {
        if (!step["run"] || step["run"].as<std::string>() != "./reproduce atlas") continue;
        ++builds;
        REQUIRE(step["env"].size() == 2);
        for (const auto& setting : step["env"])
            CHECK(build.find("${" + setting.first.as<std::string>() + "-") != std::string::npos);
        CHECK(step["env"]["ATLAS_REPOSITORY"].as<std::string>() ==
              "${{ github.server_url }}/${{ github.repository }}");
        CHECK(step["env"]["ATLAS_ADDRESS"].as<std::string>() ==
              "${{ vars.ATLAS_ADDRESS || format('https://{0}.github.io/{1}/', "
              "github.repository_owner, github.event.repository.name) }}");
    }
    CHECK(builds == 1);
}

TEST_CASE("the container and the workflow of docs/ci.md name what they start from by digest") {
    std::size_t images = 0, actions = 0;
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/packaging/Containerfile"))) {
        if (!line.starts_with("FROM ")) continue;
        ++images;
        CHECK(has_digest(line.substr(0, line.find(' ', 5))));
    }
    CHECK(images == 2);
    const std::regex step("\\n +- uses: (actions/[^ \n]+)");
    const std::string page = read_file(SOURCE_DIR "/docs/ci.md");
    for (std::sregex_iterator i(page.begin(), page.end(), step), end; i != end; ++i, ++actions)
        CHECK(is_pinned((*i)[1]));
    CHECK(actions >= 1);
}
