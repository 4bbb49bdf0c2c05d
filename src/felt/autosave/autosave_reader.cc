#include "felt/autosave/autosave_reader.h"

#include <sqlite3.h>

#include <optional>
#include <utility>

#include "felt/autosave/autosave_rows.h"

namespace felt {
namespace {

constexpr std::int64_t kMaxMissing = 4096;  // more than the rows of one damaged page

tl::unexpected<Error> no_database(sqlite3* db) {
  return fail(ErrorCode::kInvalidData, db ? sqlite3_errmsg(db) : "not enough memory");
}

/// Returns the first key, from `next` on, that a separate query can find.
std::optional<std::int64_t> probe(sqlite3* db, const std::string& sql, std::int64_t next) {
  const Result<Statement> row = Statement::of(db, sql.c_str());
  if (!row) return {};
  for (std::int64_t key = next; key < next + kMaxMissing; ++key) {
    row->bind(1, key);
    const Result<bool> found = row->step();
    row->reset();
    if (found && *found) return key;
  }
  return {};
}

}  // namespace

AutosaveReader::AutosaveReader(AutosaveReader&& other) noexcept
    : db_(std::exchange(other.db_, nullptr)), ran_out_of_memory_(other.ran_out_of_memory_) {}

AutosaveReader& AutosaveReader::operator=(AutosaveReader&& other) noexcept {
  std::swap(db_, other.db_);
  std::swap(ran_out_of_memory_, other.ran_out_of_memory_);
  return *this;
}

AutosaveReader::~AutosaveReader() {
  sqlite3_close(db_);
}

Result<AutosaveReader> AutosaveReader::open(const std::string& path,
                                            std::vector<std::string>& problems) {
  AutosaveReader reader;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE;
  if (sqlite3_open_v2(path.c_str(), &reader.db_, flags, nullptr) != SQLITE_OK) {
    return no_database(reader.db_);
  }
  if (auto ok = reader.check(problems); !ok) return tl::unexpected(ok.error());
  return reader;
}

Result<std::int64_t> AutosaveReader::pragma(const char* sql) const {
  const Result<Statement> row = Statement::of(db_, sql);
  if (!row) return tl::unexpected(row.error());
  const Result<bool> any = row->step();
  if (!any) return tl::unexpected(any.error());
  return row->integer(0);
}

Result<void> AutosaveReader::check(std::vector<std::string>& problems) {
  sqlite3_db_config(db_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  // No other process opens a copy, so no shared memory file is needed.
  constexpr const char* kSetup =
      "PRAGMA locking_mode=EXCLUSIVE; PRAGMA cell_size_check=ON; PRAGMA mmap_size=0; "
      "PRAGMA temp_store=MEMORY";
  if (sqlite3_exec(db_, kSetup, nullptr, nullptr, nullptr) != SQLITE_OK) return no_database(db_);
  const Result<std::int64_t> id = pragma("PRAGMA application_id");
  if (!id) return tl::unexpected(id.error());
  if (*id != std::int64_t{kAutosaveApplicationId}) {
    return fail(ErrorCode::kInvalidData, "is not an autosave");
  }
  const Result<std::int64_t> version = pragma("PRAGMA user_version");
  if (!version) return tl::unexpected(version.error());
  if (*version != std::int64_t{kAutosaveVersion}) {
    return fail(ErrorCode::kUnsupported, "was written by another version of Feltline");
  }
  const Result<Statement> row = Statement::of(db_, "PRAGMA quick_check(5)");
  if (!row) return tl::unexpected(row.error());
  for (;;) {
    const Result<bool> more = row->step();
    look_at_memory();
    if (!more) problems.push_back("the database is damaged: " + more.error().message);
    if (!more || !*more) return {};
    if (row->text(0) != "ok") {
      problems.push_back("the database is damaged: " + std::string(row->text(0)));
    }
  }
}

void AutosaveReader::look_at_memory() const noexcept {
  ran_out_of_memory_ = ran_out_of_memory_ || sqlite3_errcode(db_) == SQLITE_NOMEM;
}

bool AutosaveReader::rows(const std::string& table, const std::string& key,
                          const std::string& columns, std::int64_t first,
                          const std::function<void(const Statement&)>& each) const {
  const std::string what = "SELECT " + key + ", " + columns + " FROM " + table + " WHERE " + key;
  const std::string all = what + " >= ? ORDER BY " + key, one = what + " = ?";
  bool is_whole = true;
  for (std::int64_t next = first;;) {
    const Result<Statement> row = Statement::of(db_, all.c_str());
    look_at_memory();
    if (!row) return false;
    row->bind(1, next);
    for (;;) {
      const Result<bool> more = row->step();
      look_at_memory();
      if (more && !*more) return is_whole;
      if (!more) break;
      next = row->integer(0) + 1;
      each(*row);
      look_at_memory();  // if memory runs out, SQLite returns an empty blob
    }
    is_whole = false;
    const std::optional<std::int64_t> behind = probe(db_, one, next);
    if (!behind) return false;
    next = *behind;
  }
}

}  // namespace felt
