#include "prover/generate/header.h"

#include "prover/format/version.h"
#include "prover/generate/straight_line_code.h"
#include "prover/model/evaluation.h"
#include "prover/model/solver/derivatives.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>

namespace plprove::generate {

namespace {

using model::DerivedEquation;
using model::Expressions;
using model::ModelSolver;
using model::Named;
using model::Node;
using model::NodeIndex;
using model::Program;
using model::ScalarIndex;

/// Keywords of C++, and what else a compiler may know, with a blank before and after each.
constexpr std::string_view words_of_cpp =
    " "
    "alignas alignof and and_eq asm atomic_cancel atomic_commit atomic_noexcept "
    "auto bitand bitor bool break case catch char char16_t char32_t char8_t "
    "class co_await co_return co_yield compl concept const const_cast consteval "
    "constexpr constinit continue decltype default delete do double dynamic_cast "
    "else enum explicit export extern false far float for friend goto if inline "
    "int linux long main mutable namespace near new noexcept not not_eq nullptr "
    "operator or or_eq private protected public reflexpr register "
    "reinterpret_cast requires return short signed sizeof static static_assert "
    "static_cast std struct switch synchronized template this thread_local throw "
    "true try typedef typeid typename union unix unsigned using virtual void "
    "volatile wchar_t while xor xor_eq ";

/// Names that the header itself gives.
constexpr std::string_view own_words = " detail real residual rotation solution translation Data ";

bool is_among(std::string_view words, const std::string& name) {
    return words.find(' ' + name + ' ') != std::string_view::npos;
}

/// What a member is called.
std::string member(const std::string& name) {
    return is_among(words_of_cpp, name) || is_among(own_words, name) ? name + '_' : name;
}

std::string in_brackets(const std::vector<int>& shape) {
    std::string text;
    for (const int size : shape)
        text += '[' + std::to_string(size) + ']';
    return text;
}

/// Comments have no end of the line that would continue them.
std::string comment(std::string text, const std::string& start = "// ") {
    while (!text.empty() && (text.back() == '\\' || text.back() == ' '))
        text.pop_back();
    std::string line = start + text;
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

/// Which items of an array are which arrays: `d[0] to d[8] are x`.
std::string numbering(const std::vector<Named>& names, const std::string& array) {
    std::string text;
    std::size_t first = 0;
    for (const Named& named : names) {
        const std::size_t count = named.value.scalars.size();
        const std::string begin = array + '[' + std::to_string(first) + ']';
        first += count;
        text += comment(count == 1 ? begin + " is " + named.name
                                   : begin + " to " + array + '[' + std::to_string(first - 1) +
                                         "] are " + named.name + in_brackets(named.value.shape),
                        "    // ");
    }
    return text;
}

/// Statements that set items of an array to expressions.
struct Assignments {
    std::string statements;
    bool needs_data = false;
};

Assignments assignments(const Program& program, const std::vector<ScalarIndex>& scalars) {
    Expressions nodes;
    const std::vector<NodeIndex> wanted = model::nodes_of(program, scalars, nodes);
    StraightLineCode code(nodes, wanted);
    Assignments result;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        result.statements += code.definitions(wanted[i], "        ");
        result.statements +=
            "        out[" + std::to_string(i) + "] = " + code.expression(wanted[i]) + ";\n";
    }
    result.needs_data = code.needs(Node::Kind::datum);
    return result;
}

/// A function of the class Equations.
std::string function(const Program& program, const std::string& name,
                     const std::vector<ScalarIndex>& scalars, bool with_data) {
    const Assignments code = assignments(program, scalars);
    std::string text = "\n    static void " + name + "([[maybe_unused]] const Complex* u,";
    if (with_data) text += " [[maybe_unused]] const Complex* d,";
    return text + "\n        [[maybe_unused]] Complex* out) {\n" + code.statements + "    }\n";
}

/// The unknowns, those of few equations first: an elimination then has many zeros.
std::vector<std::size_t> order_of(const std::vector<DerivedEquation>& equations) {
    std::vector<std::size_t> order(equations.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t unknown) {
        return std::ranges::count_if(equations, [&](const DerivedEquation& equation) {
            return equation.by_unknown[unknown] != 0; // the node 0 is the number 0
        });
    });
    return order;
}

/// The order of the unknowns, and the function with the equations.
std::string linearise(const Program& program) {
    Expressions nodes;
    const std::vector<DerivedEquation> equations = model::derived_equations(program, nodes);
    const std::vector<std::size_t> order = order_of(equations);
    std::vector<NodeIndex> wanted;
    for (const DerivedEquation& equation : equations) {
        wanted.insert(wanted.end(), equation.by_unknown.begin(), equation.by_unknown.end());
        wanted.push_back(equation.value);
        wanted.push_back(equation.by_time);
    }
    StraightLineCode code(nodes, wanted);
    const std::string indent = "        ";
    std::string text = "\n    static constexpr std::size_t order[unknowns] = {";
    for (std::size_t i = 0; i < order.size(); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(order[i]);
    text += "};\n\n    template <bool moving, class Row>\n"
            "    static void linearise([[maybe_unused]] const Complex* u,\n"
            "        [[maybe_unused]] const Complex* d,\n"
            "        [[maybe_unused]] const Complex* speed, Row* a) {\n";
    const auto set = [&](std::size_t row, std::size_t column, NodeIndex node,
                         const std::string& before) {
        text += code.definitions(node, before);
        text += before + "a[" + std::to_string(row) + "][" + std::to_string(column) +
                "] = " + code.expression(node) + ";\n";
    };
    for (std::size_t row = 0; row < equations.size(); ++row) {
        text += comment("equation " + std::to_string(row + 1) + ", of line " +
                            std::to_string(program.equations[row].at.line) + " of the model",
                        indent + "// ");
        for (std::size_t column = 0; column < program.unknowns; ++column)
            set(row, column, equations[row].by_unknown[order[column]], indent);
        set(row, program.unknowns, equations[row].value, indent);
    }
    text += indent + "if constexpr (moving) {\n";
    for (std::size_t row = 0; row < equations.size(); ++row)
        set(row, program.unknowns + 1, equations[row].by_time, indent + "    ");
    return text + indent + "}\n    }\n";
}

/// The scalars of a name; none if there is no such name.
std::vector<ScalarIndex> scalars_of_name(const Program& program, const std::string& name) {
    for (const std::vector<Named>* names : {&program.lets, &program.unknown_names})
        for (const Named& named : *names)
            if (named.name == name) return named.value.scalars;
    return {};
}

std::vector<ScalarIndex> camera_scalars(const Program& program, const std::vector<int>& cameras) {
    std::vector<ScalarIndex> scalars;
    for (const int camera : cameras)
        for (const char* letter : {"R", "t"}) {
            const auto part = scalars_of_name(program, letter + std::to_string(camera));
            scalars.insert(scalars.end(), part.begin(), part.end());
        }
    return scalars;
}

/// Numbers in lines that are not too long.
std::string numbers(const std::vector<std::complex<double>>& values, const std::string& indent) {
    constexpr std::size_t width = 100;
    std::string text, line = indent;
    const auto add = [&](double value) {
        const std::string item = literal(value) + ",";
        if (line.size() + item.size() + 1 > width) {
            text += line + '\n';
            line = indent;
        }
        line += (line == indent ? "" : " ") + item;
    };
    for (const std::complex<double>& z : values) {
        add(z.real());
        add(z.imag());
    }
    return text + line;
}

std::string class_equations(const ModelSolver& solver, const HeaderContents& contents) {
    const Program& program = solver.program();
    std::ostringstream out;
    out << "/// The equations of the model.\nstruct Equations {\n";
    const auto constant = [&](const char* name, std::size_t value) {
        out << "    static constexpr std::size_t " << name << " = " << value << ";\n";
    };
    constant("unknowns", program.unknowns);
    constant("data", program.data);
    constant("conditions", program.conditions.size());
    constant("counted", program.counts ? program.counted.size() : 0);
    constant("starts", solver.start_solutions().size());
    out << "\n    // The arrays u, of unknowns, and d, of data:\n"
        << numbering(program.unknown_names, "u") << numbering(program.data_names, "d")
        << linearise(program)
        << function(program, "find_conditions", model::scalars_of(program.conditions), true)
        << function(program, "find_counted",
                    program.counts ? program.counted : std::vector<ScalarIndex>{}, true);
    if (!contents.cameras.empty())
        out << function(program, "find_cameras", camera_scalars(program, contents.cameras), false);
    out << "\n    // Random data, and all their solutions.\n"
           "    static constexpr double start_data[2 * data] = {\n"
        << numbers(solver.start_data(), "        ")
        << "};\n    static constexpr double start_solutions[starts][2 * unknowns] = {\n";
    for (const auto& solution : solver.start_solutions())
        out << "        {\n" << numbers(solution, "            ") << "},\n";
    out << "    };\n};\n";
    return out.str();
}

/// Members of a struct, one for each name.
std::string members(const std::vector<Named>& names, const std::string& type) {
    std::string text;
    for (const Named& named : names)
        text +=
            "    " + type + ' ' + member(named.name) + in_brackets(named.value.shape) + " = {};\n";
    return text;
}

/// Calls of a function for each name.
std::string calls(const std::vector<Named>& names, const std::string& begin,
                  const std::string& end) {
    std::string text;
    for (const Named& named : names)
        text += "        " + begin + member(named.name) + end + "\n";
    return text;
}

std::string structs(const Program& program, const HeaderContents& contents) {
    std::string text =
        "/// What is given: arrays as the model has them, counted from 0.\n"
        "struct Data {\n" +
        members(program.data_names, "double") +
        "};\n\n/// A real solution: the unknowns of the model.\nstruct Solution {\n" +
        members(program.unknown_names, "double");
    if (!contents.cameras.empty()) {
        const std::string count = '[' + std::to_string(contents.cameras.size()) + ']';
        text += "    /// Camera " + std::to_string(contents.cameras.front()) +
                " is [rotation[0] | translation[0]], and so on. Camera 1 is [I | 0].\n"
                "    double rotation" +
                count + "[3][3] = {};\n    double translation" + count + "[3] = {};\n";
    }
    return text +
           "    double residual = 0; ///< the largest value of an equation, relative to its terms\n"
           "};\n\n/// Any solution.\nstruct ComplexSolution {\n" +
           members(program.unknown_names, "std::complex<double>") +
           "    bool real = false;\n    double residual = 0;\n};\n";
}

constexpr std::string_view options_and_stats = R"(
struct Options {
    /// Where solutions are still missing, all paths are followed on other ways, too, at most on so
    /// many. That takes long, and seldom finds more.
    int more_ways = 0;
};

struct Stats {
    std::size_t paths = 0; ///< followed, again ones too
    std::size_t steps = 0; ///< of all paths
    std::size_t lost = 0;  ///< how many solutions fewer than generic data have
};
)";

std::string convert_data(const Program& program) {
    return "/// All solutions, the real ones first.\n"
           "inline std::vector<Found<std::array<Complex, Equations::unknowns>>>\n"
           "found_for(const Data& data, const Options& options, Stats* stats) {\n"
           "    std::array<Complex, Equations::data> numbers;\n"
           "    Complex* next = numbers.data();\n" +
           [&] {
               std::string text;
               for (const Named& named : program.data_names)
                   text += "    read_numbers(data." + member(named.name) + ", next);\n";
               return text;
           }() +
           "    PathSolver<Equations> solver(numbers);\n"
           "    solver.run(options.more_ways);\n"
           "    const Cost cost = solver.cost();\n"
           "    auto found = std::move(solver).solutions();\n"
           "    if (stats)\n"
           "        *stats = {cost.paths, cost.steps, found.size() < generic ? generic - "
           "found.size() : 0};\n"
           "    return found;\n"
           "}\n";
}

std::string solve_functions(const Program& program, const HeaderContents& contents) {
    std::string text =
        "/// All solutions over the complex numbers, the real ones first. Data must be finite.\n"
        "inline std::vector<ComplexSolution> solve_complex(const Data& data,\n"
        "    const Options& options = {}, Stats* stats = nullptr) {\n"
        "    std::vector<ComplexSolution> result;\n"
        "    for (const auto& found : detail::found_for(data, options, stats)) {\n"
        "        ComplexSolution solution;\n"
        "        const detail::Complex* next = found.point.data();\n" +
        calls(program.unknown_names, "detail::write_numbers(solution.", ", next);") +
        "        solution.real = found.real;\n"
        "        solution.residual = found.residual;\n"
        "        result.push_back(solution);\n"
        "    }\n"
        "    return result;\n"
        "}\n\n"
        "/// The real solutions.\n"
        "inline std::vector<Solution> solve(const Data& data, const Options& options = {},\n"
        "    Stats* stats = nullptr) {\n"
        "    std::vector<Solution> result;\n"
        "    for (const auto& found : detail::found_for(data, options, stats)) {\n"
        "        if (!found.real) break;\n"
        "        Solution solution;\n"
        "        const detail::Complex* next = found.point.data();\n" +
        calls(program.unknown_names, "detail::write_numbers(solution.", ", next);");
    if (!contents.cameras.empty()) {
        const std::string count = std::to_string(contents.cameras.size());
        text += "        detail::Complex cameras[12 * " + count +
                "];\n"
                "        detail::Equations::find_cameras(found.point.data(), cameras);\n"
                "        for (std::size_t i = 0; i < " +
                count +
                "; ++i)\n"
                "            detail::read_camera(cameras + 12 * i, solution.rotation[i],\n"
                "                solution.translation[i]);\n";
    }
    return text + "        solution.residual = found.residual;\n"
                  "        result.push_back(solution);\n"
                  "    }\n"
                  "    return result;\n"
                  "}\n";
}

/// An item of an array, as C++ writes it: `solution.s[0]`.
std::string first_item(const Named& named) {
    std::string text = member(named.name);
    for (std::size_t i = 0; i < named.value.shape.size(); ++i)
        text += "[0]";
    return text;
}

std::string top_comment(const Program& program, const HeaderContents& contents) {
    std::string text = comment("SPDX-License-Identifier: MIT") +
                       comment(std::string("Written by plprove ") + software_version +
                               " (plprove generate): edit the model rather than this file.") +
                       comment("");
    for (const std::string& line : contents.about)
        text += comment(line);
    text += comment("") + comment(contents.solutions) + comment("") + comment("The model:") +
            comment("");
    for (const std::string& line : contents.model)
        text += comment(line, "//     ");
    const std::string& name = contents.name;
    text += comment("") +
            comment("How to call it, from any number of threads; C++17 and its library will do:") +
            comment("");
    std::vector<std::string> example = {"#include \"" + contents.file + '"', "#include <cstdio>",
                                        "", "int main() {", "    " + name + "::Data data;"};
    for (const Named& named : program.data_names)
        example.push_back("    data." + first_item(named) + " = 0.5; // and so on: all of " +
                          member(named.name) + in_brackets(named.value.shape));
    example.push_back("    for (const " + name + "::Solution& solution : " + name +
                      "::solve(data))");
    example.push_back("        std::printf(\"%.15g\\n\", solution." +
                      first_item(program.unknown_names.front()) + ");");
    example.emplace_back("}");
    for (const std::string& line : example)
        text += comment(line, "//     ");
    return text + comment("") +
           comment("Numbers are approximate. Paths lead from random complex data, whose solutions "
                   "this file has, to") +
           comment("the data that are given. Give data of size about 1, not pixels. Where data are "
                   "special,") +
           comment("solutions go to infinity or come together: these are lost, and Stats says how "
                   "many.");
}

} // namespace

