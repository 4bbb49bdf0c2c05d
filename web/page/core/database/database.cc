// The full module has this in place of felt/store/database.cc: SQLite is in a module of its own,
// with a memory of its own, which is asked for whole rows (calls.h).

#include "felt/store/database.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/store/byte_writer.h"
#include "web/page/core/database/calls.h"

/// Calls the module with SQLite. Returns the size of the answer, -1 if there is no such module, or
/// -2 if it has ended, as it does without memory.
extern "C" __attribute__((import_module("env"), import_name("database_call"))) int database_call(
    unsigned what, std::uint32_t handle, const char* bytes, std::size_t size);
/// Copies the answer.
extern "C" __attribute__((import_module("env"), import_name("database_answer"))) void
database_answer(char* to);

namespace felt::page {
namespace {

struct Column {
  ValueType type = ValueType::kNull;
  std::int64_t integer = 0;
  double real = 0.0;
  std::string_view bytes;
};

/// Returns what follows the status in the answer to a call.
Result<std::string> ask(DatabaseCall what, std::uint32_t handle, std::string_view bytes = {}) {
  const int size = database_call(static_cast<unsigned>(what), handle, bytes.data(), bytes.size());
  if (size == -1) return fail(ErrorCode::kIo, "core_felt.js is not loaded");
  if (size <= 0) return fail(ErrorCode::kLimitExceeded, "needs more memory than the browser gives");
  std::string answer(static_cast<std::size_t>(size), '\0');
  database_answer(answer.data());
  const auto status = static_cast<unsigned char>(answer[0]);
  answer.erase(0, 1);
  if (status == 0) return answer;
  return fail(static_cast<ErrorCode>(status - 1), std::move(answer));
}

Result<std::uint32_t> ask_for_handle(DatabaseCall what, std::uint32_t handle,
                                     std::string_view bytes = {}) {
  return ask(what, handle, bytes).map([](const std::string& answer) {
    return ByteReader(answer).u32();
  });
}

Column read_column(ByteReader& from) {
  Column column;
  column.type = static_cast<ValueType>(from.u8());
  if (column.type == ValueType::kNull) return column;
  column.integer = static_cast<std::int64_t>(from.u64());
  column.real = from.f64();
  const bool has_bytes = column.type == ValueType::kText || column.type == ValueType::kBlob;
  if (has_bytes) column.bytes = from.text(from.left());
  return column;
}

}  // namespace
}  // namespace felt::page

using felt::page::DatabaseCall;
using felt::page::ValueType;

struct sqlite3 {
  std::uint32_t handle = 0;
};

struct sqlite3_stmt {
  /// Begins the bytes of the next step.
  explicit sqlite3_stmt(std::uint32_t of) : handle(of) { begin(0); }

  void begin(std::uint8_t resets) { values.assign(1, static_cast<char>(resets)); }
  felt::ByteWriter bind(int parameter, ValueType type) {
    felt::ByteWriter out(values);
    out.u32(static_cast<std::uint32_t>(parameter));
    out.u8(static_cast<std::uint8_t>(type));
    return out;
  }
  [[nodiscard]] felt::page::Column at(int column) const {
    const auto i = static_cast<std::size_t>(column);
    return i < row.size() ? row[i] : felt::page::Column{};
  }

  std::uint32_t handle;
  std::string values;  // of the next step
  std::string answer;  // the row refers to it
  std::vector<felt::page::Column> row;
};

