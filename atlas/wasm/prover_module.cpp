// plprove for a page: a question in JSON comes in, the answer goes out. What is answered is what
// the program's own code decides, looks up, draws and certifies.
#include "atlas/wasm/answers.h"

#include <emscripten.h>

using namespace atlas;

namespace {

Json answer_to(Library& library, const Json& request) {
    const std::string ask = request.at("ask");
    if (ask == "problem") return problem_answer(request);
    if (ask == "file") return file_answer(request);
    if (ask == "certificate") return certificate_answer(request);
    if (ask == "search") return search_answer(library, request);
    if (ask == "relatives") return relatives_answer(library, request);
    throw std::invalid_argument("nobody answers to '" + ask + "'");
}

/// The program as pages hold it: what it knows, and what it said last.
struct Prover {
    Library library;
    std::string answer;
};

} // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Prover* open_prover() {
    return new Prover;
}

/// The answer to a question, valid until the next one; `{"error": ...}` if it makes no sense.
EMSCRIPTEN_KEEPALIVE const char* ask_prover(Prover* prover, const char* request) {
    Json answer;
    try {
        answer = answer_to(prover->library, Json::parse(request));
    } catch (const std::exception& error) {
        answer = {{"error", error.what()}};
    }
    prover->answer = answer.dump();
    return prover->answer.c_str();
}
}
