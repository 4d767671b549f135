#include "prover/cli/model_source.h"

#include "prover/model/solver/lifted_fibre.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/system/words.h"

#include <fstream>
#include <iostream>
#include <thread>

namespace plprove {

namespace {

std::string text_of(std::istream& in, const std::string& name) {
    std::string text;
    for (std::string line; std::getline(in, line) && text.size() <= model::largest_text;)
        text += line + '\n';
    if (in.bad()) throw BadInput("cannot read " + name + ": is it a file?");
    return text;
}

} // namespace

ModelSource read_model_source(const std::string& path) {
    ModelSource source;
    if (path == "-") {
        source.text = text_of(std::cin, "standard input");
    } else {
        std::ifstream file(path);
        if (!file) throw BadInput("cannot read " + path + ": name a file with a model");
        source.text = text_of(file, path);
    }
    source.comments = model::opening_comments(source.text);
    return source;
}

model::Study studied(const std::string& text, Fibres fibres) {
    ProgressLine line("looking for solutions, then for all", 0);
    line.show(0);
    if (fibres == Fibres::by_basis) return model::study(text);
    std::size_t found = 0;
    const model::LiftOptions options{
        std::max(1U, std::thread::hardware_concurrency()),
        [&](std::size_t solutions) { line.show(found = solutions); },
        [&](long bits) {
            line.show(found, ", to " + counted(static_cast<std::size_t>(bits), "bit"));
        }};
    return model::study(text, [&](const model::Model& model, const model::Program& program) {
        return model::lifted_fibre(model, program, options);
    });
}

} // namespace plprove