namespace felt {

Statement::Statement(Statement&& other) noexcept
    : statement_(std::exchange(other.statement_, nullptr)) {}

Statement& Statement::operator=(Statement&& other) noexcept {
  std::swap(statement_, other.statement_);
  return *this;
}

Statement::~Statement() {
  if (!statement_) return;
  static_cast<void>(page::ask(DatabaseCall::kFinalize, statement_->handle));
  delete statement_;
}

void Statement::bind(int parameter, std::int64_t value) const noexcept {
  statement_->bind(parameter, ValueType::kInteger).u64(static_cast<std::uint64_t>(value));
}

void Statement::bind(int parameter, double value) const noexcept {
  statement_->bind(parameter, ValueType::kReal).f64(value);
}

void Statement::bind_text(int parameter, std::string_view text) const noexcept {
  statement_->bind(parameter, ValueType::kText).text(text);
}

void Statement::bind_blob(int parameter, std::string_view bytes) const noexcept {
  // As in SQLite, bytes without an address are null.
  if (!bytes.data()) return bind_null(parameter);
  statement_->bind(parameter, ValueType::kBlob).text(bytes);
}

void Statement::bind_null(int parameter) const noexcept {
  static_cast<void>(statement_->bind(parameter, ValueType::kNull));
}

void Statement::bind_column(int parameter, const Statement& from, int column) const noexcept {
  const page::Column value = from.statement_->at(column);
  ByteWriter out = statement_->bind(parameter, value.type);
  if (value.type == ValueType::kInteger) return out.u64(static_cast<std::uint64_t>(value.integer));
  if (value.type == ValueType::kReal) return out.f64(value.real);
  if (value.type != ValueType::kNull) out.text(value.bytes);
}

Result<bool> Statement::step() const {
  statement_->row.clear();
  Result<std::string> answer =
      page::ask(DatabaseCall::kStep, statement_->handle, statement_->values);
  statement_->begin(0);
  if (!answer) return tl::unexpected(answer.error());
  statement_->answer = *std::move(answer);
  ByteReader from(statement_->answer);
  if (from.u8() == 0) return false;
  for (std::uint32_t left = from.u32(); left > 0 && from.ok(); --left) {
    statement_->row.push_back(page::read_column(from));
  }
  return true;
}

void Statement::reset() const noexcept {
  statement_->row.clear();
  statement_->begin(1);
}

int Statement::columns() const noexcept {
  return static_cast<int>(statement_->row.size());
}

bool Statement::is_integer(int column) const noexcept {
  return statement_->at(column).type == ValueType::kInteger;
}

bool Statement::is_real(int column) const noexcept {
  return statement_->at(column).type == ValueType::kReal;
}

bool Statement::is_text(int column) const noexcept {
  return statement_->at(column).type == ValueType::kText;
}

bool Statement::is_blob(int column) const noexcept {
  return statement_->at(column).type == ValueType::kBlob;
}

bool Statement::is_null(int column) const noexcept {
  return statement_->at(column).type == ValueType::kNull;
}

std::int64_t Statement::integer(int column) const noexcept {
  return statement_->at(column).integer;
}

double Statement::real(int column) const noexcept {
  return statement_->at(column).real;
}

std::string_view Statement::text(int column) const noexcept {
  return statement_->at(column).bytes;
}

std::string_view Statement::blob(int column) const noexcept {
  return statement_->at(column).bytes;
}

Database::Database(Database&& other) noexcept : db_(std::exchange(other.db_, nullptr)) {}

Database& Database::operator=(Database&& other) noexcept {
  std::swap(db_, other.db_);
  return *this;
}

Database::~Database() {
  if (!db_) return;
  static_cast<void>(page::ask(DatabaseCall::kClose, db_->handle));
  delete db_;
}

Result<Database> Database::create() {
  const Result<std::uint32_t> handle = page::ask_for_handle(DatabaseCall::kCreate, 0);
  if (!handle) return tl::unexpected(handle.error());
  Database database;
  database.db_ = new sqlite3{*handle};
  return database;
}

Result<Database> Database::open(std::string_view bytes) {
  const Result<std::uint32_t> handle = page::ask_for_handle(DatabaseCall::kOpen, 0, bytes);
  if (!handle) return tl::unexpected(handle.error());
  Database database;
  database.db_ = new sqlite3{*handle};
  return database;
}

Result<void> Database::check_pages() const {
  return page::ask(DatabaseCall::kCheckPages, db_->handle).map([](const std::string&) {});
}

Result<void> Database::run(const char* sql) {
  return page::ask(DatabaseCall::kRun, db_->handle, sql).map([](const std::string&) {});
}

Result<Statement> Database::prepare(const char* sql) const {
  const Result<std::uint32_t> handle =
      page::ask_for_handle(DatabaseCall::kPrepare, db_->handle, sql);
  if (!handle) return tl::unexpected(handle.error());
  Statement statement;
  statement.statement_ = new sqlite3_stmt(*handle);
  return statement;
}

Result<std::string> Database::bytes() const {
  return page::ask(DatabaseCall::kBytes, db_->handle);
}

}  // namespace felt
