#include "checker/conclusion/registrations.h"

#include "checker/conclusion/models.h"
#include "checker/model/program.h"
#include "checker/registration/model.h"

#include <set>

namespace checker {
static std::string text_of(const Registration& type) {
    return lines_of_model(model_of(type));
}

RegistrationBounds registration_bounds(const Findings& findings, const Classification& classes,
                                       const std::vector<bool>& minimal) {
    const auto models = models_of(findings);
    if (models.empty()) return {};
    std::set<Registration> types{relative_pose};
    for (std::size_t n = 0; n < minimal.size(); ++n)
        for (const Views pair : view_pairs)
            if (minimal[n] && shared_points(classes.representatives[n], pair) == 5)
                types.insert(registration(classes.representatives[n], pair));
    RegistrationBounds bounds;
    for (const Registration& type : types) {
        const auto model = models.find(text_of(type));
        if (model != models.end() && model->second.at_most)
            bounds.emplace(type, *model->second.at_most);
    }
    return bounds;
}

std::vector<std::size_t> files_on(const Findings& findings, const Registration& type) {
    const std::array texts{text_of(relative_pose), text_of(type)};
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto* model = std::get_if<ModelFile>(&findings.files[i].content);
        if (model && model->at_most && findings.counts(i) &&
            std::ranges::count(texts, model->text) > 0)
            files.push_back(i);
    }
    return files;
}
} // namespace checker
