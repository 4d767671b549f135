// What pages ask of the prover, and what it answers, in JSON.
#pragma once

#include "prover/catalogue/catalogue.h"
#include "prover/problem/problem.h"

#include <nlohmann/json.hpp>

namespace atlas {

using Json = nlohmann::ordered_json;

/// What is known of all label classes, made when it is first wanted.
class Library {
public:
    /// The label classes by their numbers.
    const std::vector<plprove::Entry>& classes();

private:
    std::vector<plprove::Entry> classes_;
};

/// {"spec": ...}, a problem in any of the ways of parse_spec: what `plprove problem --json` says of
/// it, its names, what each view sees, what may be added to it, and its scene. Of a problem that
/// only parse_general_spec reads: what the program says of it, as `general`, its scene, and its
/// certificate, if one is found. Throws NotationError.
Json problem_answer(const Json& request);

/// {"spec": ..., "kind": "svg", "tikz", "macaulay2", "julia" or "certificate"}: the file of that
/// kind, as plprove writes it. Throws NotationError, and BadInput where no equations are written.
Json file_answer(const Json& request);

/// {"spec": ...}: the certificate of the verdict as text and as numbers: cameras, features with
/// their coordinates, the Jacobian, and what is said of it. Throws NotationError.
Json certificate_answer(const Json& request);

/// {"filter": options of `plprove list`, "sort": a column, "descending": bool, "first": N, "most":
/// N}: how many classes pass, and the rows wanted, each with its scene. Throws
/// std::invalid_argument.
Json search_answer(Library& library, const Json& request);

/// {"number": N}: the classes that share swap class or constraint class with a class, and those
/// that come of it when one feature is exchanged.
Json relatives_answer(Library& library, const Json& request);

/// What pages need to draw a problem: the number of views; of each point the views that see it, a
/// bit each; of each line its points and the views that see it. Points and lines are in the order
/// of the features.
Json scene_of(const plprove::Problem& problem);
Json scene_of(const plprove::Features& problem);

/// What a list says of a class: number, notation, verdict, degree.
Json row_of(const plprove::Entry& entry);

} // namespace atlas
