// Hostile files: whatever plcheck is given, it answers soon, in bounded memory, with the status
// that its help documents, and with a message that names file and line and is fit for a terminal.
#include "tests/support/programs.h"
#include "tests/support/sanitized.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace {

const std::string head = "plcert 2 classification\nmodulus 2305843009213693951\n";
const std::string cameras = "camera 2 quaternion 1 2 3 4 translation 1 2 3\n"
                            "camera 3 quaternion 4 3 2 1 translation 3 2 1\n";

/// Half a gigabyte of address space and a minute of processor time are enough for everything: the
/// largest files take a tenth of both. The system ends a program that takes more. A sanitizer needs
/// terabytes, and makes everything slower.
const std::string bounded = sanitized ? "ulimit -t 1200; " : "ulimit -v 500000; ulimit -t 60; ";

bool fit_for_a_terminal(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; });
}

/// Checks a shell command line that ends in plcheck: status, message, bounded time and memory.
void refused(const std::string& command, int status, const std::string& message) {
    CAPTURE(command);
    const Outcome outcome = run(bounded + command);
    CHECK(outcome.status == status);
    const std::string err = outcome.err.substr(0, 2000);
    CAPTURE(err);
    CHECK(outcome.err.find(message) != std::string::npos);
    CHECK(fit_for_a_terminal(outcome.err));
    CHECK(fit_for_a_terminal(outcome.out));
    CHECK(outcome.err.size() < 10'000);
}

/// Checks a file with this content.
void refused_bytes(const std::string& bytes, int status, const std::string& message) {
    const TemporaryFolder folder;
    write_file(folder / "hostile.plc", bytes);
    refused(plcheck + " " + (folder / "hostile.plc").string(), status, "hostile.plc:" + message);
}

/// What is written in a file, and the line at fault, or 0 where that does not matter.
struct Hostile {
    std::string bytes;
    int line = 0;
};

/// Checks all files with one start of the program, which takes most of the time.
void refused_all(const std::vector<Hostile>& files) {
    const TemporaryFolder folder;
    std::string command = plcheck;
    for (std::size_t i = 0; i < files.size(); ++i) {
        write_file(folder / std::to_string(i), files[i].bytes);
        command += " " + (folder / std::to_string(i)).string();
    }
    const Outcome outcome = run(bounded + command);
    CHECK(outcome.status == 2);
    CHECK(fit_for_a_terminal(outcome.err));
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string line = files[i].line == 0 ? "" : std::to_string(files[i].line) + ": ";
        const std::string place = (folder / std::to_string(i)).string() + ":" + line;
        CAPTURE(files[i].bytes.substr(0, 500));
        CHECK(outcome.err.find(place) != std::string::npos);
    }
}

/// Checks what a shell command prints, through a pipe.
void refused_pipe(const std::string& producer, int status, const std::string& message) {
    refused("(" + producer + ") 2>/dev/null | " + plcheck + " /dev/stdin", status, message);
}

} // namespace

