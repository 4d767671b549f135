// Reads problems, one a line, and looks for reasons why they are not minimal even where they are: a
// reason against a minimal problem would be wrong. Status 1 if there is one.
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"

#include <iostream>

using namespace plprove;

int main() {
    int minimal = 0, wrong = 0;
    for (std::string line; std::getline(std::cin, line);) {
        const auto found = try_to_certify(parse_problem(line));
        const auto* record = std::get_if<ProblemRecord>(&found);
        if (record == nullptr || !is_minimal(*record)) continue;
        ++minimal;
        if (!find_reason(record->problem)) continue;
        std::cout << "a reason against a minimal problem: " << line << '\n';
        ++wrong;
    }
    std::cout << wrong << " reasons against " << minimal << " minimal problems\n";
    return wrong > 0 ? 1 : 0;
}
