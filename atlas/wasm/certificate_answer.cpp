#include "atlas/wasm/answers.h"

#include "prover/minimal/problem_file.h"
#include "prover/problem/spec.h"

namespace atlas {

using namespace plprove;

namespace {

Json cameras_of(const Cameras& cameras) {
    Json list = Json::array();
    for (const Camera& camera : cameras)
        list.push_back({{"quaternion", camera.quaternion}, {"translation", camera.translation}});
    return list;
}

Json features_of(const std::vector<PlacedFeature>& features) {
    Json list = Json::array();
    for (const PlacedFeature& placed : features)
        list.push_back({{"feature", notation(placed.feature)},
                        {"point", placed.point},
                        {"directions", placed.directions}});
    return list;
}

/// The Jacobian block by block: the rows of a feature, in its own unknowns and in those of the
/// cameras. Entries are decimal texts: some are larger than a page can count.
Json jacobian_of(const ProblemFile& certificate) {
    Json blocks = Json::array();
    for (const PlacedFeature& placed : certificate.features) {
        const FeatureBlock block = feature_block(placed, certificate.cameras);
        Json rows = Json::array();
        for (int row = 0; row < block.rows; ++row) {
            Json entries = Json::array();
            for (int column = 0; column < block.own + block.cameras; ++column)
                entries.push_back(std::to_string(block.at(row, column)));
            rows.push_back(entries);
        }
        blocks.push_back({{"own", block.own}, {"cameras", block.cameras}, {"rows", rows}});
    }
    return blocks;
}

/// What the claim proves, with the numbers that it has.
Json proof_of(const Claim& claim) {
    const auto* minor = std::get_if<Minor>(&claim);
    if (!minor) return {{"kind", "dimension count"}};
    Json proof{{"kind", name(*minor)}, {"minor", std::to_string(minor->value)}};
    if (!minor->deleted_rows.empty()) proof["deleted_rows"] = minor->deleted_rows;
    if (!minor->deleted_columns.empty()) proof["deleted_columns"] = minor->deleted_columns;
    if (!minor->kernel.empty()) proof["kernel"] = minor->kernel;
    return proof;
}

} // namespace

Json certificate_answer(const Json& request) {
    const ProblemFile certificate =
        certify_problem(parse_spec(request.at("spec").get<std::string>()));
    return {{"text", write(certificate)},
            {"modulus", std::to_string(modulus)},
            {"cameras", cameras_of(certificate.cameras)},
            {"features", features_of(certificate.features)},
            {"jacobian", jacobian_of(certificate)},
            {"proof", proof_of(certificate.claim)}};
}

} // namespace atlas
