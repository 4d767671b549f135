// Mutants of certificate files: one small change of a named kind, anywhere in the file, or a splice
// of two files. The same for the same seed, on every machine.
#pragma once

#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mutation {

class Random {
public:
    explicit Random(std::uint64_t seed) : source_(seed) {}
    /// Less than `bound`, which is positive.
    std::size_t below(std::size_t bound) { return source_() % bound; }

private:
    std::mt19937_64 source_;
};

/// Lines of words.
using File = std::vector<std::vector<std::string>>;

File split(std::string_view text);
std::string join(const File& file);

/// A way to change a file; `other` is another valid file of the same kind. Leaves the file as it is
/// where it does not apply.
struct Mutator {
    std::string_view name;
    void (*apply)(File& file, const File& other, Random& random);
};

/// Those of what only some kinds of file have: problems with steps and verdicts; problems in
/// general; records of solutions, and eliminations; the text of a model, and fibres.
std::span<const Mutator> problem_mutators();
std::span<const Mutator> general_mutators();
std::span<const Mutator> degree_mutators();
std::span<const Mutator> model_mutators();

struct Mutant {
    std::string_view mutator;
    std::string text;
};

/// A changed file: mutators take turns, and one time in eight a second one comes on top. Nothing
/// where the mutator does not apply.
std::optional<Mutant> mutant(const std::string& base, const std::string& other, std::size_t turn,
                             Random& random);

} // namespace mutation
