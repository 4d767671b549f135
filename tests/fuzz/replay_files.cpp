// Feeds files, or all files of folders, to a fuzzing harness, without a fuzzer: known inputs stay
// harmless, with any compiler.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void feed(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

} // namespace

int main(int count, char** values) {
    std::size_t fed = 0;
    for (int i = 1; i < count; ++i) {
        const std::filesystem::path path = values[i];
        if (!std::filesystem::is_directory(path)) {
            feed(path);
            ++fed;
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            feed(entry.path());
            ++fed;
        }
    }
    std::cout << fed << " files are harmless\n";
    return fed > 0 ? 0 : 1;
}