bool is_name_of_namespace(const std::string& name) {
    constexpr std::size_t longest = 100;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto fits = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.size() <= longest && is_letter(name.front()) &&
           std::ranges::all_of(name, fits) && name.find("__") == std::string::npos &&
           !is_among(words_of_cpp, name);
}

std::string name_of_namespace(const std::string& model) {
    if (is_name_of_namespace(model)) return model;
    std::string name;
    for (const char c : model + "_model")
        if (c != '_' || !name.ends_with('_')) name += c;
    return name;
}

std::string header(const ModelSolver& solver, const HeaderContents& contents) {
    const Program& program = solver.program();
    std::ostringstream out;
    out << top_comment(program, contents) << "#pragma once\n\n";
    for (const char* library : {"algorithm", "array", "cmath", "complex", "cstddef", "cstdint",
                                "optional", "utility", "vector"})
        out << "#include <" << library << ">\n";
    out << "\nnamespace " << contents.name << " {\n\n"
        << structs(program, contents) << options_and_stats << '\n';
    bool begun = false; // behind the comment that says what the file is
    for (const std::string_view line : lines_of_paths()) {
        begun = begun || line.starts_with("namespace detail");
        if (begun) out << line << '\n';
    }
    out << "\nnamespace detail {\n\n"
        << class_equations(solver, contents)
        << "\n/// How many solutions generic data have.\n"
           "inline constexpr std::size_t generic = "
        << solver.found() << ";\n\n"
        << convert_data(program) << "\n} // namespace detail\n\n"
        << solve_functions(program, contents) << "\n} // namespace " << contents.name << '\n';
    return out.str();
}

} // namespace plprove::generate
