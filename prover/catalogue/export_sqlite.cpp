// The SQLite database, built in memory: one writer, one transaction, and an image that is written
// like any other file.
#include "prover/catalogue/columns.h"
#include "prover/catalogue/export.h"
#include "prover/catalogue/schema.h"
#include "prover/catalogue/spelling.h"
#include "prover/problem/reduction.h"

#include <memory>
#include <sqlite3.h>
#include <stdexcept>

namespace plprove {

namespace {

/// A database in memory.
class Database {
public:
    Database() {
        sqlite3* handle = nullptr;
        const int status = sqlite3_open(":memory:", &handle);
        handle_.reset(handle);
        check(status);
    }

    sqlite3* handle() const { return handle_.get(); }

    void check(int status) const {
        if (status != SQLITE_OK && status != SQLITE_DONE)
            throw std::runtime_error(std::string("SQLite: ") + sqlite3_errmsg(handle()));
    }

    void execute(const std::string& sql) {
        check(sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr));
    }

    /// The bytes of the database file.
    std::string image() const {
        sqlite3_int64 size = 0;
        const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
            sqlite3_serialize(handle(), "main", &size, 0), &sqlite3_free);
        if (!bytes) throw std::runtime_error("SQLite: out of memory");
        return {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
    }

private:
    std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_{nullptr, &sqlite3_close};
};

/// A prepared INSERT into all columns of a table.
class Insert {
public:
    Insert(Database& database, const char* table, std::size_t columns) : database_(database) {
        std::string sql = "INSERT INTO " + std::string(table) + " VALUES (?";
        for (std::size_t i = 1; i < columns; ++i)
            sql += ",?";
        sqlite3_stmt* statement = nullptr;
        database.check(
            sqlite3_prepare_v2(database.handle(), (sql + ")").c_str(), -1, &statement, nullptr));
        statement_.reset(statement);
    }

    template <class... Values>
    void row(const Values&... values) {
        column_ = 0;
        (bind(values), ...);
        finish();
    }

    void row(const Entry& entry) {
        column_ = 0;
        for (const Column& column : columns())
            std::visit([this](const auto& value) { bind(value); }, column.value(entry));
        finish();
    }

private:
    void bind(std::monostate) { database_.check(sqlite3_bind_null(statement_.get(), ++column_)); }
    void bind(int number) {
        database_.check(sqlite3_bind_int(statement_.get(), ++column_, number));
    }
    void bind(std::string_view text) {
        database_.check(sqlite3_bind_text(statement_.get(), ++column_, text.data(),
                                          static_cast<int>(text.size()), SQLITE_TRANSIENT));
    }
    void finish() {
        database_.check(sqlite3_step(statement_.get()));
        database_.check(sqlite3_reset(statement_.get()));
    }

    Database& database_;
    std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement_{nullptr,
                                                                          &sqlite3_finalize};
    int column_ = 0;
};

void insert_features(Database& database) {
    Insert insert(database, "features", 8);
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = standard_features()[i];
        insert.row(static_cast<int>(i), notation(feature), notation(terminal(feature)),
                   feature.has_point ? 1 : 0, feature.has_point ? feature.lines : 0,
                   dimension_in_space(feature), dimension_in_space(feature) + weight(feature),
                   weight(feature));
    }
}

void insert_class_features(Database& database, std::span<const Entry> entries) {
    Insert insert(database, "class_features", 3);
    for (const Entry& entry : entries)
        for (std::size_t i = 0; i < feature_count; ++i)
            if (entry.signature[i] > 0)
                insert.row(static_cast<int>(entry.number), static_cast<int>(i),
                           static_cast<int>(entry.signature[i]));
}

void describe(Insert& insert, std::span<const Relation> relations) {
    for (const Relation& relation : relations) {
        insert.row(relation.name, std::monostate{}, relation.meaning);
        for (const Relation::Member& member : relation.members)
            insert.row(relation.name, member.name, member.meaning);
    }
}

void insert_remarks(Database& database) {
    Insert about(database, "about", 2);
    for (const Remark& remark : remarks())
        about.row(remark.topic, remark.text);
    Insert description(database, "description", 3);
    describe(description, tables());
    describe(description, views());
}

void insert_all(Database& database, std::span<const Entry> entries) {
    Insert classes(database, "classes", columns().size());
    for (const Entry& entry : entries)
        classes.row(entry);
    insert_features(database);
    insert_class_features(database, entries);
    insert_remarks(database);
}

} // namespace

std::string to_sqlite(std::span<const Entry> entries) {
    Database database;
    // "PLPC": what kind of file this is, for file(1); and the version of this schema.
    database.execute("PRAGMA application_id = 1347178563; PRAGMA user_version = 3; BEGIN");
    for (const Relation& table : tables())
        database.execute(create_table(table));
    insert_all(database, entries);
    for (const char* index : indexes())
        database.execute(index);
    for (const Relation& view : views())
        database.execute(create_view(view));
    database.execute("COMMIT");
    return database.image();
}

} // namespace plprove
