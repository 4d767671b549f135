// What `cmake --install` puts on a machine: programs that run, their manual pages, documents whose
// links work.
#include "tests/packaging/installation.h"

#include <algorithm>
#include <cctype>
#include <doctest/doctest.h>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

/// What a program or a command of it prints for --help.
std::string help_of(const std::string& command_line) {
    const Outcome outcome = run((installed() / "bin").string() + "/" + command_line + " --help");
    REQUIRE(outcome.status == 0);
    return outcome.out;
}

/// The commands that `plprove --help` lists.
std::vector<std::string> commands() {
    std::vector<std::string> names;
    const std::string help = help_of("plprove");
    const std::string heading = "Subcommands:\n";
    std::string list = help.substr(help.find(heading) + heading.size());
    list.erase(list.find("\n\n"));
    for (const std::string& line : lines_of(list))
        names.push_back(line.substr(2, line.find(' ', 2) - 2));
    return names;
}

/// The command lines whose help has a manual page.
std::vector<std::string> pages() {
    std::vector<std::string> all{"plcheck", "plprove"};
    for (const std::string& command : commands())
        all.push_back("plprove " + command);
    return all;
}

fs::path page_file(std::string command_line) {
    const std::size_t blank = command_line.find(' ');
    if (blank != std::string::npos) command_line[blank] = '-';
    return installed() / "share/man/man1" / (command_line + ".1.gz");
}

/// Words and numbers in small letters, each as often as it occurs.
std::multiset<std::string> words_in(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::regex word("[a-z0-9]+");
    std::multiset<std::string> words;
    for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i)
        words.insert(i->str());
    return words;
}

/// The help's own headings; a manual page has others.
std::string without_headings(const std::string& help) {
    const std::regex headings("^(Usage|Positionals|Options|Subcommands|OPTIONS|SUBCOMMANDS):"
                              "|SUBCOMMAND$|\\[At least 1 of the following options are required\\]",
                              std::regex::multiline);
    return std::regex_replace(help, headings, "");
}

/// The files of the build that `cmake --install` takes without a component; of a folder of manual
/// pages, the file that says that it is made.
std::vector<std::string> taken_from_the_build() {
    const Outcome scripts =
        run("find " BUILD_DIR " -name cmake_install.cmake -exec grep -h ' FILES ' {} +");
    const std::regex path("\"" BUILD_DIR "/([^\"]+)\"");
    std::vector<std::string> files;
    for (std::sregex_iterator i(scripts.out.begin(), scripts.out.end(), path), end; i != end; ++i) {
        const std::string file = (*i)[1];
        if (file.find("pointline") != std::string::npos) continue; // the component `library`
        files.push_back(file.ends_with('/') ? file.substr(0, file.size() - 1) + ".stamp" : file);
    }
    return files;
}

} // namespace

TEST_CASE("installed programs run, and check the installed certificates") {
    const std::string certs = (installed() / "share/point-line-certificates/certs").string();
    const Outcome check = run((installed() / "bin/plcheck").string() + ' ' + certs +
                              "/classification.plc " + certs + "/models/registrations/*.plc");
    CHECK(check.status == 0);
    CHECK(check.out.find("143494") != std::string::npos);
    CHECK(run((installed() / "bin/plprove").string() + " problem 2394").status == 0);
    CHECK(run("cd " + certs + " && sha256sum --check --quiet SHA256SUMS").status == 0);
}

TEST_CASE("each program and each command has a manual page, and no other has") {
    std::set<fs::path> expected;
    for (const std::string& page : pages())
        expected.insert(page_file(page));
    CHECK(expected.size() > 10);
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(installed() / "share/man/man1"))
        found.insert(entry.path());
    CHECK(found == expected);
}

