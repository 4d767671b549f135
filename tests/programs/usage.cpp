// plprove where people call it otherwise than it expects.
#include "tests/support/programs.h"

TEST_CASE("a problem may begin with a dash, wherever it stands") {
    const std::string problem = "-/P/P + 3*P/P/P + P/-/P";
    const std::string quoted = "'" + problem + "'";
    const Outcome plain = run(plprove + " problem " + quoted);
    CHECK(plain.status == 0);
    CHECK(plain.out.starts_with("problem     " + problem + "\n"));
    CHECK(run(plprove + " problem -- " + quoted).out == plain.out);
    const Outcome json = run(plprove + " problem " + quoted + " --json");
    CHECK(json.status == 0);
    CHECK(contains(json.out, "\"problem\": \"" + problem + "\""));
    CHECK(run(plprove + " problem --json " + quoted).out == json.out);
    CHECK(contains(run(plprove + " show " + quoted + " --svg -").out,
                   "<title>" + problem + "</title>"));
    CHECK(contains(run(plprove + " certify " + quoted).out, "\nproblem " + problem + "\n"));
    for (const std::string option : {"--macaulay2", "--julia"}) {
        const Outcome script = run(plprove + " export " + option + " " + quoted);
        CHECK(script.status == 0);
        CHECK(script.out == run(plprove + " export " + option + "=" + quoted).out);
    }
}

TEST_CASE("problems that list prints in notation are problems for the other commands") {
    const TemporaryFolder folder;
    const auto list = (folder / "list").string();
    CHECK(run(plprove +
              " list --terminal --points 11 --format notation | grep '^-' | head -n 20 >" + list)
              .status == 0);
    const std::vector<std::string> problems = lines_of(read_file(list));
    CHECK(!problems.empty());
    for (const std::string& problem : problems) {
        CAPTURE(problem);
        CHECK(contains(run(plprove + " problem '" + problem + "'").out, "verdict     minimal"));
    }
}

TEST_CASE("wrong usage is answered with what to write instead") {
    struct Answer {
        const char* arguments;
        const char* part;
    };
    const Answer answers[] = {
        {"", "`plprove --help` lists all commands"},
        {"--versoin", "did you mean --version?"},
        {"problm 2394", "did you mean `plprove problem`?"},
        {"frobnicate", "`plprove --help` lists all commands"},
        {"list --degre 3", "did you mean --degree?"},
        {"list --fromat=csv", "did you mean --format?"},
        {"list nonsense", "did not expect 'nonsense': `plprove list --help`"},
        {"problem P/P/P + a/a/a", "put it into quotes, such as plprove problem 'P/P/P"},
        {"problem", "PROBLEM is required: `plprove problem --help`"},
        {"problem 2394 --certificat x", "did you mean --certificate?"},
        {"problem 2394 -x", "has no option '-x': `plprove problem --help`"},
        {"degree 2394 --seed -1", "from 0 to 18446744073709551615, found '-1'"},
        {"degrees -o x --seed 1e5", "from 0 to 18446744073709551615, found '1e5'"},
        {"degree 2394 --target 0", "1 to 1000000"},
        {"'\033[2J'", "there is no command this"},
        {"problem 2394 '--\033[2J'", "has no option this"},
    };
    for (const Answer& answer : answers) {
        CAPTURE(answer.arguments);
        const Outcome outcome = run(plprove + " " + answer.arguments);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.starts_with("plprove: "));
        CHECK(lines_of(outcome.err).size() == 1);
        CHECK_MESSAGE(contains(outcome.err, answer.part), outcome.err);
    }
}

TEST_CASE("the help shows each way to name a problem, and each way works") {
    const std::string help = run(plprove + " problem --help").out;
    int shown = 0;
    for (const std::string& line : lines_of(help)) {
        if (!line.starts_with("  plprove problem ") || contains(line, "--certificate")) continue;
        CAPTURE(line);
        ++shown;
        const std::string word = line.substr(std::string("  plprove problem ").size());
        const bool in_quotes = word.starts_with("'");
        const std::size_t end = word.find(in_quotes ? '\'' : ' ', 1);
        const std::string spec = in_quotes ? word.substr(1, end - 1) : word.substr(0, end);
        CHECK(run(plprove + " problem '" + spec + "'").status == 0);
    }
    CHECK(shown == 8);
    CHECK(contains(help, "{{0,1},{{{1,1},{1,1,1}}"));
    for (const char* name : {"Chicago", "Cleveland", "five-point", "3002_1", "P3P+five-point"})
        CHECK(contains(help, name));
}

TEST_CASE("what is no problem comes with the column or the name, and with where to read on") {
    const Outcome outcome = run(plprove + " problem 'P/P/Q'");
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "column 5: found 'Q'"));
    CHECK(contains(outcome.err, "`plprove problem --help`"));
    CHECK(contains(run(plprove + " degree chicgo").err, "did you mean Chicago?"));
}
