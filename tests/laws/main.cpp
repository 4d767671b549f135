// laws FILE          checks the degrees in a file such as certs/degrees.csv
// laws --mark FILE   prints the file with the word `guarded` where a law guards a degree
// Status 0 if the laws hold, 1 if not, 2 if the file cannot be read.
#include "tests/laws/verdict.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>

namespace {

int report(const laws::DegreeForm& form) {
    const laws::Verdict verdict = laws::check(form);
    for (const std::string& line : verdict.report)
        std::cout << line << '\n';
    if (!verdict.hold) {
        std::cout << "a degree is wrong: compute the suspects again (plprove degree NUMBER --seed "
                     "SEED)\n";
        return 1;
    }
    const std::vector<bool> guarded = laws::guarded_classes(form);
    for (std::size_t i = 0; i < guarded.size(); ++i)
        if (!guarded[i])
            std::cout << "no law guards class " << form.classes()[i].number << ", "
                      << form.classes()[i].notation << ", degree " << form.classes()[i].degree
                      << '\n';
    std::cout << "the laws hold: they guard " << std::ranges::count(guarded, true) << " of "
              << guarded.size() << " classes against a single mistake\n";
    return 0;
}

int run(const std::vector<std::string>& arguments) {
    const bool mark = arguments.size() == 2 && arguments[0] == "--mark";
    if (!mark && arguments.size() != 1) {
        std::cerr << "laws: expected FILE or --mark FILE, for instance laws certs/degrees.csv\n";
        return 2;
    }
    const std::string& path = arguments.back();
    const laws::DegreeForm form(laws::read_exact_degrees(path));
    if (!mark) return report(form);
    std::ifstream file(path);
    laws::mark_guarded(file, std::cout, form, laws::guarded_classes(form));
    return 0;
}

} // namespace

int main(int argc, char** argv) try {
    return run({argv + 1, argv + argc});
} catch (const std::exception& error) {
    std::cerr << "laws: " << error.what() << '\n';
    return 2;
}
