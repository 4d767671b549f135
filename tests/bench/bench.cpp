// Speed, each figure beside that of a peer in the same run: the minor of a class in the checker
// against FLINT's determinant of the same matrix; certifying and checking classes against FLINT's
// determinant of their whole Jacobians; replaying the records of the archive, and numbering the
// classes, against FLINT's minors. See degrees.cpp for degrees.
//
// Two ratios guard the speed of `plcheck certs/classification.plc`: replay_records to flint_minor
// was 0.67 and number_classes to flint_minor 0.13 when this was written. They had been 0.94 and
// 0.28, which took a third of the time too much.
#include "checker/minimal/block.h"
#include "checker/report/report.h"
#include "prover/minimal/classification_file.h"

#include <benchmark/benchmark.h>
#include <fstream>
#include <iterator>
#include <map>

namespace {

using namespace plprove;

constexpr std::size_t sample_step = 701;

/// A sample of minimal classes in the archive's first pool: what every benchmark below works on.
struct Sample {
    std::vector<std::vector<FeatureBlock>> blocks;
    std::vector<std::vector<CameraPart>> parts;
    std::vector<ResidueMatrix> stacks; ///< 11 x 11, modulo q
    std::vector<ResidueMatrix> wholes; ///< J, modulo q
};

ResidueMatrix stack(const std::vector<CameraPart>& parts) {
    ResidueMatrix result(camera_dimension, camera_dimension);
    int row = 0;
    for (const CameraPart& part : parts)
        for (int i = 0; i < part.modulo.rows(); ++i, ++row)
            for (int j = 0; j < camera_dimension; ++j)
                result.at(row, j) = part.modulo.at(i, j);
    return result;
}

const Sample& sample() {
    static const Sample value = [] {
        Sample result;
        const Pool pool = make_pool(1);
        for (std::size_t number = 0; number < label_classes().size(); number += sample_step) {
            const Signature& signature = label_classes()[number];
            if (obstruction(problem_of(signature)).deficiency() > 0) continue;
            std::vector<FeatureBlock> blocks;
            std::vector<CameraPart> parts;
            for (std::size_t i = 0; i < feature_count; ++i)
                for (std::size_t copy = 0; copy < signature[i]; ++copy) {
                    blocks.push_back(feature_block(pool.instances[i][copy], pool.cameras));
                    parts.push_back(eliminate(blocks.back()).value());
                }
            result.stacks.push_back(stack(parts));
            result.wholes.push_back(jacobian(pointers(blocks)));
            result.blocks.push_back(std::move(blocks));
            result.parts.push_back(std::move(parts));
        }
        return result;
    }();
    return value;
}

void count_items(benchmark::State& state, std::size_t items) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void checker_minor(benchmark::State& state) {
    using Matrix = std::array<std::array<checker::Residue, camera_dimension>, camera_dimension>;
    std::vector<Matrix> matrices;
    for (const ResidueMatrix& stack : sample().stacks) {
        Matrix& matrix = matrices.emplace_back();
        for (int i = 0; i < camera_dimension; ++i)
            for (int j = 0; j < camera_dimension; ++j)
                matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].value =
                    stack.at(i, j);
    }
    for (auto _ : state)
        for (const Matrix& matrix : matrices)
            benchmark::DoNotOptimize(checker::determinant(matrix));
    count_items(state, matrices.size());
}

void flint_minor(benchmark::State& state) {
    for (auto _ : state)
        for (const ResidueMatrix& stack : sample().stacks)
            benchmark::DoNotOptimize(nmod_mat_det(stack.get()));
    count_items(state, sample().stacks.size());
}

void prover_minor(benchmark::State& state) {
    for (auto _ : state)
        for (const auto& parts : sample().parts)
            benchmark::DoNotOptimize(determinant(pointers(parts)));
    count_items(state, sample().parts.size());
}

void flint_whole_jacobian(benchmark::State& state) {
    for (auto _ : state)
        for (const ResidueMatrix& whole : sample().wholes)
            benchmark::DoNotOptimize(nmod_mat_det(whole.get()));
    count_items(state, sample().wholes.size());
}

void prove_classification(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(
            write(certify_classification(label_classes(), [](std::size_t) {})));
    count_items(state, label_classes().size());
}

std::string archive() {
    std::ifstream stream(CERTS_DIR "/classification.plc", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void check_classification(benchmark::State& state) {
    const std::string bytes = archive();
    for (auto _ : state) {
        const checker::Classification classes = checker::classify();
        std::vector<checker::ReplayedFile> files{checker::replay(classes, "archive", bytes)};
        benchmark::DoNotOptimize(checker::summarize(classes, std::move(files)));
    }
    count_items(state, label_classes().size());
}

void replay_records(benchmark::State& state) {
    const std::string bytes = archive();
    const checker::Classification classes = checker::classify();
    for (auto _ : state)
        benchmark::DoNotOptimize(checker::replay(classes, "archive", bytes));
    count_items(state, classes.representatives.size());
}

void number_classes(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(checker::classify());
    count_items(state, label_classes().size());
}

BENCHMARK(prove_classification)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(check_classification)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(replay_records)->Unit(benchmark::kMillisecond);
BENCHMARK(number_classes)->Unit(benchmark::kMillisecond);
BENCHMARK(checker_minor);
BENCHMARK(flint_minor);
BENCHMARK(prover_minor);
BENCHMARK(flint_whole_jacobian);

/// The usual table, and then the ratios.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs)
            if (const auto rate = run.counters.find("items_per_second"); rate != run.counters.end())
                per_second_[run.run_name.function_name] = rate->second;
    }
    void Finalize() override {
        ratio("checker_minor", "flint_minor");
        ratio("prover_minor", "flint_whole_jacobian");
        ratio("prove_classification", "flint_whole_jacobian");
        ratio("check_classification", "flint_whole_jacobian");
        ratio("replay_records", "flint_minor", "record");
        ratio("number_classes", "flint_minor");
        ratio("track_chicago", "track_chicago_one_lane", "track");
        ratio("track_chicago", "track_chicago_any_views", "track");
        ratio("track_chicago_wide", "track_chicago", "track");
        ratio("track_chicago_triple", "track_chicago_wide", "track");
        ratio("check_solutions", "track_chicago", "solution and track");
        ratio("steps_chicago_model", "steps_chicago", "step");
    }

private:
    void ratio(const std::string& ours, const std::string& peer, const char* item = "class") {
        if (!per_second_.contains(ours) || !per_second_.contains(peer)) return;
        GetOutputStream() << "time of " << ours << " / " << peer << ", per " << item << ": "
                          << per_second_[peer] / per_second_[ours] << '\n';
    }

    std::map<std::string, double> per_second_;
};

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
