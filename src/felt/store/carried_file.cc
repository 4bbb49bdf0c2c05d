#include "felt/store/carried_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include "felt/store/byte_writer.h"
#include "felt/store/felt_extras.h"

namespace felt {
namespace {

constexpr const char* kCannot = "data that a newer Feltline stored in it cannot be copied";

int index_of(const FeltTable& table, std::string_view column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  return found == table.columns.end() ? -1 : static_cast<int>(found - table.columns.begin());
}

/// Returns true if the column names nothing, or something that exists according to `is_there`.
template <class IsThere>
bool names_present(const Statement& row, int column, IsThere is_there) {
  return column < 0 || row.is_null(column) ||
         (row.is_integer(column) && is_there(static_cast<std::uint64_t>(row.integer(column))));
}

void append_value(ByteWriter& out, const Statement& row, int column) {
  if (row.is_integer(column)) {
    out.u8(1);
    return out.u64(static_cast<std::uint64_t>(row.integer(column)));
  }
  if (row.is_real(column)) {
    out.u8(2);
    return out.f64(row.real(column));
  }
  const bool is_text = row.is_text(column), is_blob = row.is_blob(column);
  out.u8(is_text ? 3 : is_blob ? 4 : 5);
  out.text(is_text ? row.text(column) : is_blob ? row.blob(column) : "");
}

/// Appends every value of every row, so that equal rows give equal bytes.
Result<void> append_rows(std::string& bytes, const Database& db, const std::string& select) {
  const auto row = db.prepare(select.c_str());
  if (!row) return tl::unexpected(row.error());
  ByteWriter out(bytes);
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    for (int i = 0; i < row->columns(); ++i) append_value(out, *row, i);
  }
}

/// Returns everything that a file carries as bytes, for comparison.
Result<std::string> carried_bytes(const FeltExtras& extras) {
  std::string bytes;
  const Result<CarriedFile> file = CarriedFile::open(extras);
  if (!file) return tl::unexpected(file.error());
  if (!file->database()) return bytes;
  const FeltSchema& schema = *file->schema();
  const auto add = [&](const FeltTable& table, const std::string& columns) {
    bytes += table.sql;
    return append_rows(bytes, *file->database(),
                       "SELECT " + columns + " FROM " + table.name + " NOT INDEXED");
  };
  for (const FeltTable* table : {&schema.drawing, &schema.layer, &schema.stroke}) {
    const std::string beyond = table->beyond(own_table(table->name).columns);
    if (beyond.empty()) continue;
    if (auto ok = add(*table, "id" + beyond); !ok) return tl::unexpected(ok.error());
  }
  for (const auto* tables : {&schema.recordings, &schema.foreign}) {
    for (const FeltTable& table : *tables) {
      if (auto ok = add(table, "*"); !ok) return tl::unexpected(ok.error());
    }
  }
  return bytes;
}

}  // namespace

const FeltExtras& felt_extras(const Drawing& drawing) {
  static const FeltExtras kNone;
  // FeltExtras are the only extras. The page for browsers is compiled without RTTI.
  const auto* extras = static_cast<const FeltExtras*>(drawing.extras.get());
  return extras ? *extras : kNone;
}

bool FeltExtras::equals(const DrawingExtras& other) const {
  const auto* b = static_cast<const FeltExtras*>(&other);
  const auto same = [](const auto& x, const auto& y) { return x == y || *x == *y; };
  if (!std::equal(added.begin(), added.end(), b->added.begin(), b->added.end(), same)) {
    return false;
  }
  if (file == b->file) return true;
  const Result<std::string> x = carried_bytes(*this), y = carried_bytes(*b);
  return x && y && *x == *y;
}

Result<CarriedFile> CarriedFile::open(const FeltExtras& extras) {
  CarriedFile file;
  if (!extras.file) return file;
  Result<Database> database = Database::open(*extras.file);
  if (!database) return tl::unexpected(with_context(database.error(), kCannot));
  Result<FeltSchema> schema = read_schema(*database);
  if (!schema) return tl::unexpected(with_context(schema.error(), kCannot));
  file.database_ = *std::move(database);
  file.schema_ = *std::move(schema);
  return file;
}

Result<void> CarriedFile::copy_to(Database& to, const Document& document) const {
  if (!database_) return {};
  Result<void> done = copy_columns(to, schema_.drawing)
                          .and_then([&] { return copy_columns(to, schema_.layer); })
                          .and_then([&] { return copy_columns(to, schema_.stroke); });
  for (const FeltTable& table : schema_.foreign) {
    if (done) done = copy_table(to, table, document);
  }
  if (!done) return tl::unexpected(with_context(done.error(), kCannot));
  return done;
}

Result<void> CarriedFile::copy_columns(Database& to, const FeltTable& table) const {
  const std::size_t ours = own_table(table.name).columns, all = table.columns.size();
  if (all == ours) return {};
  std::string set;
  for (std::size_t i = ours; i < all; ++i) {
    set += (i > ours ? ", \"" : "\"") + table.columns[i] + "\"=?";
  }
  const auto read = database_->prepare(
      ("SELECT id" + table.beyond(ours) + " FROM " + table.name + " NOT INDEXED").c_str());
  if (!read) return tl::unexpected(read.error());
  const auto write = to.prepare(("UPDATE " + table.name + " SET " + set + " WHERE id=?").c_str());
  if (!write) return tl::unexpected(write.error());
  for (;;) {
    const Result<bool> more = read->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    const int count = static_cast<int>(all - ours);
    for (int i = 1; i <= count; ++i) write->bind_column(i, *read, i);
    write->bind(count + 1, read->integer(0));
    if (auto done = write->step(); !done) return tl::unexpected(done.error());
    write->reset();
  }
}

Result<void> CarriedFile::copy_table(Database& to, const FeltTable& table,
                                     const Document& document) const {
  if (auto ok = to.run(table.sql.c_str()); !ok) return ok;
  const int stroke = index_of(table, "stroke"), layer = index_of(table, "layer");
  return copy_rows(*database_, to, table, [&](const Statement& row) {
    return names_present(row, stroke, [&](std::uint64_t id) { return document.find({id}); }) &&
           names_present(row, layer, [&](std::uint64_t id) { return document.layer({id}); });
  });
}

}  // namespace felt
