#include "felt/store/database.h"

#include <sqlite3.h>

#include <utility>

#include "felt/store/felt_schema.h"
#include "felt/store/stroke_blob.h"

namespace felt {
namespace {

tl::unexpected<Error> error_of(sqlite3* db) {
  const int code = sqlite3_extended_errcode(db);
  const int kind = code & 0xff;
  const bool is_damaged = kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB;
  return fail(is_damaged              ? ErrorCode::kInvalidData
              : kind == SQLITE_TOOBIG ? ErrorCode::kLimitExceeded
                                      : ErrorCode::kIo,
              sqlite3_errmsg(db));
}

/// Tells SQLite which actions are allowed: only those that statements on an untrusted file need.
int authorize(void*, int action, const char* what, const char*, const char*, const char* within) {
  if (within) return SQLITE_DENY;  // a view or trigger requested the action
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
      return SQLITE_OK;
    case SQLITE_PRAGMA:
      return std::string_view(what) == "quick_check" ? SQLITE_OK : SQLITE_DENY;
    default:
      return SQLITE_DENY;
  }
}

}  // namespace

Result<Statement> Statement::of(sqlite3* db, const char* sql) {
  Statement statement;
  if (sqlite3_prepare_v2(db, sql, -1, &statement.statement_, nullptr) != SQLITE_OK) {
    return error_of(db);
  }
  return statement;
}

Statement::Statement(Statement&& other) noexcept
    : statement_(std::exchange(other.statement_, nullptr)) {}

Statement& Statement::operator=(Statement&& other) noexcept {
  std::swap(statement_, other.statement_);
  return *this;
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

void Statement::bind(int parameter, std::int64_t value) const noexcept {
  sqlite3_bind_int64(statement_, parameter, value);
}

void Statement::bind(int parameter, double value) const noexcept {
  sqlite3_bind_double(statement_, parameter, value);
}

void Statement::bind_text(int parameter, std::string_view text) const noexcept {
  sqlite3_bind_text64(statement_, parameter, text.empty() ? "" : text.data(), text.size(),
                      SQLITE_STATIC, SQLITE_UTF8);
}

void Statement::bind_blob(int parameter, std::string_view bytes) const noexcept {
  sqlite3_bind_blob64(statement_, parameter, bytes.data(), bytes.size(), SQLITE_STATIC);
}

void Statement::bind_null(int parameter) const noexcept {
  sqlite3_bind_null(statement_, parameter);
}

void Statement::bind_column(int parameter, const Statement& from, int column) const noexcept {
  sqlite3_bind_value(statement_, parameter, sqlite3_column_value(from.statement_, column));
}

Result<bool> Statement::step() const {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return error_of(sqlite3_db_handle(statement_));
}

void Statement::reset() const noexcept {
  sqlite3_reset(statement_);
}

int Statement::columns() const noexcept {
  return sqlite3_column_count(statement_);
}

bool Statement::is_integer(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_INTEGER;
}

bool Statement::is_real(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_FLOAT;
}

bool Statement::is_text(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_TEXT;
}

bool Statement::is_blob(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_BLOB;
}

bool Statement::is_null(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const noexcept {
  return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const noexcept {
  return sqlite3_column_double(statement_, column);
}

std::string_view Statement::text(int column) const noexcept {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  const int size = sqlite3_column_bytes(statement_, column);
  return text ? std::string_view(text, static_cast<std::size_t>(size)) : std::string_view();
}

std::string_view Statement::blob(int column) const noexcept {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  const int size = sqlite3_column_bytes(statement_, column);
  return bytes ? std::string_view(bytes, static_cast<std::size_t>(size)) : std::string_view();
}

Database::Database(Database&& other) noexcept : db_(std::exchange(other.db_, nullptr)) {}

Database& Database::operator=(Database&& other) noexcept {
  std::swap(db_, other.db_);
  return *this;
}

Database::~Database() {
  sqlite3_close(db_);
}

tl::unexpected<Error> Database::error() const {
  return error_of(db_);
}

Result<Database> Database::create() {
  Database database;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  if (sqlite3_open_v2(":memory:", &database.db_, flags, nullptr) != SQLITE_OK) {
    return database.error();
  }
  return database;
}

Result<Database> Database::open(std::string_view bytes) {
  Result<Database> database = create();
  if (!database) return database;
  if (auto ok = database->harden(); !ok) return tl::unexpected(ok.error());
  // The interface requires writable bytes; with this flag SQLite does not write to them.
  auto* data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(database->db_, "main", data, size, size, SQLITE_DESERIALIZE_READONLY) !=
      SQLITE_OK) {
    return database->error();
  }
  sqlite3_set_authorizer(database->db_, &authorize, nullptr);
  return database;
}

Result<void> Database::check_pages() const {
  const Result<Statement> check = prepare("PRAGMA quick_check(1)");
  if (!check) return tl::unexpected(check.error());
  const Result<bool> row = check->step();
  if (!row) return tl::unexpected(row.error());
  if (!*row) return fail(ErrorCode::kInvalidData, "no answer");
  const std::string_view answer = check->text(0);
  if (answer == "ok") return {};
  // The answer begins with a heading on a separate line: "*** in database main ***".
  const std::size_t heading = answer.rfind("***\n");
  return fail(ErrorCode::kInvalidData,
              std::string(heading == answer.npos ? answer : answer.substr(heading + 4)));
}

/// Applies what sqlite.org/security.html recommends for untrusted files.
Result<void> Database::harden() {
  sqlite3_db_config(db_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(db_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  constexpr int kTextBytes = 20'000, kColumns = static_cast<int>(kMaxColumns), kOperations = 10'000,
                kDepth = 10;
  sqlite3_limit(db_, SQLITE_LIMIT_LENGTH, static_cast<int>(kMaxStrokeBlobBytes) + 4096);
  sqlite3_limit(db_, SQLITE_LIMIT_SQL_LENGTH, kTextBytes);
  sqlite3_limit(db_, SQLITE_LIMIT_COLUMN, kColumns);
  sqlite3_limit(db_, SQLITE_LIMIT_EXPR_DEPTH, kDepth);
  sqlite3_limit(db_, SQLITE_LIMIT_VDBE_OP, kOperations);
  sqlite3_limit(db_, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_limit(db_, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
  return run("PRAGMA cell_size_check=ON; PRAGMA mmap_size=0; PRAGMA temp_store=MEMORY");
}

Result<void> Database::run(const char* sql) {
  if (sqlite3_exec(db_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) return error();
  return {};
}

Result<Statement> Database::prepare(const char* sql) const {
  Statement statement;
  if (sqlite3_prepare_v2(db_, sql, -1, &statement.statement_, nullptr) != SQLITE_OK) {
    return error();
  }
  return statement;
}

Result<std::string> Database::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> data(
      sqlite3_serialize(db_, "main", &size, 0), &sqlite3_free);
  if (!data) return fail(ErrorCode::kIo, "not enough memory for the file");
  return std::string(reinterpret_cast<const char*>(data.get()), static_cast<std::size_t>(size));
}

}  // namespace felt
