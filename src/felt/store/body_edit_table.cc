#include "felt/store/body_edit_table.h"

#include <memory>
#include <utility>
#include <vector>

#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_page.h"
#include "felt/store/felt_tables.h"

namespace felt {
namespace {

constexpr std::uint8_t kBodyEditVersion = 1;
constexpr std::size_t kVec3Bytes = 24;

void write_vec3(ByteWriter& out, const Vec3& p) {
  for (const double number : {p.x, p.y, p.z}) out.f64(number);
}

Vec3 read_vec3(ByteReader& in) {
  const double x = in.f64(), y = in.f64(), z = in.f64();
  return {x, y, z};
}

void write_path(ByteWriter& out, const std::vector<Vec3>& path) {
  out.count(path.size());
  for (const Vec3& p : path) write_vec3(out, p);
}

/// Returns false if there are fewer points than the bytes state.
bool read_path(ByteReader& in, std::vector<Vec3>& path) {
  const std::uint64_t points = in.count();
  if (!in.has(points, kVec3Bytes)) return false;
  for (std::uint64_t i = 0; i < points; ++i) path.push_back(read_vec3(in));
  return true;
}

}  // namespace

Result<void> append_body_edit_blob(std::string& out, const BodyEdit& edit) {
  if (auto ok = check_body_edit(edit); !ok) return ok;
  ByteWriter writer(out);
  writer.u8(kBodyEditVersion);
  write_vec3(writer, edit.view);
  writer.f64(edit.width_mm);
  writer.u32(static_cast<std::uint32_t>(number_of(edit.color)));
  writer.f64(edit.amount);
  write_path(writer, edit.path_mm);
  write_path(writer, edit.profile_mm);
  return {};
}

Result<BodyEditPtr> read_body_edit_blob(std::string_view kind, std::string_view bytes) {
  const std::optional<BodyEditKind> known = body_edit_kind_of(kind);
  if (!known) {
    return fail(ErrorCode::kUnsupported, "has the kind '" + std::string(kind.substr(0, 100)) +
                                             "', which this version of Feltline does not have");
  }
  ByteReader in(bytes);
  if (const std::uint8_t version = in.u8(); version != kBodyEditVersion) {
    return fail(ErrorCode::kUnsupported,
                "has version " + std::to_string(version) + "; this program supports version 1");
  }
  BodyEdit edit;
  edit.kind = *known;
  edit.view = read_vec3(in);
  edit.width_mm = in.f64();
  edit.color = color_of(in.u32());
  edit.amount = in.f64();
  if (!read_path(in, edit.path_mm) || !read_path(in, edit.profile_mm)) {
    return invalid_data("has fewer points than it states");
  }
  if (!in.ok() || in.left() > 0) return invalid_data("does not have the length that it states");
  if (auto ok = check_body_edit(edit); !ok) return tl::unexpected(ok.error());
  return std::make_shared<const BodyEdit>(std::move(edit));
}

std::int64_t body_edit_checksum(std::int64_t id, std::string_view kind, std::string_view bytes) {
  std::string head;
  ByteWriter out(head);
  out.u64(static_cast<std::uint64_t>(id));
  out.text(kind);
  return static_cast<std::int64_t>(crc32c(bytes, crc32c(head)));
}

Result<void> write_body_edits(Database& database, const Document& document) {
  if (document.body_edits().empty()) return {};
  if (auto ok = database.run(std::string(kBodyEditTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO body_edit VALUES(?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::string bytes;
  for (const auto& [id, edit] : document.body_edits()) {
    bytes.clear();
    if (auto ok = append_body_edit_blob(bytes, *edit); !ok) return ok;
    const auto number = static_cast<std::int64_t>(id.value);
    const std::string_view kind = body_edit_kind_name(edit->kind);
    row->bind(1, number);
    row->bind_text(2, kind);
    row->bind_blob(3, bytes);
    row->bind(4, body_edit_checksum(number, kind, bytes));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> read_body_edits(const Database& database, Edit& edit) {
  const auto row = database.prepare("SELECT id, kind, shape, checksum FROM body_edit ORDER BY id");
  if (!row) return tl::unexpected(row.error());
  for (std::size_t count = 0;; ++count) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (count == kMaxBodyEdits) {
      return fail(ErrorCode::kLimitExceeded, "has more than 1000 edits of its body");
    }
    const std::string name = "body edit " + std::to_string(row->integer(0));
    if (!is_id(row->integer(0)) || !row->is_text(1) || !row->is_blob(2) || !row->is_integer(3)) {
      return invalid_data(name + " contains an invalid value");
    }
    if (row->integer(3) != body_edit_checksum(row->integer(0), row->text(1), row->blob(2))) {
      return invalid_data(name + " is damaged: its checksum does not match its bytes");
    }
    Result<BodyEditPtr> read = read_body_edit_blob(row->text(1), row->blob(2));
    if (!read) return tl::unexpected(with_context(read.error(), name));
    edit.body_edits.push_back(
        {{static_cast<std::uint64_t>(row->integer(0))}, nullptr, *std::move(read)});
  }
}

}  // namespace felt
