#include "prover/model/certificate.h"

#include "prover/format/certificate_text.h"
#include "prover/model/fibre_text.h"
#include "prover/model/fields.h"
#include "prover/model/gradient_ring.h"
#include "prover/model/monomial.h"
#include "prover/model/solution_point.h"

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
    return "there are " + std::to_string(program.equations.size()) + " equations and " +
           std::to_string(program.unknowns) + " unknowns";
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

Study study(std::string_view text) {
    Study result;
    result.model = read_model(text);
    result.program = compile(result.model);
    check_relations(result.model, result.program);
    result.no_fibre = why_no_fibre(result.program);
    if (result.no_fibre.empty()) {
        FibreSearch search = find_fibre(result.model, result.program);
        result.fibre = std::move(search.fibre);
        result.no_fibre = std::move(search.reason);
        // All solutions were too many: one shows that the model is minimal.
        if (!result.fibre) result.fibre = find_solution_point(result.model, result.program);
        if (result.fibre) result.no_fibre.clear();
    }
    const std::size_t target = result.fibre ? result.fibre->count() : 0;
    try {
        result.elimination = find_elimination(result.model, result.program, target);
        if (!result.elimination)
            result.no_elimination = "no degrees were found that eliminate all but finitely many "
                                    "monomials";
    } catch (const TooLarge& error) {
        result.no_elimination = error.what();
    }
    return result;
}

std::string write(const Study& study) {
    CertificateText text;
    for (const std::string& line : study.model.lines)
        text.line(line);
    text.line("modulus", modulus);
    if (study.fibre) append(text, *study.fibre);
    if (study.elimination) append(text, *study.elimination);
    return certificate_file("model", text.take(), "state a smaller problem");
}

} // namespace plprove::model
