#include "checker/conclusion/models.h"

#include "checker/conclusion/group.h"

namespace checker {
static void add(ProvedModel& model, const ModelFile& file, const std::string& name) {
    model.name = file.name;
    model.claimed = file.claimed;
    model.at_least = std::max(model.at_least, file.at_least);
    if (file.at_most)
        model.at_most = std::min(model.at_most.value_or(*file.at_most), *file.at_most);
    model.cycle_types.insert(model.cycle_types.end(), file.cycle_types.begin(),
                             file.cycle_types.end());
    if (std::ranges::find(model.files, name) == model.files.end()) model.files.push_back(name);
}

std::map<std::string, ProvedModel> models_of(const Findings& findings) {
    std::map<std::string, ProvedModel> models;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (const auto* file = std::get_if<ModelFile>(&findings.files[i].content))
            if (findings.counts(i)) add(models[file->text], *file, findings.files[i].name);
    return models;
}

Contradictions contradictions_of_models(const std::vector<ReplayedFile>& files) {
    std::map<std::string, ProvedModel> models;
    for (const ReplayedFile& file : files)
        if (const auto* content = std::get_if<ModelFile>(&file.content))
            add(models[content->text], *content, file.name);
    Contradictions found;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto* content = std::get_if<ModelFile>(&files[i].content);
        if (!content) continue;
        const ProvedModel& model = models[content->text];
        if (model.at_most && *model.at_most < model.at_least)
            found.emplace(i, say("the model ", model.name, " has at least ", model.at_least,
                                 " solutions, and at most ", *model.at_most));
    }
    return found;
}

std::string_view verdict_on(const ProvedModel& model) {
    if (model.claimed == 0) return "no claim";
    if (model.at_least > model.claimed) return "differs: more are certified";
    if (model.at_most && *model.at_most < model.claimed) return "differs: fewer are certified";
    return model.exact() ? "confirmed" : "open";
}

std::string in_words(const ProvedModel& model) {
    const auto solutions = [](std::size_t n) { return counted(n, "solution"); };
    const std::string group = model.group();
    if (model.exact())
        return say(model.name, " has exactly ", solutions(model.at_least),
                   group.empty() ? "" : ", and" + group_in_words(group));
    if (model.excluded())
        return say(model.name, " is not minimal: for generic data it has no solution");
    if (!model.minimal()) return say(model.name, " has at most ", solutions(*model.at_most));
    std::string text = say(model.name, " is minimal, with at least ", solutions(model.at_least));
    return model.at_most ? say(text, " and at most ", *model.at_most) : text;
}

/// What the files miss of an expected number of solutions; empty if nothing.
static std::string missing(const ProvedModel& model, const ExpectedDegree& expected) {
    const auto& [exactly, solutions] = expected;
    if (model.at_least < solutions)
        return say("a fibre proves at least ", model.at_least, " solutions only");
    if (!exactly) return {};
    if (!model.at_most) return "no elimination bounds its solutions from above";
    if (*model.at_most > solutions)
        return say("eliminations prove at most ", *model.at_most, " solutions only");
    return model.exact() && model.at_least == solutions
               ? ""
               : say("it has at least ", model.at_least, " solutions");
}

/// What the files miss of what is expected; empty if nothing.
static std::string missing(const ProvedModel& model, const ExpectedModel& expected) {
    if (model.excluded()) return "it is proved not minimal";
    if (!model.minimal()) return "no fibre holds, so it is not proved minimal";
    if (expected.degree)
        if (const std::string gap = missing(model, *expected.degree); !gap.empty()) return gap;
    if (expected.group.empty()) return {};
    const std::string group = model.group();
    if (group.empty())
        return say("no fibres certify its group; add the file that plprove group ", expected.file,
                   " -o FILE writes");
    return implies_group(group, expected.group) ? "" : "the group is certified to be " + group;
}

Judgement judge(const Findings& findings, const ExpectedModel& expected) {
    Judgement judgement{.statement = in_words(Expectation{expected})};
    const auto models = models_of(findings);
    const auto found = models.find(expected.text);
    if (found == models.end()) {
        judgement.statement += say(": no file is about this model; add what plprove model ",
                                   expected.file, " -o FILE writes");
        return judgement;
    }
    const std::string gap = missing(found->second, expected);
    judgement.verified = gap.empty();
    judgement.files = found->second.files;
    if (!gap.empty()) judgement.statement += ": " + gap;
    judgement.why.push_back(in_words(found->second) + ": proofs/models.md");
    if (const std::string group = found->second.group(); !group.empty())
        judgement.why.push_back(say("its group is ", group, ", by fibres: proofs/fibres.md"));
    return judgement;
}
} // namespace checker
