// The groups that fibres of models show (FORMAT.md, section 16), and what shows none.
#include "checker/conclusion/models.h"
#include "checker/model/program.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// The fibre of x^8 - x = a, t being x.
std::string fibre(std::uint64_t a) {
    return say("fibre 8\ndata ", a, "\npolynomial ", modulus - a, ' ', modulus - 1,
               " 0 0 0 0 0 0\nunknown 0 1 0 0 0 0 0 0\nseparated by 1\n");
}

/// Cycles modulo q by the second checker: of 8; of 1, 2 and 5; of 3 and 5.
constexpr std::uint64_t whole = 1, odd_five = 3, five = 12;

const std::string elimination =
    "elimination\ndata 1\ndegree 8 in x\nbasis 1 2 3 4 5 6 7 8\nrows 1 1\nminor 1\n";

/// A file with these statements after the unknown.
std::string file_of(const std::string& statements, const std::string& records) {
    return "model octic\ndata a\nunknown x\n" + statements + "modulus 2305843009213693951\n" +
           records;
}

std::string octic(const std::string& records) {
    return file_of("equation x ^ 8 - x = a\n", records);
}

ModelFile outcome(const std::string& text, std::uint64_t effort = usual_effort) {
    Reader reader(text);
    return replay_model(reader, {.effort = effort});
}

std::string group_of(const std::string& text) {
    const ModelFile file = outcome(text);
    CHECK(file.refusals.count == 0);
    CHECK(file.at_least == 8);
    CHECK(file.at_most == 8);
    return file.group();
}

/// What is missing, if this group is expected of files of this model.
std::string verdict(const std::vector<std::string>& files, const std::string& group) {
    Findings findings;
    for (const std::string& text : files)
        findings.files.push_back({.name = "octic.plc", .content = outcome(text)});
    findings.objections.resize(files.size());
    ExpectedModel expected{
        .file = "octic.model",
        .text = lines_of_model(files.front().substr(0, files.front().find("modulus")))};
    expected.group = group;
    const Judgement judgement = judge(findings, expected);
    CHECK(judgement.verified == !contains(judgement.statement, ": "));
    return judgement.statement;
}

} // namespace

TEST_CASE("two fibres show the group of a model") {
    const std::string symmetric = octic(fibre(whole) + fibre(five) + elimination);
    CHECK(group_of(symmetric) == "S8");
    CHECK(group_of(octic(fibre(whole) + fibre(odd_five) + elimination)) == ">=A8");
    CHECK(group_of(octic(fibre(five) + fibre(odd_five) + elimination)).empty());
    CHECK(group_of(octic(fibre(five) + elimination)).empty());
    CHECK(group_of(octic(fibre(five) + fibre(five) + elimination)).empty());
    CHECK(verdict({symmetric}, "S8") == "octic.model has the group S8");
    CHECK(verdict({symmetric}, ">=A8") == "octic.model has a group that contains A8");
    CHECK(verdict({symmetric}, "S9") ==
          "octic.model has the group S9: the group is certified to be S8");
    CHECK(verdict({octic(fibre(whole) + fibre(odd_five) + elimination)}, "S8") ==
          "octic.model has the group S8: the group is certified to be >=A8");
    CHECK(verdict({octic(fibre(whole) + elimination)}, "S8") ==
          "octic.model has the group S8: no fibres certify its group; add the file that plprove "
          "group octic.model -o FILE writes");
    CHECK(in_words(ProvedModel{
              .name = "m", .at_least = 8, .at_most = 8, .cycle_types = {{8}, {3, 5}}}) ==
          "m has exactly 8 solutions, and has the group S8");
}

TEST_CASE("a group needs an upper bound, perhaps by another file, and fibres that hold") {
    const std::string fibres = octic(fibre(whole) + fibre(five));
    CHECK(outcome(fibres).cycle_types == std::vector<CycleType>{{8}, {3, 5}});
    CHECK(outcome(fibres).group().empty());
    CHECK(contains(verdict({fibres}, "S8"), "no fibres certify"));
    CHECK(verdict({fibres, octic(elimination)}, "S8") == "octic.model has the group S8");
    const std::string wrong = with(fibre(five), "unknown 0 1", "unknown 0 2");
    const ModelFile file = outcome(octic(fibre(whole) + wrong + elimination));
    CHECK(file.refusals.count == 1);
    CHECK(file.group().empty());
}

TEST_CASE("solutions that do not move with the data have no group") {
    // Over the rational numbers all permutations occur: the Galois group of x^8 - x - 12 is S8.
    const std::string equation = "equation x ^ 8 - x = 12\n";
    const std::string one = fibre(five), other = with(one, "data 12", "data 1");
    CHECK(group_of(file_of(equation, one + other + elimination)).empty());
    // The same solutions, with t = 2 x: other numbers, the same cycles. g = t^8 - 128 t - 3072.
    const std::string twice =
        say("fibre 8\ndata 1\npolynomial ", modulus - 3072, ' ', modulus - 128,
            " 0 0 0 0 0 0\nunknown 0 ", std::uint64_t{1} << 60, " 0 0 0 0 0 0\nseparated by 2\n");
    CHECK(outcome(file_of(equation, one + twice)).cycle_types ==
          std::vector<CycleType>{{3, 5}, {3, 5}});
    CHECK(group_of(file_of(equation, one + twice + elimination)).empty());
}

TEST_CASE("a group is of the values that count, where solutions share them") {
    const auto counted = [](const std::string& what, const std::string& records) {
        return file_of("let s = x * x\nequation x ^ 8 - x = a\ncount " + what + "\n", records);
    };
    const auto distinct = [](std::uint64_t a) { return fibre(a) + "distinct 8 by 1\n"; };
    CHECK(group_of(counted("x", distinct(whole) + distinct(five) + elimination)) == "S8");
    // 16 solutions, of which two each have the same square.
    const auto squares = [](std::uint64_t a) {
        std::string zeros;
        for (int i = 0; i < 13; ++i)
            zeros += " 0";
        return say("fibre 16\ndata ", a, "\npolynomial ", modulus - a, " 0 ", modulus - 1, zeros,
                   "\nunknown 0 1 0", zeros, "\nseparated by 1\ndistinct 8 by 1\n");
    };
    const ModelFile file =
        outcome(file_of("let s = x * x\nequation s ^ 8 - s = a\ncount s\n",
                        squares(whole) + squares(five) + with(elimination, "in x", "in s")));
    CHECK(file.refusals.count == 0);
    CHECK(file.at_least == 8);
    CHECK(file.at_most == 8);
    CHECK(file.cycle_types == std::vector<CycleType>{{8}, {3, 5}});
    CHECK(file.group() == "S8");
    // Seven values, of at most eight: the eighth may be any.
    const auto fewer = [&](std::uint64_t a) {
        return with(distinct(a), "distinct 8", "distinct 7");
    };
    const ModelFile seven = outcome(counted("x", fewer(whole) + fewer(five) + elimination));
    CHECK(seven.refusals.count == 0);
    CHECK(seven.at_least == 7);
    CHECK(seven.cycle_types.empty());
}

TEST_CASE("cycles take an effort") {
    const std::string text = octic(fibre(whole) + fibre(five));
    CHECK(outcome(text, 2).refusals.count == 0);
    CHECK(outcome(text, 1).refusals.count == 1);
}
