// What the paper claims: Duff, Kohn, Leykin, Pajdla, "PL1P: Point-line minimal problems under
// partial visibility in three views", ECCV 2020. Nothing is proved with these numbers; they are
// compared with what is.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace checker::paper {
/// A number of classes. Where the certified number is known to be another one: which, why, what is
/// counted, and a problem that shows it.
struct ClaimedCount {
    std::string_view name; // as in the counts of the checker
    std::size_t claimed = 0;
    std::size_t certified_instead = 0;
    std::string_view why{};
    std::string_view counted{};
};

inline constexpr std::array claimed_counts{
    ClaimedCount{"balanced signatures", 845161},
    ClaimedCount{"label classes", 143494},
    ClaimedCount{"swap&label classes", 76446},
    ClaimedCount{"label classes, not minimal", 2878},
    ClaimedCount{"label classes, minimal", 140616},
    ClaimedCount{"swap&label classes, not minimal", 1871},
    ClaimedCount{"terminal camera-minimal", 74575},
    ClaimedCount{"reduced minimal PL0Ps (no pins)", 51},
    ClaimedCount{"terminal, at most one pin a point", 9533},
    ClaimedCount{
        "five-point extensions, minimal", 6300, 6413,
        "the authors' script skips its list of re-checked classes",
        "minimal problems in which some two views share exactly five points, one for each "
        "label class.\n  Witness: class 72050, 2*a/P/Pa + 2*P/a/Pa + 3*-/P/P, is one, and "
        "the script leaves it out. proofs/classification.md, section 7, shows by hand that "
        "it is minimal."},
    ClaimedCount{"- of these, camera registration", 61},
    ClaimedCount{"- terminal camera-minimal", 3648, 3615,
                 "probably a misprint of 3548, the number that the authors' script gives",
                 "the same, one for each swap&label class.\n  The script skips its list of "
                 "re-checked classes here, too: 3548 = 3615 - 67. Skipping only makes a number "
                 "smaller, so it does not explain 3648."},
    ClaimedCount{
        "- PL0Ps", 4, 19, "the paper counts those that are camera registrations",
        "minimal problems without pins in which some two views share exactly five points."
        "\n  Witness: class 7024, 2*P/P/P + 3*-/P/P + 2*P/-/P, in which views 2 and 3 share "
        "five points."},
    ClaimedCount{"- - of these, camera registration", 4},
    ClaimedCount{"minimal, complete visibility", 12},
    ClaimedCount{"terminal, on Kileel's list (linear in the trifocal tensor)", 66},
    ClaimedCount{"- of these, minimal", 16},
    ClaimedCount{"- - with complete visibility", 2},
    ClaimedCount{"- - with partial visibility", 14},
    ClaimedCount{"- of these, not minimal", 50},
    ClaimedCount{"terminal, completely visible or on Kileel's list", 76},
    ClaimedCount{"terminal, neither", 74499},
};

/// The problems with complete visibility: the names of PLMP (ICCV 2019) that the paper uses, too.
inline constexpr std::array<std::string_view, 12> complete_visibility{
    "3002_1", "3002_2", "3010_0", "2005_3", "2005_4", "2005_5",
    "2013_2", "2013_3", "2021_1", "1024_4", "1032_2", "1040_0"};

/// How many problems have a degree.
struct ClaimedDegrees {
    std::size_t degree = 0;
    std::size_t problems = 0;
};

/// Table 2(a): terminal problems with a degree below 300.
inline constexpr std::size_t table_2a_limit = 300;
inline constexpr std::array<ClaimedDegrees, 11> table_2a{{{64, 13},
                                                          {80, 9},
                                                          {144, 3},
                                                          {160, 547},
                                                          {216, 7},
                                                          {224, 2},
                                                          {240, 159},
                                                          {256, 2},
                                                          {264, 2},
                                                          {272, 11},
                                                          {288, 4}}};

/// Table 2(b): those with at most one pin a point, and a degree below 500.
inline constexpr std::size_t table_2b_limit = 500;
inline constexpr std::array<ClaimedDegrees, 29> table_2b{
    {{80, 9},  {160, 173}, {216, 4},   {240, 80}, {256, 2},  {264, 2}, {272, 2}, {288, 1},
     {304, 5}, {312, 2},   {320, 213}, {352, 3},  {360, 9},  {368, 3}, {376, 1}, {384, 2},
     {392, 9}, {400, 14},  {408, 2},   {416, 6},  {424, 10}, {432, 2}, {448, 7}, {456, 11},
     {464, 4}, {472, 1},   {480, 96},  {488, 12}, {496, 9}}};

/// The degree of a problem.
struct ClaimedDegree {
    std::string_view problem;
    std::size_t degree = 0;
};

/// The introduction's example: 3 PPP and 1 PPL correspondences.
inline constexpr ClaimedDegree example{"3*P/P/P + a/P/Pa", 272};

