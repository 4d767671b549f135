// The folder of a sweep:
//
//     lock                    locked by the sweep at work in the folder, if any
//     seed-0/002/2394.plc     what came of a class (sweep_result.h), at most 1000 classes a folder
//     focal-seed-0/000/7.plc  ... or of the seventh problem of a family
//     degrees.csv, focal.csv  what collect.h makes of them, and more
//
// Files appear whole or not at all, and no file speaks of another one: a sweep that is killed loses
// the classes that it was working on and nothing else.
#pragma once

#include "prover/degree_sweep/subject.h"
#include "prover/degree_sweep/sweep_result.h"

namespace plprove {

/// Holds DIR/lock for as long as it lives, or the process.
class FolderLock {
public:
    /// Makes the folder if there is none. Throws std::runtime_error if another process holds the
    /// lock, std::system_error if the file cannot be made.
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    int descriptor_ = -1;
};

/// The results of the runs over a subject with one seed. Safe to use by several threads at a time.
class SweepFolder {
public:
    SweepFolder(std::filesystem::path folder, SweepSubject subject, std::uint64_t seed);

    const std::filesystem::path& path() const { return folder_; }
    const SweepSubject& subject() const { return subject_; }
    std::filesystem::path file_of(std::size_t number) const;

    /// Throws BadInput if something stands where the file of an item belongs that is no file, as
    /// a pipe or a folder.
    void require_place(std::size_t number) const;

    /// What is on file for the item, without the certificate's text unless `whole`; nothing where
    /// there is none that can be used.
    std::optional<SweepResult> read(std::size_t number, bool whole) const;

    /// Puts on file what is known of the item with this result. Throws std::system_error.
    void save(SweepResult result) const;

    /// The numbers of items that have a file, ascending. What stands elsewhere is no such file.
    std::vector<std::size_t> numbers() const;

private:
    std::filesystem::path folder_;
    SweepSubject subject_;
    std::filesystem::path results_;
    std::uint64_t seed_;
};

} // namespace plprove
