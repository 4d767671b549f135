#include "atlas/wasm/answers.h"

#include "prover/minimal/problem_certificate.h"
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
Json jacobian_of(const ProblemCertificate& certificate) {
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

struct EvidenceInWords {
    Json operator()(std::monostate) const { return {{"kind", "dimension count"}}; }
    Json operator()(const MinimalCertificate& certificate) const {
        return {{"kind", "minimal"}, {"minor", std::to_string(certificate.minor)}};
    }
    Json operator()(const CameraMinimalCertificate& certificate) const {
        return {{"kind", "camera-minimal"},
                {"deleted_columns", certificate.deleted_columns},
                {"minor", std::to_string(certificate.minor)}};
    }
    Json operator()(const DeficientCertificate& certificate) const {
        return {{"kind", "deficient"},
                {"deleted_rows", certificate.deleted_rows},
                {"deleted_columns", certificate.deleted_columns},
                {"minor", std::to_string(certificate.minor)},
                {"kernel", certificate.kernel}};
    }
};

} // namespace

Json certificate_answer(const Json& request) {
    const ProblemCertificate certificate =
        certify_problem(parse_spec(request.at("spec").get<std::string>()));
    return {{"text", write(certificate)},
            {"modulus", std::to_string(modulus)},
            {"cameras", cameras_of(certificate.cameras)},
            {"features", features_of(certificate.features)},
            {"jacobian", jacobian_of(certificate)},
            {"evidence", std::visit(EvidenceInWords{}, certificate.evidence)}};
}

} // namespace atlas
