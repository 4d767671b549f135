#include "tests/laws/relations.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace laws {

namespace {

constexpr std::array relations{
    NamedRelation{"a line with points on it in two views", "+W1 -E1.E1.E1 +E1.E1.T2 +E1.E1.T3 "
                                                           "-E1.L -2*E1.S1"},
    NamedRelation{
        "(L + S1) (L + S2)",
        "+L.L +L.S1 +L.S2 +S1.S2 -E1.E2.L +E1.T1.L +E1.T2.S2 -E1.T3.L -2*E1.T3.S2 +E2.T1.S1 "
        "+E2.T2.L -E2.T3.L -2*E2.T3.S1 -T1.T1.S1 +T1.T2.S1 +T1.T2.S2 -2*T1.T3.L -2*T1.T3.S2 "
        "-T2.T2.S2 -2*T2.T3.L -2*T2.T3.S1 +3*T3.T3.L +2*T3.T3.S1 +2*T3.T3.S2 +E1.E2.T3.T3 "
        "-E1.T1.T2.T3 +E1.T1.T3.T3 +E1.T2.T3.T3 -E1.T3.T3.T3 -E2.T1.T2.T3 +E2.T1.T3.T3 "
        "+E2.T2.T3.T3 -E2.T3.T3.T3 +T1.T1.T3.T3 +T1.T2.T3.T3 -2*T1.T3.T3.T3 +T2.T2.T3.T3 "
        "-2*T2.T3.T3.T3 +T3.T3.T3.T3 "},
    NamedRelation{
        "(L + S1)^2",
        "+2*L.L +4*L.S1 +2*S1.S1 -E1.Q -T1.Q +T2.Q +T3.Q +E1.E1.L +2*E1.E1.S1 -E1.E2.L "
        "-2*E1.E2.S2 -E1.E3.L -2*E1.E3.S3 +E1.T1.L +E1.T1.S1 -E1.T2.L -2*E1.T2.S1 +E1.T2.S2 "
        "-E1.T3.L -2*E1.T3.S1 +E1.T3.S3 -E2.T1.L -2*E2.T1.S2 +E2.T2.L +2*E2.T2.S2 +E2.T3.L "
        "+2*E2.T3.S2 -E3.T1.L -2*E3.T1.S3 +E3.T2.L +2*E3.T2.S3 +E3.T3.L +2*E3.T3.S3 -T1.T1.S1 "
        "+T1.T2.S1 +T1.T2.S2 +T1.T3.S1 +T1.T3.S3 -T2.T2.S2 -4*T2.T3.L -4*T2.T3.S1 -T2.T3.S2 "
        "-T2.T3.S3 -T3.T3.S3 +E1.E1.E1.E1 +E1.E1.E1.T1 -2*E1.E1.E1.T2 -2*E1.E1.E1.T3 "
        "-E1.E1.T1.T2 -E1.E1.T1.T3 +E1.E1.T2.T2 +2*E1.E1.T2.T3 +E1.E1.T3.T3 -E1.E2.E2.E2 "
        "+E1.E2.E2.T1 +E1.E2.E2.T3 -E1.E3.E3.E3 +E1.E3.E3.T1 +E1.E3.E3.T2 -E2.E2.E2.T1 "
        "+E2.E2.E2.T2 +E2.E2.E2.T3 +E2.E2.T1.T1 -E2.E2.T1.T2 -E2.E2.T2.T3 -E2.E2.T3.T3 "
        "-E3.E3.E3.T1 +E3.E3.E3.T2 +E3.E3.E3.T3 +E3.E3.T1.T1 -E3.E3.T1.T3 -E3.E3.T2.T2 "
        "-E3.E3.T2.T3 +2*T2.T2.T3.T3 "},
    NamedRelation{
        "L (S1 - S2)",
        "-2*L.S2 +2*E1.E1.E1.E1 +2*E1.E1.E1.E2 -3*E1.E1.E1.T1 -E1.E1.E1.T2 -2*E1.E1.E1.T3 "
        "-2*E1.E1.E2.T2 -2*E1.E1.E2.T3 +3*E1.E1.T1.T2 +3*E1.E1.T1.T3 -E1.E1.T2.T2 "
        "+E1.E1.T2.T3 -2*E1.E2.E2.E2 +2*E1.E2.E2.T1 +2*E1.E2.E2.T3 -2*E1.E3.E3.E3 "
        "+2*E1.E3.E3.T1 +2*E1.E3.E3.T2 -2*E1.T1.T2.T3 -2*E2.E2.E2.E2 +E2.E2.E2.T1 "
        "+3*E2.E2.E2.T2 +2*E2.E2.E2.T3 +E2.E2.T1.T1 -3*E2.E2.T1.T2 -E2.E2.T1.T3 "
        "-3*E2.E2.T2.T3 +2*E2.E3.E3.E3 -2*E2.E3.E3.T1 -2*E2.E3.E3.T2 +2*E2.T1.T2.T3 "
        "-E3.E3.E3.T1 +E3.E3.E3.T2 +E3.E3.T1.T1 -E3.E3.T2.T2 -2*T1.T1.T3.T3 +2*T2.T2.T3.T3 "
        "-2*L.E1.E3 -L.E1.T1 +L.E1.T2 +2*L.E2.E3 -L.E2.T1 +L.E2.T2 -L.E3.T1 +L.E3.T2 "
        "+4*L.T1.T3 -4*L.T2.T3 +2*S1.E1.E1 +4*S1.E1.E2 -6*S1.E1.T1 +2*S1.E1.T2 -2*S1.E2.T1 "
        "+S1.T1.T1 +S1.T1.T2 +2*S1.T1.T3 -4*S1.T2.T3 -4*S2.E1.E2 +2*S2.E1.T2 -2*S2.E2.E2 "
        "-2*S2.E2.T1 +6*S2.E2.T2 -S2.T1.T2 +4*S2.T1.T3 -S2.T2.T2 -2*S2.T2.T3 -4*S3.E1.E3 "
        "+2*S3.E1.T3 +4*S3.E2.E3 -2*S3.E2.T3 -2*S3.E3.T1 +2*S3.E3.T2 +S3.T1.T3 -S3.T2.T3 "
        "-2*Q.E1 +2*Q.E2 -Q.T1 +Q.T2 +2*L.S1 "},
    NamedRelation{
        "a point with a pin in all views",
        "-6*A +2*L.S1 +2*L.S2 +2*L.S3 +2*S1.S1 +2*S2.S2 +2*S3.S3 +E1.Q +E2.Q +E3.Q +2*T1.Q "
        "+2*T2.Q +2*T3.Q +E1.E1.L +2*E1.E2.L +2*E1.E2.S1 +2*E1.E2.S2 +2*E1.E3.L +2*E1.E3.S1 "
        "+2*E1.E3.S3 -2*E1.T1.L -E1.T1.S1 -E1.T2.S2 -E1.T3.S3 +E2.E2.L +2*E2.E3.L +2*E2.E3.S2 "
        "+2*E2.E3.S3 -E2.T1.S1 -2*E2.T2.L -E2.T2.S2 -E2.T3.S3 +E3.E3.L -E3.T1.S1 -E3.T2.S2 "
        "-2*E3.T3.L -E3.T3.S3 +2*T1.T1.S1 -2*T1.T2.S1 -2*T1.T2.S2 -2*T1.T3.S1 -2*T1.T3.S3 "
        "+2*T2.T2.S2 -2*T2.T3.S2 -2*T2.T3.S3 +2*T3.T3.S3 -E1.E1.E1.E1 +E1.E1.E1.E2 "
        "+E1.E1.E1.E3 +E1.E1.E1.T2 +E1.E1.E1.T3 -E1.E1.E2.T2 -E1.E1.E2.T3 -E1.E1.E3.T2 "
        "-E1.E1.E3.T3 -2*E1.E1.T2.T3 +E1.E2.E2.E2 -E1.E2.E2.T1 -E1.E2.E2.T3 +E1.E3.E3.E3 "
        "-E1.E3.E3.T1 -E1.E3.E3.T2 +2*E1.T1.T2.T3 -E2.E2.E2.E2 +E2.E2.E2.E3 +E2.E2.E2.T1 "
        "+E2.E2.E2.T3 -E2.E2.E3.T1 -E2.E2.E3.T3 -2*E2.E2.T1.T3 +E2.E3.E3.E3 -E2.E3.E3.T1 "
        "-E2.E3.E3.T2 +2*E2.T1.T2.T3 -E3.E3.E3.E3 +E3.E3.E3.T1 +E3.E3.E3.T2 -2*E3.E3.T1.T2 "
        "+2*E3.T1.T2.T3 "},
    NamedRelation{"E1^4 T2 = E1^4 T3", "+E1.E1.E1.E1.T2 -E1.E1.E1.E1.T3"},
    NamedRelation{"E1^3 S1", "+5*E1.E1.E1.S1 -5*E1.E1.E1.E1.T2 +3*E1.E1.E1.E1.E1"},
};

std::size_t feature_of(std::string_view symbol) {
    const auto found = std::ranges::find(symbols, symbol, &Symbol::name);
    if (found == symbols.end())
        throw std::invalid_argument("no feature is called " + std::string(symbol) +
                                    ": use the symbols of relations.h");
    return checker::index_of(found->notation);
}

/// The text up to a separator, which is removed with it.
std::string_view cut(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

/// A term such as `-2*E1.S1`.
Term parse_term(std::string_view text) {
    Term term{.coefficient = text.front() == '-' ? -1 : 1};
    text.remove_prefix(1);
    if (const std::size_t star = text.find('*'); star != std::string_view::npos) {
        std::int64_t size = 0;
        std::from_chars(text.data(), text.data() + star, size);
        term.coefficient *= size;
        text.remove_prefix(star + 1);
    }
    while (!text.empty())
        ++term.product[feature_of(cut(text, '.'))];
    return term;
}

} // namespace

std::vector<Term> parse_sum(std::string_view sum) {
    std::vector<Term> terms;
    while (!sum.empty())
        if (const std::string_view term = cut(sum, ' '); !term.empty())
            terms.push_back(parse_term(term));
    return terms;
}

std::vector<Relation> all_relations() {
    std::vector<Relation> all;
    for (const NamedRelation& named : relations) {
        std::vector<Term> terms = parse_sum(named.sum);
        const unsigned of_terms = weight(terms.front().product);
        all.push_back({std::string(named.name), of_terms, std::move(terms)});
    }
    return all;
}

} // namespace laws
