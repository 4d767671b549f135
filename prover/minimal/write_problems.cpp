#include "prover/format/certificate_text.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"

namespace plprove {

namespace {

/// The numbers from 1 of what is counted from 0.
std::vector<std::string> numbered(std::span<const int> numbers) {
    std::vector<std::string> words;
    for (const int number : numbers)
        words.push_back(std::to_string(number + 1));
    return words;
}

std::vector<std::string> numbered_views(ViewSet views) {
    std::vector<std::string> words;
    for (int view = 0; view < most_views; ++view)
        if (contains(views, view)) words.push_back(std::to_string(view + 1));
    return words;
}

struct WriteEvidence {
    CertificateText& text;

    void operator()(const FullRank& evidence) const {
        text.line("minimal", evidence.minor);
        for (const std::vector<std::int64_t>& camera : evidence.instance.cameras)
            text.line("camera", coordinates(camera));
        text.line("scene", coordinates(evidence.instance.scene));
    }

    void operator()(const Unbalanced&) const { text.line("unbalanced"); }

    void operator()(const FourCollinear& reason) const {
        text.line("collinear", numbered(reason.points), "views", numbered(reason.views));
    }

    void operator()(const OverconstrainedPart& reason) const {
        text.line("excess", reason.excess);
        const Subproblem& part = reason.part;
        text.line("part views", numbered_views(part.views), "points", numbered(part.points),
                  "lines", numbered(part.lines));
        write_motion(reason.motion);
    }

    void write_motion(const CameraMotion& motion) const {
        if (motion.kind == MotionKind::none) return text.line("motion none");
        const std::string kind = motion.kind == MotionKind::plane
                                     ? "plane"
                                     : "star " + std::to_string(motion.centre + 1);
        text.line("motion", kind, "views", numbered_views(motion.moving), "points",
                  numbered(motion.points), "lines", numbered(motion.lines));
    }
};

std::string file(std::span<const ProblemRecord> certificates, CertificateText text) {
    text.line("modulus", modulus);
    for (const ProblemRecord& certificate : certificates) {
        text.line("problem", notation(certificate.problem));
        std::visit(WriteEvidence{text}, certificate.evidence);
    }
    return certificate_file("problems", text.take(), "certify fewer problems");
}

} // namespace

std::string write(std::span<const ProblemRecord> certificates) {
    return file(certificates, {});
}

std::string write(std::span<const ProblemRecord> certificates, Family family) {
    CertificateText text;
    text.line(family == Family::plmp ? "family plmp" : "family projective");
    return file(certificates, std::move(text));
}

} // namespace plprove
