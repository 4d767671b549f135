// The action for workflows of GitHub: the workflow that docs/ci.md shows is read, and the steps of
// action.yml are run with its inputs, as a runner would.
#include "tests/packaging/installation.h"

#include <doctest/doctest.h>
#include <map>
#include <regex>
#include <yaml-cpp/yaml.h>

namespace {

namespace fs = std::filesystem;

using Inputs = std::map<std::string, std::string>;

const YAML::Node& action() {
    static const YAML::Node node = YAML::LoadFile(SOURCE_DIR "/action.yml");
    return node;
}

/// What the workflow of docs/ci.md passes to the action.
Inputs inputs_of_the_page() {
    const std::string page = read_file(SOURCE_DIR "/docs/ci.md");
    const std::size_t start = page.find("```yaml\n") + 8;
    const YAML::Node workflow = YAML::Load(page.substr(start, page.find("```", start) - start));
    for (const YAML::Node& step : workflow["jobs"]["check"]["steps"]) {
        if (step["uses"].as<std::string>().starts_with("actions/")) continue;
        return step["with"].as<Inputs>();
    }
    FAIL("the workflow of docs/ci.md does not use the action");
    return {};
}

/// All inputs of the action, those that are not given by their defaults.
Inputs complete(const Inputs& given) {
    Inputs all;
    for (const auto& input : action()["inputs"]) {
        const std::string name = input.first.as<std::string>();
        const bool required = input.second["required"] && input.second["required"].as<bool>();
        REQUIRE((!required || given.contains(name)));
        all[name] = input.second["default"] ? input.second["default"].as<std::string>() : "";
    }
    for (const auto& [name, value] : given) {
        CAPTURE(name);
        REQUIRE(all.contains(name));
        all[name] = value;
    }
    return all;
}

/// The text with each `${{ inputs.NAME }}` replaced; nothing else may stand in such braces.
std::string substituted(std::string text, const Inputs& inputs) {
    for (const auto& [name, value] : inputs) {
        const std::string expression = "${{ inputs." + name + " }}";
        for (std::size_t at; (at = text.find(expression)) != std::string::npos;)
            text.replace(at, expression.size(), value);
    }
    REQUIRE(text.find("${{") == std::string::npos);
    return text;
}

std::string quoted(const std::string& text) {
    return "'" + std::regex_replace(text, std::regex("'"), "'\\''") + "'";
}

/// What CMake is told by the environment: not to compile again what this build has like the action.
std::string compiled_before() {
    if (!fs::exists(BUILD_DIR "/build.ninja") || !has_program("python3")) return {};
    return " CMAKE_GENERATOR=Ninja CMAKE_CXX_COMPILER_LAUNCHER='python3;" SOURCE_DIR
           "/tests/packaging/compiled_before.py;" BUILD_DIR "'";
}

/// Runs one step in the workspace, with `sudo` replaced by a program that writes down its words.
Outcome run_step(const YAML::Node& step, const Inputs& inputs, const TemporaryFolder& runner) {
    REQUIRE(step["shell"].as<std::string>() == "bash");
    write_file(runner / "step", step["run"].as<std::string>());
    std::string environment =
        "env PATH=" + (runner / "bin").string() +
        ":$PATH GITHUB_ACTION_PATH=" + SOURCE_DIR " RUNNER_TEMP=" + (runner / "temp").string() +
        compiled_before();
    for (const auto& variable : step["env"])
        environment += ' ' + variable.first.as<std::string>() + '=' +
                       quoted(substituted(variable.second.as<std::string>(), inputs));
    return run("cd " + (runner / "workspace").string() + " && " + environment +
               " bash --noprofile --norc -e -o pipefail " + (runner / "step").string());
}

/// A machine as a runner has it: an empty workspace, a folder for what is temporary.
void prepare(const TemporaryFolder& runner) {
    for (const char* folder : {"bin", "temp", "workspace"})
        fs::create_directory(runner / folder);
    write_file(runner / "bin/sudo",
               "#!/bin/sh\necho \"$@\" >>" + (runner / "sudo").string() + "\n");
    fs::permissions(runner / "bin/sudo", fs::perms::owner_all);
}

/// Runs all steps; the result is that of the last one. The others must succeed.
Outcome run_action(const Inputs& given, const TemporaryFolder& runner) {
    const Inputs inputs = complete(given);
    Outcome outcome;
    for (const YAML::Node& step : action()["runs"]["steps"]) {
        CAPTURE(step["name"].as<std::string>());
        CAPTURE(outcome.err);
        REQUIRE(outcome.status <= 0);
        outcome = run_step(step, inputs, runner);
    }
    return outcome;
}

} // namespace

