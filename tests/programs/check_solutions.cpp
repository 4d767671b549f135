// Degrees of problems in general: what plprove writes, plcheck replays; and what plcheck says of
// files of solutions that hold, that are altered, and that lack what is expected.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <sstream>

namespace {

/// The file that FORMAT.md, section 14, shows.
std::string example() {
    const std::string format = read_file(certs + "FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 solutions\n") + 1;
    return format.substr(start, format.find("```", start) - start);
}

/// A line of certs/family-degrees.csv; `certified` is 0 if the column is empty.
struct OnFile {
    std::string family, problem;
    int degree = 0, certified = 0;
    bool is_exact = false;   // by certificates, by theorem or by the label class
    bool by_theorem = false; // no certificate of an upper bound is needed
    bool by_digest = false;  // of its certificate only the digest is committed
};

std::vector<OnFile> degrees_on_file() {
    std::vector<OnFile> degrees;
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        if (line.starts_with("#") || line.starts_with("family,")) continue;
        std::istringstream columns(line);
        std::string degree, bound, status, certified, source;
        OnFile& row = degrees.emplace_back();
        for (std::string* column :
             {&row.family, &row.problem, &degree, &bound, &status, &certified, &source})
            std::getline(columns, *column, ',');
        row.degree = std::stoi(degree);
        row.certified = certified.empty() ? 0 : std::stoi(certified);
        row.is_exact = status == "certified";
        row.by_theorem = source.starts_with("by theorem");
        row.by_digest = source.starts_with("a sweep: ");
    }
    return degrees;
}

/// The degrees that certs/family-degrees.csv calls certified by certificates.
std::map<std::string, int> degrees_by_certificates() {
    std::map<std::string, int> degrees;
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        if (line.starts_with("#") || !contains(line, "certificates; ")) continue;
        std::istringstream columns(line);
        std::string family, problem, degree;
        std::getline(columns, family, ',');
        std::getline(columns, problem, ',');
        std::getline(columns, degree, ',');
        degrees[problem] = std::stoi(degree);
    }
    return degrees;
}

/// What plcheck reports of the committed files on all families: once, as it takes seconds.
const nlohmann::json& report_on_families() {
    static const Outcome outcome =
        run("cd " + certs + " && " + plcheck +
            " --json plmp.plc projective.plc families/*.plc solutions/*.plc");
    REQUIRE(outcome.status == 0);
    static const nlohmann::json report = nlohmann::json::parse(outcome.out);
    return report;
}

} // namespace

TEST_CASE("the file of solutions in FORMAT.md holds") {
    const TemporaryFolder folder;
    write_file(folder / "seven.plc", example());
    const Outcome outcome = run("cd " + folder.path().string() + " && " + plcheck + " seven.plc");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "seven.plc: 1 solution record holds, 0 refused\n"
                         "- projective: 7*P/P: certified at least 3 solutions\n"
                         "VERIFIED: at least 3 solutions of projective: 7*P/P (seven.plc)\n");
    CHECK(outcome.err.empty());
}

TEST_CASE(
    "every degree of the families up to 2,000 is certified as a lower bound, and the tables of "
    "the families say so") {
    std::map<std::string, int> certified, expected;
    const nlohmann::json& report = report_on_families();
    for (const auto& file : report["files"])
        if (file.contains("solutions"))
            for (const auto& record : file["solutions"])
                certified[record["problem"]] = record["certified_at_least"];
    std::map<std::string, std::map<int, int>> tables, expected_tables;
    std::map<std::string, int> exact, expected_exact;
    const std::string large = read_file(certs + "solutions/large/projective-at-most-large.plc");
    constexpr int most = 2000; // solutions, of what has a file
    for (const OnFile& row : degrees_on_file()) {
        if (row.degree > most) continue;
        CHECK(row.certified == row.degree);
        if (row.by_digest) continue;
        expected[row.problem] = row.certified;
        ++expected_tables[row.family][row.certified];
        const bool needs_large_file =
            !row.by_theorem && contains(large, "\nproblem " + row.problem + '\n');
        expected_exact[row.family] += row.is_exact && !needs_large_file ? 1 : 0;
    }
    for (const auto& table : report["families"]) {
        exact[table["family"]] = table["exact"];
        expected_exact[table["family"]] += 0; // of some families no degree is on file
        for (const auto& bound : table["lower_bounds"])
            tables[table["family"]][bound[0]] = bound[1];
    }
    CHECK(certified.size() > 300);
    CHECK(certified == expected);
    CHECK(tables == expected_tables);
    CHECK(exact == expected_exact);
}

