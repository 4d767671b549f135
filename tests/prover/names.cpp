// Names of problems, and misspelled words.
#include "prover/problem/names.h"
#include "prover/minimal/decision.h"
#include "prover/problem/spec.h"
#include "prover/system/words.h"

#include <doctest/doctest.h>
#include <map>
#include <set>

using namespace plprove;

namespace {

std::string message_on(const std::string& spec) {
    try {
        parse_spec(spec);
    } catch (const NotationError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("the names in PLMP are those that the numbers of points and lines make") {
    std::set<std::string> computed;
    for (const Signature& signature : label_classes())
        if (obstruction(problem_of(signature)).deficiency() == 0)
            if (const auto name = families(signature).plmp) computed.insert(*name);
    CHECK(computed.size() == 12);
    for (const std::string& name : computed) {
        CAPTURE(name);
        const auto problem = problem_named(name);
        REQUIRE(problem);
        CHECK(decide(*problem).families->plmp == name);
    }
}

TEST_CASE("every name means a minimal problem, and the registrations are such") {
    std::set<std::string_view> names;
    int registrations = 0;
    for (const NamedProblem& named : named_problems()) {
        CAPTURE(named.name);
        CHECK(names.insert(named.name).second);
        const Features problem = parse_features(named.notation);
        CHECK(notation(problem) == named.notation);
        CHECK(decide(problem).verdict == Verdict::minimal);
        CHECK(parse_spec(named.name) == problem);
        if (!named.name.ends_with("+five-point")) continue;
        ++registrations;
        CHECK(decide(problem).families->registration);
        CHECK(decide(problem).families->pl0p);
    }
    CHECK(registrations == 4); // the paper's
    CHECK(decide(parse_spec("Chicago")).families->plmp == "3002_1");
    CHECK(decide(parse_spec("Cleveland")).families->plmp == "3010_0");
}

TEST_CASE("names do not depend on case and blanks") {
    CHECK(parse_spec("CHICAGO") == parse_spec("2394"));
    CHECK(parse_spec(" p3p + Five-Point ") == parse_spec("#6724"));
    CHECK(!problem_named("Chicag"));
    CHECK(!problem_named(""));
}

TEST_CASE("what is no problem is answered with what to write") {
    const std::map<std::string, std::string> answers{
        {"Chicgo", "did you mean Chicago?"},
        {"3002_3", "did you mean"},
        {"foo", "one of the names Chicago, Cleveland"},
        {"x", "notation has a '/' between views"},
        {"p/p/p", "a capital P for a point"},
        {"Pz/Pz/Pz", "without gaps"},
        {"/", "'-' for nothing"},
        {"\xce\xb1/P/P", "found U+03B1 (no ASCII)"},
        {"P/P/\xe2\x88\x92", "column 5: found U+2212"},
        {"P/\xf0\x9d\x9c\xb6", "found U+1D736"},
        {"P/\xce", "the byte 206"},
        {"P/\xce/", "the byte 206"},
        {"", "such as '2*Pa/Pa/Pa + P/P/P', 2394 or Chicago"},
    };
    for (const auto& answer : answers) {
        const std::string message = message_on(answer.first);
        CAPTURE(answer.first);
        CAPTURE(message);
        CHECK(message.find(answer.second) != std::string::npos);
    }
    // What is not fit for a terminal is not repeated.
    CHECK(message_on("\x1b[2J").starts_with("this is no name"));
    CHECK(message_on(std::string(5000, 'q')).size() < 500);
}

TEST_CASE("a misspelled word is near the one that was meant") {
    const std::vector<std::string> words{"problem", "certify", "degree", "degrees", "list"};
    CHECK(most_similar("problm", words) == "problem");
    CHECK(most_similar("PROBLEM", words) == "problem");
    CHECK(most_similar("certfiy", words) == "certify");
    CHECK(most_similar("degre", words) == "degree");
    CHECK(most_similar("lst", words) == "list");
    CHECK(!most_similar("frobnicate", words));
    CHECK(!most_similar("", words));
    CHECK(!most_similar(std::string(100'000, 'x'), words));
}

TEST_CASE("what others wrote is printed so that it leaves the terminal alone") {
    CHECK(printable("plain text", 20) == "plain text");
    CHECK(printable("a\x1b[2J\n\xc3\xa4", 20) == "a?[2J???");
    CHECK(printable("0123456789", 4) == "0123...");
    CHECK(!has_control_character("S\xc3\xbc"
                                 "d, \xe2\x82\xac"));
    for (const char* text : {"\x1b[2J", "a\nb", "\x7f", "\xc2\x9b"})
        CHECK(has_control_character(text));
}
