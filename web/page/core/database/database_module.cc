// The module with SQLite: Database and Statement of felt/store, behind the calls of calls.h. It has
// a memory of its own, which is freed when the browser drops the module.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/store/byte_writer.h"
#include "felt/store/database.h"
#include "web/page/core/database/calls.h"

#define FELT_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace felt {

/// A failed check ends the module.
void detail::check_failed(const char* /*condition*/, const char* /*file*/, int /*line*/) noexcept {
  __builtin_trap();
}

namespace page {
namespace {

struct OpenDatabase {
  std::unique_ptr<const std::string> file;  // null if the database is new
  Database database;
};
struct OpenStatement {
  Statement statement;
  std::map<int, std::string> values;  // the statement refers to them
};

std::string input, answer;

std::uint32_t handle_of(void* object) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object));
}
template <class Object>
Object& object_of(std::uint32_t handle) {
  return *reinterpret_cast<Object*>(static_cast<std::uintptr_t>(handle));
}

void begin_answer() {
  answer.assign(1, '\0');
}
void refuse(const Error& error) {
  answer.assign(1, static_cast<char>(1 + static_cast<int>(error.code)));
  answer += error.message;
}
void answer_with(const Result<void>& done) {
  done ? begin_answer() : refuse(done.error());
}
void answer_with_handle(void* object) {
  begin_answer();
  ByteWriter(answer).u32(handle_of(object));
}

void create() {
  Result<Database> made = Database::create();
  if (!made) return refuse(made.error());
  answer_with_handle(new OpenDatabase{nullptr, *std::move(made)});
}

void open() {
  auto file = std::make_unique<const std::string>(std::exchange(input, {}));
  Result<Database> opened = Database::open(*file);
  if (!opened) return refuse(opened.error());
  answer_with_handle(new OpenDatabase{std::move(file), *std::move(opened)});
}

void prepare(const Database& database) {
  Result<Statement> prepared = database.prepare(input.c_str());
  if (!prepared) return refuse(prepared.error());
  answer_with_handle(new OpenStatement{*std::move(prepared), {}});
}

/// Binds the next value of the input.
void bind(OpenStatement& to, ByteReader& from) {
  const int parameter = static_cast<int>(from.u32());
  const auto type = static_cast<ValueType>(from.u8());
  if (type == ValueType::kNull) return to.statement.bind_null(parameter);
  if (type == ValueType::kReal) return to.statement.bind(parameter, from.f64());
  if (type == ValueType::kInteger) {
    return to.statement.bind(parameter, static_cast<std::int64_t>(from.u64()));
  }
  std::string& kept = to.values[parameter];
  kept = from.text(from.left());
  if (type == ValueType::kText) return to.statement.bind_text(parameter, kept);
  to.statement.bind_blob(parameter, kept);
}

void append_column(const Statement& row, int column) {
  ByteWriter out(answer);
  const auto begin = [&](ValueType type) {
    out.u8(static_cast<std::uint8_t>(type));
    out.u64(static_cast<std::uint64_t>(row.integer(column)));
    out.f64(row.real(column));
  };
  if (row.is_null(column)) return out.u8(static_cast<std::uint8_t>(ValueType::kNull));
  if (row.is_integer(column)) return begin(ValueType::kInteger);
  if (row.is_real(column)) return begin(ValueType::kReal);
  const bool is_text = row.is_text(column);
  begin(is_text ? ValueType::kText : ValueType::kBlob);
  out.text(is_text ? row.text(column) : row.blob(column));
}

void step(OpenStatement& open) {
  ByteReader from(input);
  if (from.u8() != 0) open.statement.reset();
  while (from.left() > 0 && from.ok()) bind(open, from);
  const Result<bool> has_row = open.statement.step();
  if (!has_row) return refuse(has_row.error());
  begin_answer();
  ByteWriter out(answer);
  out.u8(*has_row ? 1 : 0);
  if (!*has_row) return;
  const int columns = open.statement.columns();
  out.u32(static_cast<std::uint32_t>(columns));
  for (int i = 0; i < columns; ++i) append_column(open.statement, i);
}

void give_bytes(const Database& database) {
  Result<std::string> bytes = database.bytes();
  if (!bytes) return refuse(bytes.error());
  begin_answer();
  answer += *bytes;
}

void call(DatabaseCall what, std::uint32_t handle) {
  switch (what) {
    case DatabaseCall::kCreate:
      return create();
    case DatabaseCall::kOpen:
      return open();
    case DatabaseCall::kClose:
      delete &object_of<OpenDatabase>(handle);
      return begin_answer();
    case DatabaseCall::kCheckPages:
      return answer_with(object_of<OpenDatabase>(handle).database.check_pages());
    case DatabaseCall::kRun:
      return answer_with(object_of<OpenDatabase>(handle).database.run(input.c_str()));
    case DatabaseCall::kPrepare:
      return prepare(object_of<OpenDatabase>(handle).database);
    case DatabaseCall::kFinalize:
      delete &object_of<OpenStatement>(handle);
      return begin_answer();
    case DatabaseCall::kStep:
      return step(object_of<OpenStatement>(handle));
    case DatabaseCall::kBytes:
      return give_bytes(object_of<OpenDatabase>(handle).database);
  }
}

}  // namespace

/// Returns where JavaScript writes the bytes of the next call.
FELT_EXPORT(database_input) char* database_input(std::size_t size) {
  input.resize(size);
  return input.data();
}
/// Returns the size of the answer, which is at database_answer().
FELT_EXPORT(database_call) std::size_t database_call(unsigned what, std::uint32_t handle) {
  call(static_cast<DatabaseCall>(what), handle);
  return answer.size();
}
FELT_EXPORT(database_answer) const char* database_answer() {
  return answer.data();
}

}  // namespace page
}  // namespace felt
