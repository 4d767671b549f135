#include "prover/cli/solve_command.h"

#include "prover/cli/input_file.h"
#include "prover/cli/solve_model.h"
#include "prover/cli/solve_report.h"
#include "prover/many_views/certificate.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/solver/certificate.h"
#include "prover/solver/general.h"
#include "prover/solver/images_file.h"
#include "prover/solver/poses.h"
#include "prover/solver/synthetic.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/three_views/degree_text.h"

#include <algorithm>
#include <iostream>
#include <thread>

namespace plprove {

namespace {

constexpr const char* solve_examples =
    "IMAGES is a JSON file; docs/solve.md describes it. The answer has every solution: cameras,\n"
    "features in space, residuals. The first run for a problem makes its start, and keeps it in "
    "the\ncache ($XDG_CACHE_HOME/pointline).\n\n"
    "Examples:\n"
    "  plprove solve --example Chicago -o images.json\n"
    "                                       images of a synthetic scene to try\n"
    "  plprove solve Chicago images.json    its cameras\n"
    "  plprove solve Chicago images.json --json -o answer.json\n"
    "                                       every solution, for machines; --real leaves out those\n"
    "                                       that are not real\n"
    "  plprove solve Chicago images.json --certify mine.plc\n"
    "  plcheck mine.plc                     proves that each solution exists\n\n"
    "PROBLEM may be a file with a model, NAME.model, and IMAGES then has its data:\n"
    "docs/models.md describes both.\n\n"
    "  plprove solve --example models/p3p.model -o data.json\n"
    "                                       random data that have a real solution\n"
    "  plprove solve models/p3p.model data.json\n"
    "                                       its unknowns, for all solutions";

/// Throws BadInput where it is one of those that cannot be solved.
ImagedProblem solvable_problem(const std::string& spec) {
    const std::optional<Problem> general = parse_general_spec(spec);
    if (!general) return parse_spec(spec);
    degree_to_solve(*general);
    return *general;
}

struct SolveRequest {
    std::string spec;
    std::string images;
    std::string path = "-";
    std::string start;
    std::string certificate;
    std::string example;
    bool json = false;
    bool real = false; ///< leaves out solutions that are not real
    SolveOptions options;
};

Solver solver_for(const SolveRequest& request, const Features& problem) {
    if (request.start.empty()) {
        ProgressLine line("getting the start", 1);
        line.show(0);
        return make_solver(problem);
    }
    return {plan(problem), read_start(content_of(request.start), request.start)};
}

constexpr const char* nothing_to_certify =
    "no solution was found that could be certified: solve without --certify to see what was found";

/// Solves the images and writes the certificate of the five points: a file of solutions.
Answer solve_and_certify_two_views(const SolveRequest& request, const Solver& solver,
                                   const ConsistentImages& consistent, const Deliver& deliver,
                                   SolveReport& report) {
    Answer answer = solver.solve(rounded(report.images, consistent), request.options);
    std::vector<std::vector<many_views::Complex>> cameras;
    for (const Solution& solution : answer.solutions) {
        const auto& [R, t] = solution.cameras[1];
        const auto [a, b, c, d] = quaternion(R);
        cameras.push_back({1, b / a, c / a, d / a, 1, t[1] / t[0], t[2] / t[0]});
    }
    const FivePointImages images = five_point_images(solver.plan(), consistent);
    const many_views::SolutionsRecord record =
        many_views::certify(parse_problem("5*P/P"), images.views, FivePointImages::digits, cameras);
    if (record.solutions.empty()) throw std::runtime_error(nothing_to_certify);
    report.certificate = {request.certificate, record.count(), images.exact, images.moved};
    deliver(request.certificate, many_views::write_solutions(std::span(&record, 1)));
    return answer;
}

/// Solves the images in integers and writes the certificate.
Answer solve_and_certify(const SolveRequest& request, const Solver& solver,
                         const ConsistentImages& consistent, const Deliver& deliver,
                         SolveReport& report) {
    const IntegerImages integers = integer_images(solver.plan(), solver.system(), consistent);
    Answer answer =
        solver.solve(rounded(report.images, consistent), unit_vectors(integers), request.options);
    const DegreeCertificate certificate =
        certify_images(solver.start(), solver.system(), integers, answer.zeros);
    if (certificate.solutions.empty()) throw std::runtime_error(nothing_to_certify);
    report.certificate = {request.certificate, certificate.degree(), integers.exact,
                          integers.moved};
    deliver(request.certificate, write_degree_file(std::span(&certificate, 1)));
    return answer;
}

/// Whether coordinates are so far from the centre as no camera sees them, where a view has none.
bool look_like_pixels(const GivenImages& images) {
    const std::array<ExactVector, 3> none{ExactVector{1, 0, 0}, ExactVector{0, 1, 0},
                                          ExactVector{0, 0, 1}};
    constexpr int largest = 10;
    const auto far = [&](const GivenSighting& sighting) {
        if (const auto& point = sighting.point)
            if (abs((*point)[0]) > largest || abs((*point)[1]) > largest) return true;
        return std::ranges::any_of(sighting.lines, [&](const auto& line) {
            if (!line) return false;
            const auto& [a, b, c] = line->coefficients;
            return c * c > largest * largest * (a * a + b * b);
        });
    };
    for (std::size_t v = 0; v < images.calibration.size(); ++v)
        if (images.calibration[v] == none)
            for (const auto& views : images.features)
                if (far(views[v])) return true;
    return false;
}

int threads() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Where the problem is not one of two or three calibrated views with local features.
Answer solve_general_images(const SolveRequest& request, const Problem& problem,
                            const SeenImages& images) {
    if (!request.certificate.empty() || !request.start.empty())
        throw BadInput("--certify and --start are for two or three calibrated views and lines with "
                       "at most one point: leave them out");
    const int degree = degree_to_solve(problem);
    constexpr int many = 5000;
    if (degree > many)
        std::cerr << "plprove: finding " << degree << " solutions takes some minutes\n";
    ProgressLine line("finding solutions of random images", static_cast<std::size_t>(degree));
    GeneralSolver::Options options;
    options.threads = threads();
    options.found = [&](int found) { line.show(static_cast<std::size_t>(found)); };
    return GeneralSolver(problem, options).solve(images, request.options.complex, options.threads);
}

int solve_images(const SolveRequest& request, const Deliver& deliver) {
    std::optional<ImagedProblem> asked;
    if (!request.spec.empty()) asked = solvable_problem(request.spec);
    SolveReport report;
    report.images = read_images(content_of(request.images), request.images, asked);
    const Features& problem = report.images.problem;
    const std::optional<Problem>& general = report.images.general;
    if (general) degree_to_solve(*general); // refuses what cannot be solved
    const bool calibrated = !general || general->cameras == &calibrated_cameras;
    if (calibrated && look_like_pixels(report.images)) {
        report.warnings.push_back("coordinates look like pixels, and without \"cameras\" they "
                                  "count as normalised: give \"cameras\"");
        std::cerr << "plprove: warning: " << report.warnings.back() << '\n';
    }
    const ConsistentImages images = consistent(report.images);
    report.moved = images.moved;
    refuse_degenerate(report.images);
    if (general) {
        report.answer = solve_general_images(request, *general, rounded(report.images, images));
        deliver(request.path, request.json ? json_report(report) : text_report(report));
        return report.answer.found > 0 ? 0 : exit_failure;
    }
    const Solver solver = solver_for(request, problem);
    report.number = solver.plan().number;
    ProgressLine line("finding solutions", static_cast<std::size_t>(solver.degree()));
    line.show(0);
    if (request.certificate.empty())
        report.answer = solver.solve(rounded(report.images, images), request.options);
    else if (!report.number)
        report.answer = solve_and_certify_two_views(request, solver, images, deliver, report);
    else
        report.answer = solve_and_certify(request, solver, images, deliver, report);
    line.wipe();
    deliver(request.path, request.json ? json_report(report) : text_report(report));
    return report.answer.found > 0 ? 0 : exit_failure;
}

int solve_given_model(const SolveRequest& request, const Deliver& deliver) {
    if (!request.certificate.empty() || !request.start.empty())
        throw BadInput("--certify and --start are for cameras: leave them out; `plprove model` "
                       "certifies how many solutions a model has");
    if (request.images.empty())
        throw BadInput("solve needs a file of data for " + request.spec + ": `plprove solve " +
                       "--example " + request.spec + " -o data.json` writes one");
    return solve_model({request.spec, request.images, request.path, request.json, request.real,
                        request.options.search.threads},
                       deliver);
}

int run_solve(const SolveRequest& request, const Deliver& deliver) {
    if (names_model(request.example))
        return write_example_data(request.example, request.path, deliver);
    if (request.example.empty() && names_model(request.spec))
        return solve_given_model(request, deliver);
    if (!request.example.empty()) {
        const ImagedProblem problem = solvable_problem(request.example);
        if (!problem.general) plan(problem.features); // refuses what cannot be solved
        deliver(request.path, images_file(synthetic_scene(problem, 1)));
        return 0;
    }
    if (request.images.empty() && names_file(request.spec)) {
        SolveRequest named = request;
        std::swap(named.spec, named.images);
        return solve_images(named, deliver);
    }
    if (request.images.empty()) {
        std::cerr << "plprove: solve needs a problem and a file of images: see `plprove solve "
                     "--help`\n";
        return exit_usage;
    }
    return solve_images(request, deliver);
}

} // namespace

Command add_solve_command(CLI::App& program, const Deliver& deliver) {
    const auto request = std::make_shared<SolveRequest>();
    CLI::App* app = program.add_subcommand(
        "solve", "Find the cameras, all of them, that explain given images; or solve a model");
    app->add_option(
        "PROBLEM", request->spec,
        "the problem, as for `plprove problem`, may be missing where the file has it; or "
        "a file with a model");
    app->add_option("IMAGES", request->images, "the file with the images, or the model's data");
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->capture_default_str();
    app->add_flag("--json", request->json, "print JSON");
    CLI::Option* certify =
        app->add_option("--certify", request->certificate,
                        "also write a certificate for these images: plcheck replays it")
            ->type_name("FILE");
    app->add_flag("--real", request->real, "only real solutions: a large problem has many others")
        ->excludes(certify);
    app->add_option("--start", request->start, "the start to use, instead of the one in the cache")
        ->type_name("FILE");
    app->add_option("--example", request->example,
                    "write images of a synthetic scene: Chicago, Cleveland, five-point, or any "
                    "problem; or data of a model")
        ->type_name("NAME");
    app->add_option("--threads", request->options.search.threads,
                    "how many threads share the work; the answer is the same")
        ->check(CLI::Range(1U, 256U))
        ->capture_default_str();
    app->footer(solve_examples);
    return {app, [request, deliver] {
                request->options.complex = !request->real;
                return run_solve(*request, deliver);
            }};
}

Command add_start_command(CLI::App& program, const Deliver& deliver) {
    struct Request {
        std::string spec;
        std::string path;
        std::uint64_t seed = 0;
    };
    const auto request = std::make_shared<Request>();
    CLI::App* app = program.add_subcommand(
        "start", "Write the start of a problem: images with all solutions, for `plprove solve`");
    app->add_option("PROBLEM", request->spec, "the problem, as for `plprove problem`")->required();
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->required();
    app->add_option("--seed", request->seed, "draw other random images")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app->footer("Examples:\n"
                "  plprove start Chicago -o chicago.start\n"
                "  plprove solve Chicago images.json --start chicago.start");
    return {app, [request, deliver] {
                const ImagedProblem problem = solvable_problem(request->spec);
                if (problem.general)
                    throw BadInput("starts are for three calibrated views and lines with at most "
                                   "one point: `plprove solve` solves " +
                                   notation(problem) + " without");
                const SolvePlan how = plan(problem.features);
                if (!how.number)
                    throw BadInput("problems in two views need no start: `plprove solve` "
                                   "solves them without");
                std::string start;
                {
                    ProgressLine line("making the start", 1);
                    line.show(0);
                    start = write_start(find_start(*how.number, request->seed));
                }
                deliver(request->path, start);
                return 0;
            }};
}

} // namespace plprove
