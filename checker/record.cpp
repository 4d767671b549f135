#include "checker/record.h"

#include <numeric>

namespace checker {
Numbers read_cameras(Reader& reader, std::size_t pool, unsigned views) {
    if (pool > 99) reader.fail("pool", "at most 99 pools");
    reader.take(say("pool ", pool, " $"));
    Numbers cameras = reader.take("camera 2 quaternion @ @ @ @ translation @ @ @ $");
    const Numbers third = views == 2
                              ? Numbers{1, 0, 0, 0, 0, 0, 0}
                              : reader.take("camera 3 quaternion @ @ @ @ translation @ @ @ $");
    cameras.insert(cameras.end(), third.begin(), third.end());
    return cameras;
}

Numbers read_vectors(Reader& reader, unsigned pins) {
    std::string vectors = "point @ @ @";
    for (unsigned pin = 0; pin < pins; ++pin) vectors += " pin @ @ @";
    return reader.take(vectors + " $");
}

Numbers read_ascending(Reader& reader, std::int64_t largest) {
    Numbers list;
    do list.push_back(reader.integer(list.empty() ? 1 : list.back() + 1, largest));
    while (!reader.at_end() && !reader.comes("columns"));
    return list;
}

Record read_record(Reader& reader, bool minimal) {
    Record record{.line = reader.line()};
    if (!minimal) {
        record.stated = reader.take("rank # excess # # # star # $ delete rows");
        record.rows = read_ascending(reader, 999'999);
        reader.take("columns");
        record.columns = read_ascending(reader, camera_unknowns);
        reader.take("$ minor");
    }
    record.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    for (int i = 0; !minimal && i < 11 && (i == 0 || reader.comes("kernel")); ++i) {
        reader.take("kernel");
        for (mpz_class& entry : record.kernel.emplace_back()) entry = reader.big_integer();
        reader.end_line();
    }
    return record;
}

/// Refuses kernel vectors that have not the form of the basis, or do not keep all images.
static void check_kernel(const Record& record, const std::vector<const Block*>& blocks) {
    for (std::size_t i = 0; i < record.kernel.size(); ++i) {
        const Motion& motion = record.kernel[i];
        const std::string name = say("kernel vector ", i + 1);
        for (std::size_t j = 0; j < record.columns.size(); ++j)
            if (sgn(motion[static_cast<std::size_t>(record.columns[j] - 1)]) != (i == j))
                throw Refused(name, " has not the form of a basis at deleted column ", j + 1);
        mpz_class divisor = 0;
        for (const mpz_class& entry : motion) divisor = gcd(divisor, entry);
        if (divisor != 1) throw Refused(name, " has entries with a common divisor");
        for (const Block* block : blocks)
            for (const Motion& c : block->conditions)
                if (std::inner_product(c.begin(), c.end(), motion.begin(), mpz_class(0)) != 0)
                    throw Refused(name, " does not keep all images");
    }
}

void check_record(const Record& record, const Obstruction& truth,
                  const std::vector<const Block*>& blocks, const Numbers& absent) {
    const auto& [a, b, c] = truth.excess;
    const unsigned d = truth.deficiency();
    if (record.kernel.empty() ? d > 0 : record.stated != Numbers{11 - d, a, b, c, truth.star})
        throw Refused("it has rank ", 11 - d, ", excess ", a, ' ', b, ' ', c, ", S ", truth.star);
    if (record.rows.size() != d || record.columns.size() != d || record.kernel.size() != d)
        throw Refused("there must be ", d, " deleted rows, deleted columns and kernel vectors");
    std::size_t rows = 0; // of J
    for (const Block* block : blocks) rows += block->rows.size();
    if (d > 0 && record.rows.back() > std::int64_t(rows))
        throw Refused("J has only ", rows, " rows");
    const Residue value = minor(blocks, record.rows, d > 0 ? record.columns : absent);
    if (value != record.minor) throw Refused("the minor is ", value.value, " modulo q");
    check_kernel(record, blocks);
}
} // namespace checker