/// Section 6: four PL0Ps register a camera. The solutions of this, beside the 20 relative poses.
inline constexpr std::array<ClaimedDegree, 4> registrations{{{"3*P/P/P + 2*-/P/P", 8},
                                                             {"2*P/P/P + a/a/a + 3*-/P/P", 4},
                                                             {"P/P/P + 2*a/a/a + 4*-/P/P", 8},
                                                             {"3*a/a/a + 5*-/P/P", 8}}};

/// The table of PL0Ps, as the authors published it with their data (repository timduff35/PL1P,
/// examples/pl0p-table.tex, commit de4f2338).
inline constexpr std::array<ClaimedDegree, 51> pl0ps{{
    {"3*P/P/P + a/a/a", 216},
    {"3*P/P/P + 2*-/P/P", 160},
    {"3*P/P/P + -/P/P + P/-/P", 384},
    {"2*P/P/P + 2*a/a/a + -/P/P", 256},
    {"2*P/P/P + a/a/a + 3*-/P/P", 80},
    {"2*P/P/P + a/a/a + 2*-/P/P + P/-/P", 416},
    {"2*P/P/P + a/a/a + -/P/P + P/-/P + P/P/-", 568},
    {"2*P/P/P + 3*-/P/P + 2*P/-/P", 320},
    {"2*P/P/P + 3*-/P/P + P/-/P + P/P/-", 320},
    {"2*P/P/P + 2*-/P/P + 2*P/-/P + P/P/-", 768},
    {"P/P/P + 4*a/a/a", 360},
    {"P/P/P + 3*a/a/a + 2*-/P/P", 512},
    {"P/P/P + 3*a/a/a + -/P/P + P/-/P", 616},
    {"P/P/P + 2*a/a/a + 4*-/P/P", 160},
    {"P/P/P + 2*a/a/a + 3*-/P/P + P/-/P", 528},
    {"P/P/P + 2*a/a/a + 2*-/P/P + 2*P/-/P", 776},
    {"P/P/P + 2*a/a/a + 2*-/P/P + P/-/P + P/P/-", 984},
    {"P/P/P + a/a/a + 4*-/P/P + 2*P/-/P", 320},
    {"P/P/P + a/a/a + 4*-/P/P + P/-/P + P/P/-", 320},
    {"P/P/P + a/a/a + 3*-/P/P + 3*P/-/P", 720},
    {"P/P/P + a/a/a + 3*-/P/P + 2*P/-/P + P/P/-", 1024},
    {"P/P/P + a/a/a + 2*-/P/P + 2*P/-/P + 2*P/P/-", 1456},
    {"P/P/P + 4*-/P/P + 4*P/-/P", 400},
    {"P/P/P + 4*-/P/P + 3*P/-/P + P/P/-", 560},
    {"P/P/P + 4*-/P/P + 2*P/-/P + 2*P/P/-", 640},
    {"P/P/P + 3*-/P/P + 3*P/-/P + 2*P/P/-", 1376},
    {"5*a/a/a + -/P/P", 920},
    {"4*a/a/a + 3*-/P/P", 744},
    {"4*a/a/a + 2*-/P/P + P/-/P", 1416},
    {"4*a/a/a + -/P/P + P/-/P + P/P/-", 1608},
    {"3*a/a/a + 5*-/P/P", 160},
    {"3*a/a/a + 4*-/P/P + P/-/P", 800},
    {"3*a/a/a + 3*-/P/P + 2*P/-/P", 1480},
    {"3*a/a/a + 3*-/P/P + P/-/P + P/P/-", 1656},
    {"3*a/a/a + 2*-/P/P + 2*P/-/P + P/P/-", 2232},
    {"2*a/a/a + 5*-/P/P + 2*P/-/P", 320},
    {"2*a/a/a + 5*-/P/P + P/-/P + P/P/-", 320},
    {"2*a/a/a + 4*-/P/P + 3*P/-/P", 1040},
    {"2*a/a/a + 4*-/P/P + 2*P/-/P + P/P/-", 1360},
    {"2*a/a/a + 3*-/P/P + 3*P/-/P + P/P/-", 2016},
    {"2*a/a/a + 3*-/P/P + 2*P/-/P + 2*P/P/-", 2568},
    {"a/a/a + 5*-/P/P + 4*P/-/P", 400},
    {"a/a/a + 5*-/P/P + 3*P/-/P + P/P/-", 560},
    {"a/a/a + 5*-/P/P + 2*P/-/P + 2*P/P/-", 640},
    {"a/a/a + 4*-/P/P + 4*P/-/P + P/P/-", 1200},
    {"a/a/a + 4*-/P/P + 3*P/-/P + 2*P/P/-", 1920},
    {"a/a/a + 3*-/P/P + 3*P/-/P + 3*P/P/-", 2688},
    {"5*-/P/P + 5*P/-/P + P/P/-", 400},
    {"5*-/P/P + 4*P/-/P + 2*P/P/-", 800},
    {"5*-/P/P + 3*P/-/P + 3*P/P/-", 960},
    {"4*-/P/P + 4*P/-/P + 3*P/P/-", 2000},
}};
} // namespace checker::paper
