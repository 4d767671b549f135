#include "checker/minimal/record.h"

namespace checker {
Numbers read_ascending(Reader& reader, int largest) {
    Numbers list;
    do {
        const int least = list.empty() ? 1 : list.back() + 1;
        list.push_back(reader.small_integer(least, largest));
    } while (!reader.at_end() && !reader.comes("columns"));
    return list;
}

Record read_record(Reader& reader, bool minimal) {
    Record record{.line = reader.line(), .minimal = minimal};
    if (!minimal) {
        record.stated = reader.take("rank # excess # # # star # $ delete rows");
        record.deleted_rows = read_ascending(reader, 999'999);
        reader.take("columns");
        record.deleted_columns = read_ascending(reader, camera_unknowns);
        reader.take("$ minor");
    }
    record.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    if (minimal) return record;
    do {
        if (record.kernel.size() == camera_unknowns)
            reader.fail("kernel", "at most 11 kernel vectors");
        reader.take("kernel");
        for (mpz_class& entry : record.kernel.emplace_back(camera_unknowns))
            entry = reader.big_integer(1000);
        reader.end_line();
    } while (reader.comes("kernel"));
    return record;
}

/// Whether the motion keeps all images of the feature, if this moves along.
static bool keeps_images(const std::vector<mpz_class>& motion, const Contribution& contribution) {
    for (const std::vector<mpz_class>& condition : contribution.conditions) {
        mpz_class change = 0;
        for (std::size_t c = 0; c < camera_unknowns; ++c)
            change += condition[c] * motion[c];
        if (change != 0) return false;
    }
    return true;
}

/// Refuses the i-th kernel vector unless it is in basis form and keeps all images: at the deleted
/// columns it is positive in the i-th and zero in the others, so that all vectors are independent.
static void check_kernel_vector(const Record& record, std::size_t i,
                                const std::vector<const Contribution*>& contributions) {
    const std::vector<mpz_class>& motion = record.kernel[i];
    const std::string name = say("kernel vector ", i + 1);
    for (std::size_t j = 0; j < record.deleted_columns.size(); ++j) {
        const auto column = static_cast<std::size_t>(record.deleted_columns[j] - 1);
        const int expected_sign = i == j ? 1 : 0;
        if (sgn(motion[column]) != expected_sign)
            throw Refused(name, " is not in basis form at deleted column ", j + 1);
    }
    mpz_class divisor = 0;
    for (const mpz_class& entry : motion)
        divisor = gcd(divisor, entry);
    if (divisor != 1) throw Refused(name, " has entries with a common divisor");
    for (const Contribution* contribution : contributions)
        if (!keeps_images(motion, *contribution)) throw Refused(name, " does not keep all images");
}

/// Refuses a record whose numbers are not those of the obstruction.
static void check_stated(const Record& record, const Obstruction& obstruction) {
    const unsigned deficiency = obstruction.deficiency();
    const auto& [first, second, third] = obstruction.excess;
    const std::array<unsigned, 5> expected{11 - deficiency, first, second, third, obstruction.star};
    const bool as_stated = std::equal(record.stated.begin(), record.stated.end(), expected.begin(),
                                      expected.end(), std::cmp_equal<int, unsigned>);
    if (record.minimal ? deficiency > 0 : !as_stated)
        throw Refused("it has rank ", expected[0], ", excess ", first, ' ', second, ' ', third,
                      ", S ", expected[4]);
    for (const std::size_t count :
         {record.deleted_rows.size(), record.deleted_columns.size(), record.kernel.size()})
        if (count != deficiency)
            throw Refused("there must be ", deficiency,
                          " deleted rows, deleted columns and kernel vectors");
}

/// The block of an contribution without those of its rows that are listed by their numbers in J;
/// its first row has the number `first`. The list ascends.
static Block block_without(const Numbers& deleted, const Contribution& contribution, int first) {
    Rows<mpz_class> kept;
    int number = first;
    for (const std::vector<mpz_class>& row : contribution.rows)
        if (!std::ranges::binary_search(deleted, number++)) kept.push_back(row);
    return eliminate(contribution.unknowns, modulo_q(kept));
}

Residue minor_without(const Record& record, const std::vector<const Contribution*>& contributions,
                      std::size_t camera_columns) {
    std::vector<const Block*> blocks;
    std::vector<Block> shorter;
    shorter.reserve(record.deleted_rows.size());
    int row = 1; // of J, the first of the contribution
    for (const Contribution* contribution : contributions) {
        const int first = row;
        row += static_cast<int>(contribution->rows.size());
        const auto next = std::ranges::lower_bound(record.deleted_rows, first);
        const bool loses_rows = next != record.deleted_rows.end() && *next < row;
        if (loses_rows) shorter.push_back(block_without(record.deleted_rows, *contribution, first));
        blocks.push_back(loses_rows ? &shorter.back() : &contribution->block);
    }
    if (!record.deleted_rows.empty() && record.deleted_rows.back() >= row)
        throw Refused("J has only ", row - 1, " rows");
    return minor_of(blocks, camera_columns, record.deleted_columns);
}

void check_record(const Record& record, const Obstruction& obstruction,
                  const std::vector<const Contribution*>& contributions,
                  std::size_t camera_columns) {
    check_stated(record, obstruction);
    const Residue minor = minor_without(record, contributions, camera_columns);
    if (minor != record.minor) throw Refused("the minor is ", minor.value, " modulo q");
    for (std::size_t i = 0; i < record.kernel.size(); ++i)
        check_kernel_vector(record, i, contributions);
}
} // namespace checker
