#include "prover/model/certificate.h"

#include "prover/format/certificate_text.h"
#include "prover/model/fibre_text.h"
#include "prover/model/fields.h"
#include "prover/model/gradient_ring.h"
#include "prover/model/monomial.h"
#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

/// Throws BadInput if a relation fails at a random point modulo q.
void check_relations(const Model& model, const Program& program) {
    constexpr std::uint64_t stream = 3;
    RandomResidues random(model, stream);
    const PrimeField field;
    std::vector<Modular> data = random.residues(program.data);
    std::vector<Modular> unknowns = random.residues(program.unknowns);
    GradientRing<PrimeField> ring(field, std::move(data), std::move(unknowns));
    const auto values = evaluate(program, ring, scalars_of(program.relations));
    for (const Located& relation : program.relations)
        if (!values[relation.scalar].value.is_zero())
            throw ModelError(relation.at, "this relation does not hold for all data and unknowns: "
                                          "correct it, or write 'equation' if it shall hold for "
                                          "solutions");
}

std::string why_no_fibre(const Program& program) {
    if (program.equations.size() == program.unknowns) return {};
    return counted(program.equations.size(), "equation") + " for " +
           counted(program.unknowns, "unknown");
}

/// Sets the fibre: all solutions, or, where these are too many, one, which shows that the model is
/// minimal.
void look_for_fibre(Study& study, const FibreFinder& find) {
    study.no_fibre = why_no_fibre(study.program);
    if (!study.no_fibre.empty()) return;
    FibreSearch search = find(study.model, study.program);
    study.fibre = std::move(search.fibre);
    study.no_fibre = std::move(search.reason);
    if (study.fibre) return;
    PointSearch point = find_solution_point(study.model, study.program);
    study.fibre = std::move(point.fibre);
    study.ranks = point.seen;
    if (study.fibre) study.only_one.swap(study.no_fibre);
}

void look_for_elimination(Study& study) {
    if (study.is_underdetermined()) return;
    try {
        study.elimination = find_elimination(study.model, study.program, study.at_least());
        if (!study.elimination)
            study.no_elimination = "no degrees were found that eliminate all but finitely many "
                                   "monomials";
    } catch (const TooLarge& error) {
        study.no_elimination = error.what();
    }
}

std::vector<Residue> values(const std::vector<Modular>& residues) {
    std::vector<Residue> result;
    for (const Modular residue : residues)
        result.push_back(residue.value());
    return result;
}

void append(CertificateText& text, const Fibre& fibre) {
    text.line("fibre", fibre.polynomial.degree());
    text.line("data", values(fibre.data));
    append_solutions(text, fibre.polynomial, fibre.unknowns, fibre.form);
    if (!fibre.counted_form.empty())
        text.line("distinct", fibre.distinct, "by", fibre.counted_form);
}

void append(CertificateText& text, const Elimination& elimination) {
    text.line("elimination");
    text.line("data", values(elimination.data));
    for (const Group& group : elimination.groups)
        text.line("degree", group.degree, "in", group.names);
    text.line("basis", elimination.basis);
    for (const auto& [equation, columns] : elimination.rows)
        text.line("rows", equation, columns);
    text.line("minor", elimination.minor.value());
}

} // namespace

std::optional<std::size_t> Study::at_most() const {
    if (is_underdetermined()) return 0;
    if (!elimination) return std::nullopt;
    return elimination->basis.size();
}

FibreSearch fibre_by_basis(const Model& model, const Program& program) {
    return find_fibre(model, program);
}

Study study(std::string_view text, const FibreFinder& find) {
    Study result;
    result.model = read_model(text);
    result.program = compile(result.model);
    check_relations(result.model, result.program);
    look_for_fibre(result, find);
    look_for_elimination(result);
    return result;
}

std::string write(const Study& study) {
    if (!study.fibre && !study.at_most())
        throw BadInput("nothing was found to certify: " + study.no_fibre + "; " +
                       study.no_elimination);
    return study.fibre ? write(study, std::span(&*study.fibre, 1)) : write(study, {});
}

std::string write(const Study& study, std::span<const Fibre> fibres) {
    CertificateText text;
    for (const std::string& line : study.model.lines)
        text.line(line);
    text.line("modulus", modulus);
    for (const Fibre& fibre : fibres)
        append(text, fibre);
    if (study.elimination) append(text, *study.elimination);
    return certificate_file("model", text.take(), "state a smaller problem");
}

} // namespace plprove::model