TEST_CASE("the committed upper bounds are the degrees on file that certificates make exact") {
    const std::map<std::string, int> expected = degrees_by_certificates();
    std::map<std::string, int> found;
    for (const auto& file : report_on_families()["files"])
        if (file.contains("upper_bounds"))
            for (const auto& record : file["upper_bounds"])
                found[record["problem"]] = record["certified_at_most"];
    CHECK(found.size() > 40);
    for (const auto& [problem, at_most] : found) {
        CAPTURE(problem);
        REQUIRE(expected.contains(problem));
        CHECK(at_most == expected.at(problem));
    }
    std::size_t of_large_files = 0;
    for (const std::string& line :
         lines_of(read_file(certs + "solutions/large/projective-at-most-large.plc")))
        of_large_files += line.starts_with("problem ");
    CHECK(found.size() + of_large_files == expected.size());
}

TEST_CASE("the table of a family counts the problems with certified solutions, whatever the names "
          "of their points and lines") {
    const TemporaryFolder folder;
    write_file(folder / "seven.plc", example());
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    const std::string family = plcheck + " " + certs + "projective.plc";
    CHECK(contains(run(in_folder + family + " seven.plc").out,
                   "\nsolutions certified for 1 minimal problem, at least (number of problems):\n"
                   "  3 (1)\n"));
    CHECK(!contains(run(family).out, "solutions certified"));
    const std::string other = "projective: 4*P/P + 3*PX/PX"; // 3*PL/PL + 4*P/P there
    REQUIRE(run(in_folder + plprove + " degree '" + other + "' -o other.plc").status == 0);
    CHECK(contains(run(in_folder + family + " other.plc seven.plc").out,
                   "for 2 minimal problems, at least (number of problems):\n  2 (1), 3 (1)\n"));
}

TEST_CASE("what the prover writes of a degree in general, the checker certifies") {
    const TemporaryFolder folder;
    const std::string file = (folder / "one.plc").string();
    for (const auto& [problem, degree, is_exact, other] :
         {std::tuple{"projective: 7*P/P", 3, true, "projective:7*P/P"},
          {"projective: 3*PL/PL + 4*P/P", 2, true, "projective: 4*P/P + 3*PX/PX"},
          {"3*PL/PL + 2*P/P", 16, true, "2*P/P + 3*PL/PL"},
          {"upright: 3*PL/PL", 4, true, "upright: 3*PX/PX"},
          {"upright-focal: 3*PL/PL/PL + a/a/a", 7, true, "upright-focal: a/a/a + 3*PX/PX/PX"},
          {"focal: 3*PL/PL/PL + Pabc/Pabc/Pabc", 30, true, "focal: Pabc/Pabc/Pabc + 3*PX/PX/PX"},
          {"focal: 2*PL/PL/PL + PLa/PLa/PLa + P/P/P + a/a/a", 164, false,
           "focal: a/a/a + P/P/P + PXa/PXa/PXa + 2*PX/PX/PX"}}) {
        CAPTURE(problem);
        const Outcome written = run(plprove + " degree '" + problem + "' -o " + file);
        REQUIRE(written.status == 0);
        CHECK(contains(written.out, "of at least " + std::to_string(degree) + " solutions"));
        for (const std::string notation : {problem, other}) {
            const std::string expect = plcheck + " --quiet --expect '" + notation + "' ";
            const std::string number = std::to_string(degree);
            CHECK(run(expect + "--degree '>=" + number + "' " + file).status == 0);
            CHECK(run(expect + "--verdict minimal " + file).status == 0);
            const Outcome more =
                run(expect + "--degree '>=" + std::to_string(degree + 1) + "' " + file);
            CHECK(more.status == 1);
            CHECK(contains(more.out, number + " solutions are certified"));
            const Outcome exactly = run(expect + "--degree " + number + " " + file);
            CHECK(exactly.status == (is_exact ? 0 : 1));
            CHECK(contains(exactly.out, "no upper bound") == !is_exact);
        }
        const Outcome absent =
            run(plcheck + " --expect 'projective: 9*a/a/a' --degree '>=1' " + file);
        CHECK(absent.status == 1);
        CHECK(contains(last_line(absent.out), "add a file of solutions"));
    }
}

