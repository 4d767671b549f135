// How many problems of each kind there are, as the paper says: T. Duff, K. Kohn, A. Leykin, T.
// Pajdla, "PL1P: Point-line minimal problems under partial visibility in three views", ECCV 2020.
// The catalogue shows these claims beside its own counts; nothing rests on them.
#pragma once

namespace plprove {

/// `rows` is what the catalogue counts instead, in SQL, from the sums of schema.cpp.
struct PaperCount {
    const char* quantity;
    int claimed;
    const char* rows;
};

inline constexpr PaperCount paper_counts[] = {
    {"label classes", 143494, "classes"},
    {"label classes, not minimal", 2878, "classes - minimal"},
    {"label classes, minimal", 140616, "minimal"},
    {"swap&label classes", 76446, "swap_classes"},
    {"swap&label classes, not minimal", 1871, "swap_classes - terminal"},
    {"terminal problems", 74575, "terminal"},
    {"minimal PL0Ps", 51, "pl0p"},
    {"terminal, at most one pin per point", 9533, "one_pin"},
    {"five-point extensions", 6300, "five_point"},
    {"five-point extensions, registration", 61, "registration"},
    {"five-point extensions, terminal", 3648, "terminal_five_point"},
    {"terminal, linear in the trifocal tensor", 66, "trifocal"},
    {"minimal, complete visibility", 12, "plmp"},
};

} // namespace plprove
