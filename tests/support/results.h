// Files as the checker returns them, made by hand: what follows from results is tested without
// their certificates.
#pragma once

#include "checker/model/program.h"
#include "checker/problem/notation.h"
#include "checker/registration/model.h"
#include "tests/support/all_classes.h"
#include "tests/support/report.h"

/// A classification file that proves these verdicts.
inline checker::ReplayedFile classification_with(const checker::Verdicts& verdicts) {
    checker::ClassificationFile file;
    for (std::size_t n = 0; n < verdicts.size(); ++n)
        if (verdicts[n]) file.verdicts.push_back({n, *verdicts[n]});
    return {.name = "classification.plc", .content = file};
}

/// A classification file that proves all classes.
inline checker::ReplayedFile whole_classification() {
    return classification_with(all_verdicts());
}

/// A problem file that proves the verdict on this class.
inline checker::ReplayedFile problem_of_class(std::size_t number) {
    const checker::Signature& signature = all_classes().representatives[number];
    checker::ProblemFile file;
    file.problem = checker::notation(signature);
    file.meaning = checker::parse_problem(file.problem, checker::section_1);
    file.verdict = "minimal";
    file.of_class = checker::ClassVerdict{number, checker::obstruction(signature)};
    return {.name = "problem.plc", .content = file};
}

/// A degree file that proves these bounds.
inline checker::ReplayedFile degree_file(const std::vector<checker::LowerBound>& bounds) {
    return {.name = "degrees.plc", .content = checker::DegreeFile{.bounds = bounds}};
}

/// A file of the model of a type of registration, which proves this upper bound.
inline checker::ReplayedFile registration_file(const checker::Registration& type,
                                               std::size_t bound) {
    return {.name = "registration.plc",
            .content = checker::ModelFile{.name = checker::name_of(type),
                                          .text = checker::lines_of_model(checker::model_of(type)),
                                          .at_most = bound,
                                          .records = 1}};
}

/// A report on all classes, each proved minimal or not, with all degrees: computed once, as it
/// takes ten seconds.
inline const checker::Report& whole_report() {
    static const checker::Report report =
        checker::summarize(all_classes(), {whole_classification()}, {}, true);
    return report;
}
