#include "checker/counts/counts.h"

#include "checker/counts/families.h"

#include <algorithm>

namespace checker {
/// A label class, and what the counts ask of it.
struct CountedClass {
    const Signature& signature;
    const Obstruction& obstruction;
    bool represents_swap_class;

    bool minimal() const { return obstruction.minimal(); }
    /// Minimal classes that represent their swap&label class stand for the terminal problems.
    bool terminal() const { return minimal() && represents_swap_class; }
    bool kileel() const { return terminal() && linear_in_trifocal_tensor(signature); }
    bool minimal_as_it_stands() const { return !terminal_has_dangling_pins(signature); }
    bool complete() const { return completely_visible(signature); }
};

struct CountDefinition {
    std::string_view name;
    bool (*counts)(const CountedClass&);
};

using C = const CountedClass&;
static constexpr std::array definitions{
    CountDefinition{"label classes", [](C) { return true; }},
    CountDefinition{"swap&label classes", [](C c) { return c.represents_swap_class; }},
    CountDefinition{"label classes, not minimal", [](C c) { return !c.minimal(); }},
    CountDefinition{"label classes, minimal", [](C c) { return c.minimal(); }},
    CountDefinition{"swap&label classes, not minimal",
                    [](C c) { return c.represents_swap_class && !c.minimal(); }},
    CountDefinition{"terminal camera-minimal", [](C c) { return c.terminal(); }},
    CountDefinition{"reduced minimal PL0Ps (no pins)",
                    [](C c) { return c.minimal() && is_pl0p(c.signature); }},
    CountDefinition{"terminal, at most one pin a point",
                    [](C c) { return c.terminal() && at_most_one_pin(c.signature); }},
    CountDefinition{"five-point extensions, minimal",
                    [](C c) { return c.minimal() && extends_five_points(c.signature); }},
    CountDefinition{"- of these, camera registration",
                    [](C c) { return c.minimal() && is_registration(c.signature); }},
    CountDefinition{"- terminal camera-minimal",
                    [](C c) { return c.terminal() && extends_five_points(c.signature); }},
    CountDefinition{"- PL0Ps",
                    [](C c) {
                        return c.minimal() && extends_five_points(c.signature) &&
                               is_pl0p(c.signature);
                    }},
    CountDefinition{
        "- - of these, camera registration",
        [](C c) { return c.minimal() && is_registration(c.signature) && is_pl0p(c.signature); }},
    CountDefinition{"minimal, complete visibility",
                    [](C c) { return c.minimal() && c.complete(); }},
    CountDefinition{"terminal, on Kileel's list (linear in the trifocal tensor)",
                    [](C c) { return c.kileel(); }},
    CountDefinition{"- of these, minimal",
                    [](C c) { return c.kileel() && c.minimal_as_it_stands(); }},
    CountDefinition{"- - with complete visibility",
                    [](C c) { return c.kileel() && c.minimal_as_it_stands() && c.complete(); }},
    CountDefinition{"- - with partial visibility",
                    [](C c) { return c.kileel() && c.minimal_as_it_stands() && !c.complete(); }},
    CountDefinition{"- of these, not minimal",
                    [](C c) { return c.kileel() && !c.minimal_as_it_stands(); }},
    CountDefinition{"terminal, completely visible or on Kileel's list",
                    [](C c) { return c.terminal() && (c.complete() || c.kileel()); }},
    CountDefinition{"terminal, neither",
                    [](C c) { return c.terminal() && !c.complete() && !c.kileel(); }},
    CountDefinition{"not minimal: epipolar excess, E > 0",
                    [](C c) { return c.obstruction.epipolar() > 0; }},
    CountDefinition{"not minimal: a star alone, S = 1, E = 0",
                    [](C c) { return c.obstruction.star > 0 && c.obstruction.epipolar() == 0; }},
    CountDefinition{"not minimal: both, S = 1, E > 0",
                    [](C c) { return c.obstruction.star > 0 && c.obstruction.epipolar() > 0; }},
};

/// The first definitions are of classes, whatever is proved of them.
static constexpr std::size_t by_enumeration = 2;

std::vector<Count> count_classes(const Classification& classes, const Verdicts& verdicts) {
    const bool all_proved =
        std::ranges::all_of(verdicts, [](const auto& verdict) { return verdict.has_value(); });
    const std::size_t known = all_proved ? definitions.size() : by_enumeration;
    std::array<std::size_t, definitions.size()> numbers{};
    for (std::size_t n = 0; n < verdicts.size(); ++n) {
        const Obstruction obstruction = verdicts[n].value_or(Obstruction{});
        const CountedClass counted{classes.representatives[n], obstruction,
                                   classes.represents_swap_class(n)};
        for (std::size_t i = 0; i < known; ++i)
            if (definitions[i].counts(counted)) ++numbers[i];
    }
    std::vector<Count> counts{{"balanced signatures", classes.signatures}};
    for (std::size_t i = 0; i < definitions.size(); ++i) {
        Count& count = counts.emplace_back(Count{definitions[i].name, std::nullopt});
        if (i < known) count.certified = numbers[i];
    }
    return counts;
}
} // namespace checker