TEST_CASE("bytes that are not text are refused with the line on which they stand") {
    refused_all({
        {""},
        {std::string("plcert 2 classification\nmodulus\0 23\n", 35), 2},
        {"plcert 2 classification\r\nmodulus 2305843009213693951\r\n", 1},
        {head + "\xff\xfe\x80\n", 3},
        {"\xef\xbb\xbfplcert 2 classification\n", 1},
        {"plcert 2 classification\n\x1b[2J\x1b]0;owned\x07\n", 2},
        {"plcert 2 classification\n# a comment with \x1b[31m colour\n", 2},
        {"plcert 2 problem\nproblem P/P\x1b[2J\n", 2},
        {std::string(1 << 20, '\0'), 1},
        {std::string(1 << 20, '\n'), 1},
        {std::string(1 << 20, ' '), 1},
        {head + "# " + std::string(20'000, 'x') + "\n", 3},
        {head + "# " + std::string(60 << 20, 'x'), 3},
    });
}

TEST_CASE("files of more than 64 MiB are refused, however long, before they are read to the end") {
    const TemporaryFolder folder;
    const std::string file = (folder / "sparse.plc").string();
    REQUIRE(run("truncate -s 64G " + file + " || truncate -s 4G " + file).status == 0);
    refused(plcheck + " " + file, 2, "sparse.plc:0: ");
    refused(plcheck + " /dev/zero", 2, "/dev/zero:0: ");
    const std::string too_large = "/dev/stdin:0: ";
    refused_pipe("yes", 2, too_large);
    refused_pipe("tr '\\0' x </dev/zero | head -c 1G", 2, too_large); // a line of a gigabyte
    refused_pipe("printf 'plcert 2 classification\\n'; yes '#'", 2, too_large);
}

TEST_CASE("a file of just 64 MiB is read") {
    refused_pipe("printf 'plcert 2 classification\\n'; yes '# comment' | head -c 67108830", 2,
                 "/dev/stdin:");
}

TEST_CASE("what is not a regular file is refused, or read like one") {
    const TemporaryFolder folder;
    refused(plcheck + " " + folder.path().string(), 2, "cannot read " + folder.path().string());
    refused(plcheck + " /dev/null", 2, "/dev/null:");
    refused(plcheck + " /no/such/file", 2, "cannot read /no/such/file");
    refused(plcheck + " ''", 2, "cannot read ");
    const std::string fifo = (folder / "fifo").string();
    REQUIRE(run("mkfifo " + fifo).status == 0);
    refused("yes garbage >" + fifo + " & " + plcheck + " " + fifo, 2, "fifo:0: ");
    REQUIRE(run("ln -s loop " + (folder / "loop").string()).status == 0);
    refused(plcheck + " " + (folder / "loop").string(), 2, "cannot read ");
    const std::string name = (folder / "a\nb\x1b[31m").string();
    write_file(name, "x\n");
    refused(plcheck + " '" + name + "'", 2, "\\x0ab\\x1b[31m:1: ");
}

TEST_CASE("numbers out of range are refused on their line") {
    const std::string pool = head + "pool 1\n";
    const std::string record = pool + cameras + "feature P/P/P point 1 2 3\n";
    const std::vector<std::string> numbers{"1000000000000000000",
                                           "9223372036854775807",
                                           "-9223372036854775808",
                                           "18446744073709551616",
                                           std::string(10'000, '9'),
                                           "1e3",
                                           "0x10",
                                           "+1",
                                           "-0",
                                           "01",
                                           "1.0",
                                           "nan"};
    std::vector<Hostile> files;
    for (const std::string& number : numbers) {
        files.push_back({head + "pool " + number + "\n", 3});
        files.push_back({pool + "camera 2 quaternion " + number + " 0 0 1 translation 1 0 0\n", 4});
        files.push_back({pool + cameras + "feature P/P/P point 1 2 " + number + "\n", 6});
        files.push_back({record + "minimal " + number + " 1 5\n", 7});
        files.push_back({record + "minimal 1 " + number + " 5\n", 7});
        files.push_back({record + "deficient 1 1 rank " + number + " excess 0 0 0 star 1\n", 7});
        files.push_back({record + "deficient 1 1 rank 10 excess 0 0 0 star 1\ndelete rows " +
                             number + " columns 1\n",
                         8});
        if (number != numbers[0]) files.push_back({record + "minimal 1 1 " + number + "\n", 7});
    }
    files.push_back({"plcert 1 classification\n", 1});
    files.push_back({"plcert 3 classification\n", 1});
    files.push_back({"plcert 2 classification\nmodulus 6\n", 2});
    refused_all(files);
}

TEST_CASE("a million pools, records, features or kernel vectors of garbage are refused soon") {
    const std::string start = "printf 'plcert 2 classification\\nmodulus 2305843009213693951\\n'; ";
    refused_pipe(start + "seq -f 'pool %.0f' 1 1000000", 2, "/dev/stdin:4: ");
    refused_pipe(start + "yes 'minimal 0 1 5' | head -n 1000000", 2, "/dev/stdin:4: ");
    refused_pipe(start + "seq -f 'minimal %.0f 1 5' 0 999999", 1, "/dev/stdin:3: refused");
    refused_pipe(start + "seq -f 'minimal %.0f 1 5' 999999 -1 0", 2, "/dev/stdin:4: ");
    const std::string pool = start + "printf 'pool 1\\n" + cameras + "'; ";
    refused_pipe(pool + "yes 'feature P/P/P point 1 2 3' | head -n 1000000", 2,
                 "/dev/stdin:1006: ");
    refused_pipe(pool + "echo 'feature P/P/P point 1 2 3'; "
                        "echo 'deficient 1 1 rank 10 excess 0 0 0 star 1'; "
                        "echo 'delete rows 1 columns 11'; echo 'minor 1'; "
                        "yes 'kernel 0 0 0 0 0 0 0 0 0 0 1' | head -n 1000000",
                 2, "/dev/stdin:21: ");
}

TEST_CASE("the most and the largest features and kernels that the format allows are checked soon") {
    std::string large = " point 999999 -999998 999997";
    for (int pin = 0; pin < 7; ++pin)
        large += " pin 99999" + std::to_string(pin) + " -99998" + std::to_string(pin) + " 999979";
    std::string pools = head;
    for (int pool = 1; pool <= 99; ++pool) {
        pools += "pool " + std::to_string(pool) + "\n" +
                 "camera 2 quaternion 999999 999998 -999997 999996 translation 999999 9 99\n"
                 "camera 3 quaternion 999989 -999988 999987 999986 translation 999979 99 9\n";
        for (int i = 0; i < 1000; ++i)
            pools += "feature Pabcdefg/Pabcdefg/Pabcdefg" + large + "\n";
    }
    refused_bytes(pools + "minimal 0 1 1\n", 1, "");

    std::string kernels = head + "pool 1\n" + cameras + "feature Pabcdefg/Pabcdefg/Pabcdefg" +
                          large + "\nfeature Pa/Pa/Pa point 1 2 3 pin 4 5 6\n";
    for (int record = 0; record < 500; ++record) {
        kernels += "deficient " + std::to_string(record) +
                   " 1 rank 10 excess 0 0 0 star 1\ndelete rows 30 columns 11\nminor 1\n";
        for (int vector = 0; vector < 11; ++vector) {
            kernels += "kernel";
            for (int entry = 0; entry < 11; ++entry)
                kernels += " " + std::string(1000, '7');
            kernels += "\n";
        }
    }
    refused_bytes(kernels, 1, "");
}

TEST_CASE("a prefix of the archive is refused at its end") {
    const std::string archive = read_file(std::string(SOURCE_DIR) + "/certs/classification.plc");
    REQUIRE(archive.size() > 4'000'000);
    const std::size_t first = archive.find("\nminimal") + 1;
    std::vector<Hostile> files;
    // Within the head, a pool, a record, a word; before the last line feed.
    for (const std::size_t size : {std::size_t{1}, std::size_t{23}, std::size_t{230}, first - 3,
                                   first + 3, archive.size() / 2, archive.size() - 1})
        files.push_back({archive.substr(0, size)});
    refused_all(files);
    // Between records the syntax is good, and what is missing is missed.
    refused_bytes(archive.substr(0, archive.find("\nminimal", archive.size() / 2) + 1), 1, "");
}

TEST_CASE("wrong usage has a status of its own") {
    refused(plcheck, 3, "plcheck: ");
    refused(plcheck + " --no-such-option", 3, "plcheck: ");
    refused(plcheck + " \"$(printf -- '--\\033[2Jx')\"", 3, "plcheck: ");
}

TEST_CASE("plprove refuses hostile specifications of problems soon") {
    const std::string problem = std::string(PLPROVE) + " problem -- ";
    refused(problem + "'0*P/P/P'", 2, "column 2");
    refused(problem + "1000000000000000000*P/P/P", 2, "column ");
    refused(problem + "\"$(yes '99' | head -n 27 | tr '\\n' ' ')\"", 2, "1000 features");
    refused(problem + "\"$(yes '{' | head -n 50000 | tr -d '\\n')\"", 2, "nested too deeply");
    refused(problem + "\"$(yes 'P/P/P+' | head -n 10000 | tr -d '\\n')\"", 2, "1000 features");
    refused(problem + "\"$(printf 'P/\\033[2J')\"", 2, "the byte 27");
    refused(problem + "\"$(printf '\\303\\050/P')\"", 2, "the byte 195");
    refused(problem + "99999999999999999999999999", 2, "143493");
}

TEST_CASE("hostile problem files are refused on their line") {
    const std::string start = "plcert 2 problem\nproblem ";
    std::string steps;
    for (int i = 0; i < 10'000; ++i)
        steps += "reduce 1 bare-point nothing\n";
    refused_all({
        {start + "1000000000000000000*P/P/P\nverdict minimal\n", 2},
        {start + "1001*P/P/P\nverdict over-constrained 2992\n", 2},
        {start + "600*P/P/P + 600*P/P/-\nverdict over-constrained 2389\n", 2},
        {start + "0*P/P/P\nverdict minimal\n", 2},
        {start + "1*P/P/P\nverdict under-constrained 8\n", 2},
        {start + "P/P/P + P/P/P\nverdict under-constrained 5\n", 2},
        {start + "P/P/P/P\nverdict minimal\n", 2},
        {start + "P/P/P + P/P\nverdict minimal\n", 2},
        {start + "ab/P/P\nverdict minimal\n", 2},
        {start + "Pb/P/P\nverdict minimal\n", 2},
        {start + "\nverdict minimal\n", 2},
        {start + "5*P/P/P\nverdict over-constrained 18446744073709551620\n", 3},
        {start + "5*P/P/P\nverdict over-constrained 4\nverdict over-constrained 4\n", 4},
        {start + "5*P/P/P\nreduce 1000000000000000000 bare-point nothing\n", 3},
        {start + "5*P/P/P\nreduce 0 bare-point nothing\nverdict minimal\n"},
        {start + "5*P/P/P\nreduce 1 no-such-rule nothing\nverdict minimal\n", 3},
        {"plcert 2 problem\n", 0},
    });
    refused_bytes(start + "P/-/-\n" + steps + "verdict under-constrained 11\n", 1, "");
}

TEST_CASE("lines that go on without end are refused soon") {
    const auto endless = [](const std::string& start, const std::string& line) {
        return "printf '" + start + " \\\\\\n'; yes '" + line + " \\' | head -c 67000000";
    };
    const std::string problem = "plcert 2 problem\\nproblem P/P";
    const std::string pool = "plcert 2 classification\\nmodulus 2305843009213693951\\npool 1\\n";
    refused_pipe(endless("plcert 2 classification", "x"), 2, "/dev/stdin:2: ");
    refused_pipe(endless("plcert 2 classification\\nmodulus", "#"), 2, "/dev/stdin:3: ");
    refused_pipe(endless(problem, "+ P/P"), 2, "expected equal neighbours");
    refused_pipe(endless(problem + "\\nverdict minimal", "x"), 1, "the verdict is");
    refused_pipe(endless(pool + "camera 2 quaternion 1", "0"), 2, "expected `translation`");
    refused_pipe("printf 'plcert 2 problem\\nproblem P/P'; yes ' \\' | head -c 67000000", 2,
                 "/dev/stdin:3: ");
}

TEST_CASE("what is quoted from hostile files and names keeps JSON valid") {
    const TemporaryFolder folder;
    const std::string name = (folder / "a\"b\\c\n\x1b\xff").string();
    write_file(name, "plcert 2 problem\nproblem \"\\\x01\n");
    const Outcome outcome = run(plcheck + " --json '" + name + "'");
    CHECK(outcome.status == 2);
    CHECK(fit_for_a_terminal(outcome.out));
    const auto report = nlohmann::json::parse(outcome.out);
    CHECK(report.at("status") == 2);
    const auto& complaints = report.at("files").at(0).at("complaints");
    CHECK(complaints.size() == 1);
    CHECK(complaints.at(0).at("line") == 2);
}

TEST_CASE("a solution that comes again is refused at once, not after all have been replayed") {
    const std::string format = read_file(SOURCE_DIR "/certs/FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 degrees\n") + 1;
    const std::string example = format.substr(start, format.find("```", start) - start);
    // A start from which Newton's method is slow: coordinates of 2^-10 only.
    const std::string rough = "real 10 512 1024 -768 1024 -768 -1024 3072 4096 -2560 2048 2560\n";
    std::string record = example.substr(0, example.rfind("real "));
    for (int i = 0; i < 100'000; ++i)
        record += rough;
    const std::size_t first = static_cast<std::size_t>(std::ranges::count(example, '\n'));
    refused_bytes(record, 1,
                  std::to_string(first + 1) +
                      ": refused: class 2394: this may be the solution of "
                      "line " +
                      std::to_string(first));
}

TEST_CASE("a record of a million solutions needs no more memory than one of few") {
    const std::string record =
        "printf 'plcert 2 degrees\\ndegree 2394 evidence none\\n"
        "image P/P/P view point 1 2 3 view point 1 2 4 view point 1 2 5\\n'; ";
    const std::string solutions = "yes 'real 0 0 0 0 0 0 0 0 0 0 0 0' | head -n 2000000";
    refused_pipe(record + solutions, 1, "/dev/stdin:2: refused: class 2394: the images must be");
}

TEST_CASE("many flawed records are refused soon") {
    std::string model = "plcert 2 model\nmodel m\nunknown x\nequation x ^ 2 = 2\n"
                        "modulus 2305843009213693951\n";
    for (int i = 0; i < 20'000; ++i)
        model += "elimination\ndata\ndegree 20 in x\nbasis 1\nrows 1 1\nminor 1\n";
    refused_bytes(model, 1, "6: refused: an elimination: there are fewer rows than columns");
    std::string records = "plcert 2 degrees\n";
    for (int number = 4; number < 20'000; ++number)
        records +=
            "degree " + std::to_string(number) +
            " evidence none\nimage P/P/P view point 1 2 3 view point 1 2 4 view point 1 2 5\n"
            "real 0 0 0 0 0 0 0 0 0 0 0 0\n";
    refused_bytes(records, 1, "2: refused: class 4: the images must be");
}

TEST_CASE("what takes long is refused soon, even if nothing in it is flawed") {
    const std::string too_much = ": refused: from here on the file takes more effort than allowed";
    const std::string problems = "plcert 2 problems\nmodulus 2305843009213693951\n";
    refused_pipe("printf '" + problems + "'; yes 'problem 100*Pa/a\nunbalanced' | head -c 67000000",
                 1, "/dev/stdin:20003" + too_much);
    // 97 points with a pin that leave the cameras alone: J has 563 rows.
    const std::string many_rows = "problem 3*P/P/P/P/P/P/P/P/P/P/P/P + a/a/a/-/-/-/-/-/-/-/-/- + "
                                  "97*Pa/a/-/-/-/-/-/-/-/-/-/-\nminimal 1\n" +
                                  [] {
                                      std::string lines;
                                      for (int camera = 1; camera <= 11; ++camera)
                                          lines +=
                                              "camera 1 2 3 " + std::to_string(camera) + " 5 6 7\n";
                                      lines += "scene";
                                      for (int i = 0; i < 597; ++i)
                                          lines += " " + std::to_string(i * i % 97);
                                      return lines + "\n";
                                  }();
    std::string records = problems;
    for (int i = 0; i < 1000; ++i)
        records += many_rows;
    refused_bytes(records, 1, std::to_string(3 + 14 * 64) + too_much);
    // Eliminations with 1,771 columns, whose matrices are not made when too many came before.
    std::string model = "plcert 2 model\nmodel m\nunknown x , y , z\nequation x = 1\n"
                        "equation y = 1\nequation z = 1\nmodulus 2305843009213693951\n";
    for (int i = 0; i < 50; ++i)
        model += "elimination\ndata\ndegree 20 in x y z\nbasis 1\nrows 1 1\nminor 1\n";
    refused_bytes(model, 1, "38" + too_much);
}

TEST_CASE("many small files stay within the memory") {
    const TemporaryFolder folder;
    write_file(folder / "empty.plc", "plcert 2 degrees\n");
    std::string files;
    for (int i = 0; i < 60; ++i)
        files += ' ' + (folder / "empty.plc").string();
    refused(plcheck + files, 1, "empty.plc:0: refused: it has no record");
}
