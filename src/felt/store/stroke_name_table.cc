#include "felt/store/stroke_name_table.h"

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "felt/base/utf8.h"
#include "felt/io/limits.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_tables.h"

namespace felt {
namespace {

std::int64_t name_checksum(std::int64_t stroke, std::string_view name) {
  std::string bytes;
  ByteWriter out(bytes);
  out.u64(static_cast<std::uint64_t>(stroke));
  out.text(name);
  return static_cast<std::int64_t>(crc32c(bytes));
}

/// Returns true if a row has the id of a stroke, a name that files may have, and their checksum.
bool is_intact(std::int64_t stroke, std::string_view name, std::int64_t checksum) {
  return is_id(stroke) && is_stroke_name(name) && checksum == name_checksum(stroke, name);
}

}  // namespace

bool is_stroke_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= limits::kMaxNameBytes &&
         name.find('\0') == std::string_view::npos && is_utf8(name);
}

Result<void> write_stroke_names(Database& database, const Drawing& drawing) {
  const StrokeNames names = used_names(drawing);
  if (names.empty()) return {};
  if (auto ok = database.run(std::string(kStrokeNameTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO stroke_name VALUES(?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  for (const auto& [stroke, name] : names) {
    if (!is_stroke_name(name)) return invalid_data("a stroke has an invalid name");
    const auto number = static_cast<std::int64_t>(stroke.value);
    row->bind(1, ++id);
    row->bind(2, number);
    row->bind_text(3, name);
    row->bind(4, name_checksum(number, name));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> read_stroke_names(const Database& database, Drawing& drawing) {
  const auto row = database.prepare("SELECT stroke, name, checksum FROM stroke_name");
  if (!row) return tl::unexpected(row.error());
  StrokeNames names;
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (!row->is_integer(0) || !row->is_text(1) || !row->is_integer(2) ||
        !is_intact(row->integer(0), row->text(1), row->integer(2))) {
      return invalid_data("the name of a stroke is damaged");
    }
    const StrokeId id{static_cast<std::uint64_t>(row->integer(0))};
    if (drawing.document.find(id)) names.try_emplace(id, row->text(1));
  }
  if (!names.empty()) drawing.names = std::make_shared<const StrokeNames>(std::move(names));
  return {};
}

bool salvage_stroke_name(const ScannedRow& row, StrokeNames& names) {
  const auto& v = row.values;
  if (v.size() != 4) return false;
  const auto* const stroke = std::get_if<std::int64_t>(&v[1]);
  const auto* const name = std::get_if<ScannedRow::Bytes>(&v[2]);
  const auto* const checksum = std::get_if<std::int64_t>(&v[3]);
  if (!stroke || !name || !name->is_text || !checksum) return false;
  if (!is_intact(*stroke, name->value, *checksum)) return false;
  names.try_emplace(StrokeId{static_cast<std::uint64_t>(*stroke)}, name->value);
  return true;
}

}  // namespace felt
