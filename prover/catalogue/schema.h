// The tables and views of the SQLite catalogue, as SQL and in words.
#pragma once

#include <span>
#include <string>

namespace plprove {

/// A table or view: its columns with their meaning and, of a view, the query.
struct Relation {
    struct Member {
        const char* name;
        const char* type; ///< declared type and constraints; empty in a view
        const char* meaning;
    };
    const char* name;
    const char* meaning;
    std::span<const Member> members;
    const char* rest; ///< of a table what follows its columns, of a view its SELECT
};

/// The tables, `classes` first, in the order in which they are to be created. The members of
/// `classes` are the columns of the catalogue (columns.h).
std::span<const Relation> tables();

std::span<const Relation> views();

/// CREATE TABLE, with the meanings as comments, which SQLite keeps.
std::string create_table(const Relation& table);

std::string create_view(const Relation& view);

/// The statements that create the indexes of `classes`.
std::span<const char* const> indexes();

} // namespace plprove
