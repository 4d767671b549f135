#include "prover/bundle/tarball.h"

#include <archive.h>
#include <archive_entry.h>
#include <ctime>
#include <memory>
#include <new>
#include <stdexcept>

namespace plprove {

namespace {

constexpr std::time_t date_of_all = 1767225600; // 2026-01-01, as good as any

using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

void check(int status, const Writer& writer) {
    if (status == ARCHIVE_OK) return;
    const char* reason = archive_error_string(writer.get());
    throw std::runtime_error(std::string("cannot make the tar file: ") +
                             (reason ? reason : "no memory"));
}

la_ssize_t append(archive*, void* bytes, const void* buffer, std::size_t size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(buffer), size);
    return static_cast<la_ssize_t>(size);
}

void add(const Writer& writer, const std::string& path, const std::string& content) {
    const Entry entry(archive_entry_new(), &archive_entry_free);
    if (!entry) throw std::bad_alloc();
    archive_entry_set_pathname(entry.get(), path.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), date_of_all, 0);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
    check(archive_write_header(writer.get(), entry.get()), writer);
    if (archive_write_data(writer.get(), content.data(), content.size()) !=
        static_cast<la_ssize_t>(content.size()))
        check(ARCHIVE_FATAL, writer);
}

} // namespace

std::string tar_zst(const Files& files, const std::string& root) {
    std::string bytes;
    const Writer writer(archive_write_new(), &archive_write_free);
    check(archive_write_set_format_ustar(writer.get()), writer);
    check(archive_write_add_filter_zstd(writer.get()), writer);
    check(archive_write_set_bytes_in_last_block(writer.get(), 1), writer); // zstd takes no padding
    check(archive_write_open2(writer.get(), &bytes, nullptr, append, nullptr, nullptr), writer);
    for (const auto& [path, content] : files)
        add(writer, root + '/' + path, content);
    check(archive_write_close(writer.get()), writer);
    return bytes;
}

} // namespace plprove
