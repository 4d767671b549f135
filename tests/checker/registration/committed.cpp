#include "tests/checker/registration/committed.h"

#include "checker/conclusion/registrations.h"
#include "checker/degrees/constraint_class.h"
#include "tests/support/file.h"

#include <filesystem>

using namespace checker;

namespace registrations {
const std::vector<ReplayedFile>& committed_files() {
    static const std::vector<ReplayedFile> files = [] {
        std::vector<ReplayedFile> all;
        for (const auto& entry :
             std::filesystem::directory_iterator(CERTS_DIR "/models/registrations")) {
            const std::string bytes = read(entry.path().string());
            all.push_back(replay(all_classes(), entry.path().filename().string(), bytes));
        }
        std::ranges::sort(all, {}, &ReplayedFile::name);
        return all;
    }();
    return files;
}

static const std::vector<bool>& minimal_classes() {
    static const std::vector<bool> minimal = [] {
        std::vector<bool> found;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
            found.push_back(is_minimal_class(n));
        return found;
    }();
    return minimal;
}

const RegistrationBounds& committed() {
    static const RegistrationBounds bounds = registration_bounds(
        find(all_classes(), committed_files()), all_classes(), minimal_classes());
    return bounds;
}

DegreeTable table_of(const RegistrationBounds& upper, const std::vector<LowerBound>& lower) {
    return bounds_by_files(all_classes(), minimal_classes(), lower, upper);
}

std::size_t bound_of(const DegreeTable& table, std::size_t number) {
    const auto found = table.find(constraint_class(all_classes().representatives[number]));
    if (found == table.end() || !found->second.at_most) return 0;
    return found->second.at_most->solutions;
}

std::size_t bound_of(const DegreeTable& table, std::string_view problem) {
    return bound_of(table, class_of(problem));
}
} // namespace registrations
