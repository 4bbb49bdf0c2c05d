#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace felt {

/// A prepared SQL statement. Columns count from 0, parameters from 1.
class Statement {
 public:
  Statement() noexcept = default;
  /// Prepares a statement on a connection that the caller owns. The connection must outlive the
  /// statement.
  static Result<Statement> of(sqlite3* db, const char* sql);
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&& other) noexcept;
  ~Statement();

  void bind(int parameter, std::int64_t value) const noexcept;
  void bind(int parameter, double value) const noexcept;
  /// Binds a text. The text must stay valid until step(), and so must the bytes of bind_blob().
  void bind_text(int parameter, std::string_view text) const noexcept;
  void bind_blob(int parameter, std::string_view bytes) const noexcept;
  void bind_null(int parameter) const noexcept;
  /// Binds the value of a column of another statement. That statement's row must stay valid until
  /// step().
  void bind_column(int parameter, const Statement& from, int column) const noexcept;

  /// Moves to the next row. Returns false at the end. Fails with SQLite's message.
  Result<bool> step() const;
  /// Resets the statement, so that it can be run again with other values.
  void reset() const noexcept;

  [[nodiscard]] int columns() const noexcept;
  [[nodiscard]] bool is_integer(int column) const noexcept;
  [[nodiscard]] bool is_real(int column) const noexcept;
  [[nodiscard]] bool is_text(int column) const noexcept;
  [[nodiscard]] bool is_blob(int column) const noexcept;
  [[nodiscard]] bool is_null(int column) const noexcept;
  [[nodiscard]] std::int64_t integer(int column) const noexcept;
  [[nodiscard]] double real(int column) const noexcept;
  /// Return the value of a column. Valid until the next step().
  [[nodiscard]] std::string_view text(int column) const noexcept;
  [[nodiscard]] std::string_view blob(int column) const noexcept;

 private:
  friend class Database;
  sqlite3_stmt* statement_ = nullptr;
};

/// A database in memory. SQLite gets bytes instead of a file, so that no journal, lock or other
/// file can appear beside a user's drawing. Not thread-safe.
class Database {
 public:
  /// Creates an empty database.
  static Result<Database> create();
  /// Opens the bytes of a file for reading only. The bytes must outlive the database and not
  /// change. They are not trusted, so SQLite runs in defensive mode, without a trusted schema and
  /// with low limits. Only SELECT from plain columns is allowed; functions, views, triggers,
  /// modules, attachments and pragmas are refused.
  static Result<Database> open(std::string_view bytes);

  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;
  ~Database();

  /// Runs SQLite's own check of all pages. Check the schema first (read_schema), because a table
  /// definition may make SQLite do more than read.
  [[nodiscard]] Result<void> check_pages() const;

  Result<void> run(const char* sql);
  [[nodiscard]] Result<Statement> prepare(const char* sql) const;
  /// Returns the whole database as the bytes of a file.
  [[nodiscard]] Result<std::string> bytes() const;

 private:
  Database() noexcept = default;
  Result<void> harden();
  [[nodiscard]] tl::unexpected<Error> error() const;

  sqlite3* db_ = nullptr;
};

}  // namespace felt