TEST_CASE("a minimal problem whose points and lines allow one solution has exactly one, and --why "
          "names the theorem") {
    const std::string expect = plcheck + " --why --quiet --expect 'projective: 3*PL/PL/PL + "
                                         "5*a/a/a' --degree ";
    const Outcome one = run(expect + "1 " + certs + "projective.plc");
    CHECK(one.status == 0);
    CHECK(contains(one.out, "a minimal problem has a solution"));
    CHECK(contains(one.out, "at most 1, by Theorem 16 of proofs/families.md"));
    const Outcome two = run(expect + "2 " + certs + "projective.plc");
    CHECK(two.status == 1);
    CHECK(contains(two.out, "exactly 1 solutions are certified"));
    const Outcome without = run(expect + "1 " + certs + "plmp.plc");
    CHECK(without.status == 1);
}

TEST_CASE("a problem with three points on a line has exactly the degree of Theorem A, and no other "
          "degree is verified") {
    const auto judged = [](int degree) {
        return run("cd " + certs + " && " + plcheck + " --why --quiet --expect '3*PL/PL + 2*P/P' " +
                   "--degree " + std::to_string(degree) + " plmp.plc solutions/plmp.plc");
    };
    const Outcome right = judged(16);
    CHECK(right.status == 0);
    CHECK(contains(right.out, "at most 16, by Theorem A of proofs/calibrated_collinear_points.md"));
    for (const int wrong : {12, 20}) {
        const Outcome refused = judged(wrong);
        CHECK(refused.status == 1);
        CHECK(contains(refused.out, "exactly 16 solutions are certified"));
    }
}

TEST_CASE("the same seed writes the same bytes, to a file or alone on standard output") {
    const std::string command = plprove + " degree 'projective: 7*P/P' --seed 4 -o ";
    const TemporaryFolder folder;
    const std::string file = (folder / "one.plc").string();
    REQUIRE(run(command + file).status == 0);
    CHECK(run(command + "-").out == read_file(file));
}

TEST_CASE("an altered file of solutions is refused with status 1 or 2") {
    const TemporaryFolder folder;
    const std::string file = (folder / "altered.plc").string();
    const auto judged = [&](const char* old, const char* replacement) {
        write_file(file, with(example(), old, replacement));
        return run(plcheck + " " + file);
    };
    CHECK(judged("view 31 80 -3", "view 31 80 0").status == 1);
    CHECK(judged("view 31 80 -3", "view 31 80").status == 2);
    CHECK(judged("projective: 7*P/P", "projective: 8*P/P").status == 2);
    CHECK(judged("projective: 7*P/P", "projective: 6*P/P").status == 2);
    CHECK(judged("real 5", "pair 5").status == 2);
    for (const std::string kind :
         {"solutions", "at-most", "problems\nmodulus 2305843009213693951"}) {
        CAPTURE(kind);
        write_file(file, "plcert 2 " + kind + "\n");
        const Outcome empty = run(plcheck + " " + file);
        CHECK(empty.status == 1);
        CHECK(contains(empty.err, "it has no record, so it proves nothing"));
    }
}

TEST_CASE("--at-least N certifies N solutions, the same bytes each time, or writes nothing") {
    const TemporaryFolder folder;
    const std::string file = (folder / "some.plc").string();
    const std::string problem = "'projective: Pab/Pab/Pab/Pab/Pab/Pab/Pab/Pab + 4*a/a/a/a/a/a/a/a'";
    const auto command = [&](int solutions) {
        return plprove + " degree " + problem + " --at-least " + std::to_string(solutions);
    };
    constexpr int degree = 38, some = 20;
    REQUIRE(run(command(some) + " -o " + file).status == 0);
    CHECK(run(command(some) + " -o -").out == read_file(file));
    const std::string expect = plcheck + " --quiet --expect " + problem + " --degree '>=";
    CHECK(run(expect + std::to_string(some) + "' " + file).status == 0);
    const Outcome too_many = run(command(degree + 1) + " -o " + file + ".more");
    CHECK(too_many.status == 1);
    CHECK(contains(too_many.err, "a certificate of only 38 solutions: try another --seed"));
    CHECK(read_file(file + ".more").empty());
}
