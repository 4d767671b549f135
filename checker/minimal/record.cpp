#include "checker/minimal/record.h"

namespace checker {
/// Whether the motion keeps all images of the feature, if this moves along.
static bool keeps_images(const std::vector<mpz_class>& motion, const Component& component) {
    for (const std::vector<mpz_class>& condition : component.conditions) {
        mpz_class change = 0;
        for (std::size_t c = 0; c < camera_unknowns; ++c)
            change += condition[c] * motion[c];
        if (change != 0) return false;
    }
    return true;
}

/// Refuses the i-th kernel vector unless it is in basis form and keeps all images: at the deleted
/// columns it is positive in the i-th and zero in the others, so that all vectors are independent.
static void check_kernel_vector(const MinorClaim& claim, std::size_t i,
                                const std::vector<const Component*>& components) {
    const std::vector<mpz_class>& motion = claim.kernel[i];
    const std::string name = say("kernel vector ", i + 1);
    for (std::size_t j = 0; j < claim.deleted_columns.size(); ++j) {
        const auto column = static_cast<std::size_t>(claim.deleted_columns[j] - 1);
        const int expected_sign = i == j ? 1 : 0;
        if (sgn(motion[column]) != expected_sign)
            throw Refused(name, " is not in basis form at deleted column ", j + 1);
    }
    mpz_class divisor = 0;
    for (const mpz_class& entry : motion)
        divisor = gcd(divisor, entry);
    if (divisor != 1) throw Refused(name, " has entries with a common divisor");
    for (const Component* component : components)
        if (!keeps_images(motion, *component)) throw Refused(name, " does not keep all images");
}

/// Refuses a record whose numbers are not those of the obstruction.
static void check_stated(const MinorClaim& claim, const Obstruction& obstruction) {
    const unsigned deficiency = obstruction.deficiency();
    const auto& [first, second, third] = obstruction.excess;
    const std::array<unsigned, 5> expected{11 - deficiency, first, second, third, obstruction.star};
    const bool as_stated = std::equal(claim.stated.begin(), claim.stated.end(), expected.begin(),
                                      expected.end(), std::cmp_equal<int, unsigned>);
    if (claim.stated.empty() ? deficiency > 0 : !as_stated)
        throw Refused("it has rank ", expected[0], ", excess ", first, ' ', second, ' ', third,
                      ", S ", expected[4]);
    for (const std::size_t count :
         {claim.deleted_rows.size(), claim.deleted_columns.size(), claim.kernel.size()})
        if (count != deficiency)
            throw Refused("there must be ", deficiency,
                          " deleted rows, deleted columns and kernel vectors");
}

/// The block of an component without those of its rows that are listed by their numbers in J;
/// its first row has the number `first`. The list ascends.
static Block block_without(const Numbers& deleted, const Component& component, int first) {
    Rows<mpz_class> kept;
    int number = first;
    for (const std::vector<mpz_class>& row : component.rows)
        if (!std::ranges::binary_search(deleted, number++)) kept.push_back(row);
    return eliminate(component.block.unknowns, modulo_q(kept));
}

Residue minor_without(const MinorClaim& claim, const std::vector<const Component*>& components,
                      std::size_t camera_columns) {
    std::vector<const Block*> blocks;
    std::vector<Block> shorter;
    shorter.reserve(claim.deleted_rows.size());
    int row = 1; // of J, the first of the component
    for (const Component* component : components) {
        const int first = row;
        row += static_cast<int>(component->rows.size());
        const auto next = std::ranges::lower_bound(claim.deleted_rows, first);
        const bool loses_rows = next != claim.deleted_rows.end() && *next < row;
        if (loses_rows) shorter.push_back(block_without(claim.deleted_rows, *component, first));
        blocks.push_back(loses_rows ? &shorter.back() : &component->block);
    }
    if (!claim.deleted_rows.empty() && claim.deleted_rows.back() >= row)
        throw Refused("J has only ", row - 1, " rows");
    return minor_of(blocks, camera_columns, claim.deleted_columns);
}

static void require_equal(Residue minor, Residue claimed) {
    if (minor != claimed) throw Refused("the minor is ", minor.value, " modulo q");
}

void check_claim(const MinorClaim& claim, const Obstruction& obstruction,
                 const std::vector<const Component*>& components, std::size_t camera_columns) {
    check_stated(claim, obstruction);
    require_equal(minor_without(claim, components, camera_columns), claim.minor);
    for (std::size_t i = 0; i < claim.kernel.size(); ++i)
        check_kernel_vector(claim, i, components);
}

static void check(const Problem& problem, const MinorClaim& claim) {
    const int excess = surplus(problem);
    if (excess != 0)
        throw Refused("it is not balanced: the images have dimension ", excess, " more");
    require_cameras(*problem.cameras, claim.placement.cameras);
    require_equal(jacobian_determinant(problem, claim.placement), claim.minor);
}

static void check(const Problem& problem, const UnbalancedClaim&) {
    if (surplus(problem) == 0) throw Refused("it is balanced");
}

void check_record(const Record& record, const Problem& problem) {
    std::visit([&](const auto& claim) { check(problem, claim); }, record.claim);
}
} // namespace checker
