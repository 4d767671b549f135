#include "tests/mutation/edits.h"

namespace mutation {

namespace {

/// The lines of a record of a class.
struct Block {
    std::size_t first, end;
};

std::vector<Block> blocks(const File& file) {
    std::vector<Block> found;
    for (const std::size_t line : lines_of(file, {"degree"})) {
        if (!found.empty()) found.back().end = line;
        found.push_back({line, file.size()});
    }
    return found;
}

std::vector<Words> lines(const File& file, const Block& block) {
    return {file.begin() + static_cast<std::ptrdiff_t>(block.first),
            file.begin() + static_cast<std::ptrdiff_t>(block.end)};
}

void replace(File& file, const Block& block, const std::vector<Words>& replacement) {
    file.erase(at(file, block.first), at(file, block.end));
    file.insert(at(file, block.first), replacement.begin(), replacement.end());
}

/// A record lost, doubled, in another's place, or that of another file.
void records(File& file, const File& other, Random& random) {
    const auto found = blocks(file), others = blocks(other);
    if (found.empty() || others.empty()) return;
    const Block block = any_of(found, random), second = any_of(found, random);
    const auto foreign = lines(other, any_of(others, random));
    switch (random.below(4)) {
    case 0:
        replace(file, block, {});
        return;
    case 1:
        file.insert(at(file, second.first), foreign.begin(), foreign.end());
        return;
    case 2:
        replace(file, block, foreign);
        return;
    default: {
        const auto moved = lines(file, second);
        file.insert(at(file, block.first), moved.begin(), moved.end());
    }
    }
}

/// A certificate under the number of another class.
void class_number(File& file, const File& other, Random& random) {
    const auto heads = lines_of(file, {"degree"}), others = lines_of(other, {"degree"});
    if (heads.empty() || others.empty()) return;
    Words& head = file[any_of(heads, random)];
    if (head.size() < 2) return;
    std::string& number = head[1];
    const std::size_t kind = random.below(3);
    if (kind == 0)
        step(number, random);
    else if (kind == 1)
        number = std::to_string(random.below(143'600));
    else
        number = other[any_of(others, random)][1];
}

/// The images, or the solutions, of a record of another file.
void foreign_part(File& file, const File& other, Random& random) {
    const auto found = blocks(file), others = blocks(other);
    if (found.empty() || others.empty() || lines_of(file, {"degree"}).empty()) return;
    const Block block = any_of(found, random);
    const bool images = random.below(2) == 0;
    const auto belongs = [images](const Words& words) { return (words[0] == "image") == images; };
    const auto own = lines(file, block), foreign = lines(other, any_of(others, random));
    std::vector<Words> mixed{own[0]};
    // Images come first, whichever file they are of.
    for (const auto* part : {images ? &foreign : &own, images ? &own : &foreign})
        for (std::size_t i = 1; i < part->size(); ++i)
            if (belongs((*part)[i]) == (part == &foreign)) mixed.push_back((*part)[i]);
    replace(file, block, mixed);
}

/// A solution that comes again as it is, moved a little, with more digits, or conjugate.
void solution_again(File& file, const File&, Random& random) {
    const auto solutions = lines_of(file, {"real", "pair"});
    if (solutions.empty()) return;
    const std::size_t line = any_of(solutions, random);
    Words copy = file[line];
    const std::size_t kind = random.below(4);
    for (std::size_t i = 2; i < copy.size(); ++i)
        if (kind == 1)
            step(copy[i], random);
        else if (kind == 2)
            multiply(copy[i], 2);
        else if (kind == 3 && copy[0] == "pair" && i % 2 == 1)
            multiply(copy[i], -1);
    if (kind == 2) add(copy[1], 1);
    file.insert(at(file, random.below(2) == 0 ? line : any_of(solutions, random)), copy);
}

/// Other starting values, which lead to the same solution, or to none.
void solution_moved(File& file, const File&, Random& random) {
    const auto solutions = lines_of(file, {"real", "pair"});
    if (solutions.empty()) return;
    Words& words = file[any_of(solutions, random)];
    if (words.size() < 3) return;
    const long amount = 1L << random.below(24);
    switch (random.below(4)) {
    case 0: // the same values times a power of two
        step(words[1], random);
        return;
    case 1:
        std::for_each(words.begin() + 2, words.end(), [](auto& word) { multiply(word, -1); });
        return;
    case 2:
        add(*(words.begin() + 2 + static_cast<std::ptrdiff_t>(random.below(words.size() - 2))),
            random.below(2) == 0 ? amount : -amount);
        return;
    default: // another coordinate's
        std::swap(words[2 + random.below(words.size() - 2)],
                  words[2 + random.below(words.size() - 2)]);
    }
}

/// A pair as a real solution, a real solution as a pair, a pair as two that are nearly real.
void real_or_not(File& file, const File&, Random& random) {
    const auto solutions = lines_of(file, {"real", "pair"});
    if (solutions.empty()) return;
    const std::size_t line = any_of(solutions, random);
    const Words old = file[line];
    Words changed{old[0] == "real" ? "pair" : "real"};
    for (std::size_t i = 1; i < old.size(); ++i) {
        if (old[0] == "real" || i < 2 || i % 2 == 0) changed.push_back(old[i]);
        if (old[0] == "real" && i > 1) changed.push_back(std::to_string(random.below(2)));
    }
    file[line] = changed;
    if (old[0] == "pair" && random.below(2) == 0) file.insert(at(file, line), changed);
}

/// Another point of an image line, which stays the same; or of another line.
void toward(File& file, const File&, Random& random) {
    const auto images = lines_of(file, {"image"});
    if (images.empty()) return;
    Words& words = file[any_of(images, random)];
    std::vector<std::size_t> places;
    for (std::size_t i = 4; i + 3 < words.size(); ++i)
        if (words[i] == "toward") places.push_back(i + 1);
    if (places.empty()) return;
    const std::size_t place = any_of(places, random);
    std::size_t point = place;
    while (point > 0 && words[point - 1] != "point" && words[point - 1] != "image")
        --point;
    if (point == 0 || point + 2 >= place) return;
    const std::size_t from = random.below(4) == 0 ? 2 : point; // 2: what comes first
    for (std::size_t k = 0; k < 3; ++k)
        words[place + k] =
            mpz_class(value_of(words[place + k]) + value_of(words[from + k])).get_str();
}

/// A monomial lost, put in or replaced in a list.
void monomials(File& file, const File& other, Random& random) {
    const auto lists = lines_of(file, {"basis", "rows"}), others = lines_of(other, {"basis"});
    if (lists.empty() || others.empty()) return;
    Words& words = file[any_of(lists, random)];
    const std::size_t start = words[0] == "rows" ? 2 : 1;
    if (words.size() <= start) return;
    const std::size_t place = start + random.below(words.size() - start);
    switch (random.below(4)) {
    case 0:
        words.erase(at(words, place));
        return;
    case 1: {
        Words copy = words;
        add(copy[place], 1 + static_cast<long>(random.below(3)));
        words.insert(at(words, place + 1), copy[place]);
        return;
    }
    case 2:
        step(words[place], random);
        return;
    default: {
        const Words& foreign = other[any_of(others, random)];
        words.erase(at(words, start), words.end());
        words.insert(words.end(), foreign.begin() + 1, foreign.end());
    }
    }
}

/// A smaller basis, with a further row: an elimination of the right shape for a smaller bound; or
/// the reverse.
void basis_and_rows(File& file, const File&, Random& random) {
    const auto bases = lines_of(file, {"basis"});
    if (bases.empty()) return;
    const std::size_t line = any_of(bases, random);
    std::size_t end = line + 1;
    while (end < file.size() && file[end][0] == "rows")
        ++end;
    if (end == line + 1 || file[line].size() < 2) return;
    Words& basis = file[line];
    Words& rows = file[line + 1 + random.below(end - line - 1)];
    if (rows.size() < 3) return;
    const std::size_t row = 2 + random.below(rows.size() - 2);
    const std::size_t last = value_of(rows.back()).get_ui();
    const std::string added = std::to_string(1 + random.below(last + 2));
    if (random.below(4) == 0) {
        basis.push_back(added);
        rows.erase(at(rows, row));
    } else {
        basis.erase(at(basis, 1 + random.below(basis.size() - 1)));
        rows.push_back(added);
    }
    // Ascending again, so that it is not the order that is refused.
    const auto less = [](const std::string& a, const std::string& b) {
        return value_of(a) < value_of(b);
    };
    std::sort(basis.begin() + 1, basis.end(), less);
    std::sort(rows.begin() + 2, rows.end(), less);
}

/// An equation in the place of another one.
void equation(File& file, const File&, Random& random) {
    const auto rows = lines_of(file, {"rows"});
    if (rows.empty()) return;
    Words& words = file[any_of(rows, random)];
    if (words.size() < 2) return;
    if (random.below(2) == 0)
        step(words[1], random);
    else
        words[1] = std::to_string(1 + random.below(30));
}

/// Other degrees of the columns, or other variables.
void groups(File& file, const File& other, Random& random) {
    const auto own = lines_of(file, {"degree"}), others = lines_of(other, {"degree"});
    if (own.empty() || others.empty() || lines_of(file, {"basis"}).empty()) return;
    Words& words = file[any_of(own, random)];
    if (random.below(2) == 0)
        step(words[1], random);
    else
        words = other[any_of(others, random)];
}

constexpr std::array all{Mutator{"record", records},
                         Mutator{"another class's number", class_number},
                         Mutator{"part of another record", foreign_part},
                         Mutator{"solution again", solution_again},
                         Mutator{"solution moved", solution_moved},
                         Mutator{"real or not", real_or_not},
                         Mutator{"point on an image line", toward},
                         Mutator{"monomials", monomials},
                         Mutator{"basis and rows", basis_and_rows},
                         Mutator{"equation", equation},
                         Mutator{"groups", groups}};

} // namespace

std::span<const Mutator> degree_mutators() {
    return all;
}

} // namespace mutation