TEST_CASE("the workflow of docs/ci.md checks a certificate, and fails for a bad one") {
    const TemporaryFolder runner;
    prepare(runner);
    const std::string in_workspace = "cd " + (runner / "workspace").string() + " && ";
    const std::string plprove = (installed() / "bin/plprove").string();
    REQUIRE(run(in_workspace + plprove + " certify 2394 -o mine.plc").status == 0);

    const Inputs inputs = inputs_of_the_page();
    const Outcome good = run_action(inputs, runner);
    CAPTURE(good.err);
    CHECK(good.status == 0);
    CHECK(good.out.find("\nVERIFIED: 2*Pa/Pa/Pa + P/P/P is minimal") != std::string::npos);
    const std::string asked_of_root = read_file(runner / "sudo");
    for (const char* package : {"g++", "cmake", "libgmp-dev", "libflint-dev"})
        CHECK(asked_of_root.find(package) != std::string::npos);

    const YAML::Node steps = action()["runs"]["steps"];
    const YAML::Node check = steps[steps.size() - 1];
    REQUIRE(run(in_workspace + "mkdir more && "
                               "cp mine.plc more/one.plc && cp mine.plc more/two.plc")
                .status == 0);
    const auto status_of = [&](const Inputs& given) {
        return run_step(check, complete(given), runner).status;
    };
    const Outcome several =
        run_step(check, complete({{"files", "mine.plc\nmore/*.plc\n"}}), runner);
    CHECK(several.status == 0);
    for (const char* file :
         {"mine.plc: certified", "more/one.plc: certified", "more/two.plc: certified"})
        CHECK(several.out.find(file) != std::string::npos);
    CHECK(status_of({{"files", "missing/*.plc"}}) == 2);
    CHECK(status_of({{"files", ""}}) == 3);

    const std::string chicago = "2*Pa/Pa/Pa + P/P/P";
    const std::string all = SOURCE_DIR "/certs/classification.plc";
    CHECK(status_of({{"files", "mine.plc"}, {"expect", chicago}, {"verdict", "not-minimal"}}) == 1);
    CHECK(status_of({{"files", "mine.plc"}, {"expect", chicago}, {"degree", "312"}}) == 0);
    CHECK(status_of({{"files", "mine.plc"}, {"expect", chicago}, {"degree", "311"}}) == 1);
    CHECK(status_of(
              {{"files", "mine.plc"}, {"expect", "3*P/P/P + a/a/a"}, {"verdict", "minimal"}}) == 1);
    CHECK(status_of({{"files", "mine.plc"}, {"verdict", "minimal"}}) == 3);
    CHECK(status_of({{"files", "mine.plc"}, {"classification", "true"}}) == 1);
    CHECK(status_of({{"files", all}, {"classification", "true"}}) == 0);

    REQUIRE(run(in_workspace + "sed -i '$ s/[0-9]*$/1/' mine.plc").status == 0);
    CHECK(run_step(check, complete(inputs), runner).status == 1);
}

TEST_CASE("a word for classification that nobody reads stops the action with what to write") {
    const TemporaryFolder runner;
    prepare(runner);
    const YAML::Node first = action()["runs"]["steps"][0];
    for (const char* word : {"yes", "True", "TRUE", "1", "", "true false", "true\nfalse"}) {
        CAPTURE(word);
        const Outcome outcome =
            run_step(first, complete({{"files", "a.plc"}, {"classification", word}}), runner);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.find("write true or false") != std::string::npos);
        CHECK(lines_of(outcome.out).size() == 1);
    }
    CHECK(run_step(first, complete({{"files", "a.plc"}}), runner).status == 0);
    for (const char* word : {"true", "false"})
        CHECK(run_step(first, complete({{"files", "a.plc"}, {"classification", word}}), runner)
                  .status == 0);
}

TEST_CASE("the action asks for packages after it has read the lists of them") {
    for (const YAML::Node& step : action()["runs"]["steps"]) {
        const std::string text = step["run"].as<std::string>();
        const std::size_t asks = text.find("apt-cache show");
        if (asks == std::string::npos) continue;
        CHECK(text.find("apt-get -qq update") < asks);
        return;
    }
    FAIL("no step asks for packages");
}
