#include "tests/laws/verdict.h"

#include "tests/laws/hodge.h"
#include "tests/laws/ranks.h"

#include <algorithm>
#include <istream>
#include <ostream>

namespace laws {

namespace {

std::string described(const ClassDegree& found) {
    return "class " + std::to_string(found.number) + ", " + found.notation + ", degree " +
           std::to_string(found.degree) + " on file";
}

void suspect(std::size_t index, const std::string& why, const DegreeForm& form, Verdict& verdict) {
    const ClassDegree& found = form.classes()[index];
    verdict.suspects.push_back(found.number);
    verdict.report.push_back("suspect: " + described(found) + why);
}

/// Names what the failing equations share.
void suspect_by_equations(const std::vector<Equation>& all, const std::vector<std::size_t>& failed,
                          const DegreeForm& form, Verdict& verdict) {
    constexpr std::size_t most = 5;
    const std::vector<Suspect> single = single_mistakes(all, failed, form);
    for (const Suspect& one : single)
        suspect(one.constraint_class,
                ": all relations hold with " + std::to_string(one.should_be) + " instead", form,
                verdict);
    if (!single.empty()) return;
    verdict.report.push_back("no single degree explains this; these classes are in most of the "
                             "relations that fail");
    for (const std::size_t index : classes_in_most(all, failed, most))
        suspect(index, "", form, verdict);
}

void check_equations(const DegreeForm& form, Verdict& verdict) {
    const std::vector<Relation> relations = all_relations();
    const std::vector<Equation> all = equations(relations, form);
    const std::vector<std::size_t> failed = failures(all, form);
    for (std::size_t r = 0; r < relations.size(); ++r) {
        const auto times = std::ranges::count(all, r, &Equation::relation);
        const auto fails = std::ranges::count_if(
            failed, [&](std::size_t index) { return all[index].relation == r; });
        verdict.report.push_back("relation of weight " + std::to_string(relations[r].weight) +
                                 ", " + relations[r].name + ": " + std::to_string(times) +
                                 " equations, " + std::to_string(fails) + " fail");
    }
    if (failed.empty()) return;
    verdict.hold = false;
    suspect_by_equations(all, failed, form, verdict);
}

/// The classes that no equation contains.
std::vector<std::size_t> beyond_equations(const DegreeForm& form) {
    const std::vector<bool> guarded =
        guarded_by_equations(equations(all_relations(), form), form.classes().size());
    std::vector<std::size_t> others;
    for (std::size_t index = 0; index < guarded.size(); ++index)
        if (!guarded[index]) others.push_back(index);
    return others;
}

void check_rank(unsigned k, const DegreeForm& form, Verdict& verdict) {
    const DegreeMatrix matrix(k, form);
    const std::size_t expected = expected_ranks[k];
    std::size_t rank = 0;
    for (const std::uint64_t prime : primes)
        rank = std::max(rank, matrix.rank(form, prime));
    verdict.report.push_back("rank of M_" + std::to_string(k) + ", " +
                             std::to_string(matrix.rows()) + " by " +
                             std::to_string(matrix.columns()) + ": " + std::to_string(rank) +
                             ", expected " + std::to_string(expected));
    if (rank == expected) return;
    const bool named_before = !verdict.hold;
    verdict.hold = false;
    if (named_before) return; // the equations say more
    for (const std::size_t index : beyond_equations(form))
        if (matrix.rank_without(index, form) == expected)
            suspect(index, ": without it the rank is as expected", form, verdict);
}

void check_hodge(const DegreeForm& form, Verdict& verdict) {
    const std::vector<IntersectionMatrix> matrices = intersection_matrices(form);
    std::vector<bool> touched(form.classes().size(), false);
    std::size_t failed = 0;
    for (const IntersectionMatrix& matrix : matrices) {
        for (const std::size_t index : matrix.classes)
            touched[index] = true;
        const std::size_t positive = positive_eigenvalues(matrix);
        if (positive == 1) continue;
        ++failed;
        verdict.report.push_back("on " + checker::notation(matrix.surface) + " " +
                                 std::to_string(positive) + " eigenvalues are positive");
        if (!verdict.hold) continue; // other laws say more
        for (const std::size_t index : matrix.classes)
            suspect(index, "", form, verdict);
    }
    verdict.hold = verdict.hold && failed == 0;
    verdict.report.push_back("Hodge index: " + std::to_string(matrices.size()) +
                             " matrices with the degrees of " +
                             std::to_string(std::ranges::count(touched, true)) + " classes, " +
                             std::to_string(failed) + " fail");
    const std::vector<HodgeBounds> bounds = bounds_by_others(matrices, form);
    std::size_t above = 0, within_tenth = 0, exactly = 0, below = 0;
    for (std::size_t index = 0; index < bounds.size(); ++index) {
        const std::int64_t degree = form.classes()[index].degree;
        const auto& [least, most] = bounds[index];
        if (least > 0) ++below;
        if (!most) continue;
        ++above;
        if (10 * *most <= 11 * degree) ++within_tenth;
        if (*most == degree) ++exactly;
    }
    verdict.report.push_back("Hodge index: the other degrees bound that of " +
                             std::to_string(above) + " classes from above, of " +
                             std::to_string(within_tenth) + " by 1.1 times its value, of " +
                             std::to_string(exactly) + " by its value; of " +
                             std::to_string(below) + " classes from below");
}

} // namespace

Verdict check(const DegreeForm& form) {
    Verdict verdict;
    check_equations(form, verdict);
    for (unsigned k = 0; k < expected_ranks.size(); ++k)
        check_rank(k, form, verdict);
    check_hodge(form, verdict);
    return verdict;
}

std::vector<bool> guarded_classes(const DegreeForm& form) {
    std::vector<std::size_t> others = beyond_equations(form);
    for (unsigned k = 1; k < expected_ranks.size(); ++k) {
        const DegreeMatrix matrix(k, form);
        std::erase_if(others, [&](std::size_t index) {
            return matrix.guards(index, expected_ranks[k], form);
        });
    }
    std::vector<bool> guarded(form.classes().size(), true);
    for (const std::size_t index : others)
        guarded[index] = false;
    return guarded;
}

void mark_guarded(std::istream& file, std::ostream& out, const DegreeForm& form,
                  const std::vector<bool>& guarded) {
    const std::string evidence = ",exact,evidence,", mark = "; guarded";
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with('#') && line.find(evidence) != std::string::npos) {
            if (line.ends_with(mark)) line.resize(line.size() - mark.size());
            if (guarded[*form.class_with(std::stoul(line))]) line += mark;
        }
        out << line << '\n';
    }
}

} // namespace laws
