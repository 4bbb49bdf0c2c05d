#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace felt {

/// A statement in work. Columns count from 0, parameters from 1.
class Statement {
 public:
  Statement() noexcept = default;
  /// Of a connection that somebody else owns and that outlives it.
  static Result<Statement> of(sqlite3* db, const char* sql);
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&& other) noexcept;
  ~Statement();

  void bind(int parameter, std::int64_t value) const noexcept;
  void bind(int parameter, double value) const noexcept;
  /// The text must live until the step.
  void bind_text(int parameter, std::string_view text) const noexcept;
  void bind_blob(int parameter, std::string_view bytes) const noexcept;
  void bind_null(int parameter) const noexcept;
  /// What stands in a column of another statement, whose row must stay until the step.
  void bind_column(int parameter, const Statement& from, int column) const noexcept;

  /// The next row: true; the end: false. Error: as SQLite says it.
  Result<bool> step() const;
  /// For the next values.
  void reset() const noexcept;

  [[nodiscard]] int columns() const noexcept;
  [[nodiscard]] bool is_integer(int column) const noexcept;
  [[nodiscard]] bool is_real(int column) const noexcept;
  [[nodiscard]] bool is_text(int column) const noexcept;
  [[nodiscard]] bool is_blob(int column) const noexcept;
  [[nodiscard]] bool is_null(int column) const noexcept;
  [[nodiscard]] std::int64_t integer(int column) const noexcept;
  [[nodiscard]] double real(int column) const noexcept;
  /// Valid until the next step.
  [[nodiscard]] std::string_view text(int column) const noexcept;
  [[nodiscard]] std::string_view blob(int column) const noexcept;

 private:
  friend class Database;
  sqlite3_stmt* statement_ = nullptr;
};

/// A database in memory: SQLite sees bytes and never a file, so that no journal, lock or side file
/// can ever appear beside a person's drawing. One thread.
class Database {
 public:
  /// An empty one.
  static Result<Database> create();
  /// Of the bytes of a file, which must outlive it and stay unchanged; for reading only. The bytes
  /// are not trusted: defensive mode, no trusted schema, low limits, and nothing but selecting from
  /// plain columns is allowed: no function, view, trigger, module, attachment or pragma.
  static Result<Database> open(std::string_view bytes);

  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;
  ~Database();

  /// SQLite's own check of all pages. Look at the schema first: a table may ask for more than a
  /// look.
  [[nodiscard]] Result<void> check_pages() const;

  Result<void> run(const char* sql);
  [[nodiscard]] Result<Statement> prepare(const char* sql) const;
  /// The whole database as the bytes of a file.
  [[nodiscard]] Result<std::string> bytes() const;

 private:
  Database() noexcept = default;
  Result<void> harden();
  [[nodiscard]] tl::unexpected<Error> error() const;

  sqlite3* db_ = nullptr;
};

}  // namespace felt