TEST_CASE("a manual page renders without a warning, and has all words of the help") {
    if (!has_program("groff")) {
        MESSAGE("left out: groff is not installed");
        return;
    }
    for (const std::string& page : pages()) {
        CAPTURE(page);
        const Outcome rendered = run("gzip -dc " + page_file(page).string() +
                                     " | groff -man -Tutf8 -wall -rHY=0 -P-cbou");
        CHECK(rendered.status == 0);
        CHECK(rendered.err == "");
        const std::multiset<std::string> words = words_in(rendered.out);
        const std::multiset<std::string> wanted = words_in(without_headings(help_of(page)));
        CHECK(wanted.size() > 20);
        for (const std::string& word : wanted) {
            CAPTURE(word);
            CHECK(words.count(word) >= wanted.count(word));
        }
    }
}

TEST_CASE("a manual page bears no date, and is made of a help that is the same on every run") {
    for (const std::string& page : pages()) {
        CAPTURE(page);
        const std::string bytes = read_file(page_file(page));
        CHECK(bytes.substr(4, 4) == std::string(4, '\0')); // when gzip was run
        const Outcome text = run("gzip -dc " + page_file(page).string());
        CHECK(text.out.find(" \"1\" \"\" \"") != std::string::npos);
        const std::string help = help_of(page);
        CHECK(help.size() > 100);
        for (int i = 0; i < 5; ++i)
            CHECK(help_of(page) == help);
    }
}

TEST_CASE("what ./reproduce builds is all that is installed") {
    if (!fs::exists(BUILD_DIR "/build.ninja")) {
        MESSAGE("left out: built without ninja");
        return;
    }
    const std::string commands = run("ninja -C " BUILD_DIR " -t commands installable").out;
    const std::vector<std::string> files = taken_from_the_build();
    CHECK(files.size() > 4);
    for (const std::string& file : files) {
        CAPTURE(file);
        // What CMake itself writes is there before anything is built.
        const bool is_built = run("ninja -C " BUILD_DIR " -t query " + file).status == 0;
        CHECK((!is_built || commands.find(file) != std::string::npos));
    }
}

TEST_CASE("no installed folder is empty: uninstall knows files, and the folders above them") {
    for (const auto& entry : fs::recursive_directory_iterator(installed())) {
        CAPTURE(entry.path().string());
        CHECK((!entry.is_directory() || !fs::is_empty(entry.path())));
    }
}

TEST_CASE("the links between the installed documents work") {
    const fs::path documents = installed() / "share/doc/point-line-certificates";
    const std::regex link(R"re(\]\(([^)#:]+\.md)[)#])re");
    std::size_t links = 0;
    for (const auto& entry : fs::recursive_directory_iterator(documents)) {
        if (entry.path().extension() != ".md") continue;
        const std::string text = read_file(entry.path());
        for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
            ++links;
            CAPTURE(entry.path().string());
            CAPTURE((*i)[1].str());
            const fs::path target = (*i)[1].str();
            const bool of_tests = target.string().find("tests/") != std::string::npos;
            CHECK((of_tests || fs::exists(entry.path().parent_path() / target)));
        }
    }
    CHECK(links > 10);
}

TEST_CASE("what software centres read names the installed programs, and is valid") {
    const fs::path folder = installed() / "share/metainfo";
    const fs::path file = folder / "org.example.point_line_certificates.metainfo.xml";
    const std::string text = read_file(file);
    for (const auto& entry : fs::directory_iterator(installed() / "bin"))
        CHECK(text.find("<binary>" + entry.path().filename().string() + "</binary>") !=
              std::string::npos);
    CHECK(text.find("version=\"" PROJECT_VERSION "\"") != std::string::npos);
    CHECK(text.find("<summary>Certified classification of point-line minimal problems</summary>") !=
          std::string::npos);
    if (!has_program("appstreamcli")) {
        MESSAGE("left out: appstreamcli is not installed");
        return;
    }
    const Outcome outcome = run("appstreamcli validate --no-net --pedantic " + file.string());
    CAPTURE(outcome.out);
    CHECK(outcome.status == 0);
}
