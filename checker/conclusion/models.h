// What the files of a run prove of models (FORMAT.md, section 16).
#pragma once

#include "checker/conclusion/judgement.h"

namespace checker {
/// What all files of a model prove together.
struct ProvedModel {
    std::string name{};
    std::size_t claimed = 0; // by its source; 0 if nothing is claimed
    std::size_t at_least = 0;
    std::optional<std::size_t> at_most{};
    std::vector<CycleType> cycle_types{}; // that fibres show
    std::vector<std::string> files{};

    bool minimal() const { return at_least > 0; }
    bool excluded() const { return at_most == std::size_t{0}; } // not minimal
    bool exact() const { return minimal() && at_most == at_least; }
    /// What is known of the group of its solutions; empty if nothing (frobenius.h).
    std::string group() const {
        return exact() ? group_shown_by(cycle_types, at_least, Orbits::unknown) : "";
    }
};

/// Of each model that a file which counts is about, by its text.
std::map<std::string, ProvedModel> models_of(const Findings& findings);

/// Files of a model whose bounds contradict each other.
Contradictions contradictions_of_models(const std::vector<ReplayedFile>& files);

/// Whether what is certified is what the model's source claims: `confirmed`, `differs`, `no claim`,
/// or `open`.
std::string_view verdict_on(const ProvedModel& model);

/// The model as a statement: `p3p has exactly 8 solutions`, perhaps with its group.
std::string in_words(const ProvedModel& model);

Judgement judge(const Findings& findings, const ExpectedModel& expected);
} // namespace checker
