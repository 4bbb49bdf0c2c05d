#include "felt/store/guide_table.h"

#include <memory>
#include <utility>

#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_tables.h"

namespace felt {
namespace {

constexpr std::uint8_t kGuideVersion = 1, kSymmetryVersion = 1;
constexpr std::size_t kPointBytes = 16, kTimeBytes = 8, kMinImageBytes = 2;

tl::unexpected<Error> unknown_version(int version) {
  return fail(ErrorCode::kUnsupported,
              "has version " + std::to_string(version) + "; this program supports version 1");
}

/// Reads the next row of a table. Returns false at the end.
Result<bool> next(const Statement& row, const char* kind, int last_column) {
  Result<bool> more = row.step();
  if (!more || !*more) return more;
  if (!is_id(row.integer(0)) || !row.is_blob(last_column - 1) || !row.is_integer(last_column)) {
    return invalid_data(std::string(kind) + " " + std::to_string(row.integer(0)) +
                        " contains an invalid value");
  }
  return true;
}

tl::unexpected<Error> damaged(const std::string& name) {
  return invalid_data(name + " is damaged: its checksum does not match its bytes");
}

}  // namespace

std::int64_t guide_checksum(std::int64_t id, std::int64_t shown, std::string_view bytes) {
  std::string numbers;
  ByteWriter out(numbers);
  for (const std::int64_t n : {id, shown}) out.u64(static_cast<std::uint64_t>(n));
  return static_cast<std::int64_t>(crc32c(bytes, crc32c(numbers)));
}

Result<void> append_guide_blob(std::string& out, const DrawingGuide& guide) {
  if (auto ok = check_drawing_guide(guide); !ok) return ok;
  ByteWriter writer(out);
  writer.u8(kGuideVersion);
  writer.u8(static_cast<std::uint8_t>(guide.kind));
  writer.u8(static_cast<std::uint8_t>(guide.axes));
  for (const double number : {guide.origin.x, guide.origin.y, guide.angle_rad, guide.size_mm,
                              guide.second_mm, guide.step_rad, guide.strength}) {
    writer.f64(number);
  }
  writer.count(guide.stroke.value);
  writer.count(guide.points.size());
  for (const Point p : guide.points) {
    writer.f64(p.x);
    writer.f64(p.y);
  }
  writer.count(guide.times_ms.size());
  for (const double ms : guide.times_ms) writer.f64(ms);
  return {};
}

Result<DrawingGuidePtr> read_guide_blob(std::string_view bytes) {
  ByteReader in(bytes);
  if (const std::uint8_t version = in.u8(); version != kGuideVersion) {
    return unknown_version(version);
  }
  DrawingGuide guide;
  guide.kind = static_cast<DrawingGuideKind>(in.u8());
  guide.axes = in.u8();
  for (double* number : {&guide.origin.x, &guide.origin.y, &guide.angle_rad, &guide.size_mm,
                         &guide.second_mm, &guide.step_rad, &guide.strength}) {
    *number = in.f64();
  }
  guide.stroke = {in.count()};
  const std::uint64_t points = in.count();
  if (!in.has(points, kPointBytes)) return invalid_data("has fewer points than it states");
  for (std::uint64_t i = 0; i < points; ++i) {
    const double x = in.f64(), y = in.f64();
    guide.points.push_back({x, y});
  }
  const std::uint64_t times = in.count();
  if (!in.has(times, kTimeBytes)) return invalid_data("has fewer times than it states");
  for (std::uint64_t i = 0; i < times; ++i) guide.times_ms.push_back(in.f64());
  if (!in.ok() || in.left() > 0) return invalid_data("does not have the length that it states");
  if (auto ok = check_drawing_guide(guide); !ok) return tl::unexpected(ok.error());
  return std::make_shared<const DrawingGuide>(std::move(guide));
}

Result<void> append_symmetry_blob(std::string& out, const SymmetryGroup& group) {
  if (auto ok = check_symmetry_group(group); !ok) return ok;
  ByteWriter writer(out);
  writer.u8(kSymmetryVersion);
  writer.u8(static_cast<std::uint8_t>(group.axes));
  for (const double number : {group.center.x, group.center.y, group.angle_rad}) writer.f64(number);
  writer.count(group.images.size());
  for (const SymmetryImage& image : group.images) {
    writer.u8(static_cast<std::uint8_t>(image.image));
    writer.count(image.stroke.value);
  }
  return {};
}

Result<SymmetryPtr> read_symmetry_blob(std::string_view bytes) {
  ByteReader in(bytes);
  if (const std::uint8_t version = in.u8(); version != kSymmetryVersion) {
    return unknown_version(version);
  }
  SymmetryGroup group;
  group.axes = in.u8();
  for (double* number : {&group.center.x, &group.center.y, &group.angle_rad}) *number = in.f64();
  const std::uint64_t images = in.count();
  if (!in.has(images, kMinImageBytes)) return invalid_data("has fewer images than it states");
  for (std::uint64_t i = 0; i < images; ++i) {
    const int image = in.u8();
    group.images.push_back({{in.count()}, image});
  }
  if (!in.ok() || in.left() > 0) return invalid_data("does not have the length that it states");
  if (auto ok = check_symmetry_group(group); !ok) return tl::unexpected(ok.error());
  return std::make_shared<const SymmetryGroup>(std::move(group));
}

namespace {

Result<void> write_guide_table(Database& database, const Document& document) {
  if (document.guides().empty()) return {};
  if (auto ok = database.run(std::string(kGuideTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO guide VALUES(?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  const std::int64_t shown = document.shows_guides() ? 1 : 0;
  std::string bytes;
  for (const auto& [id, guide] : document.guides()) {
    bytes.clear();
    if (auto ok = append_guide_blob(bytes, *guide); !ok) return ok;
    const auto number = static_cast<std::int64_t>(id.value);
    row->bind(1, number);
    row->bind(2, shown);
    row->bind_blob(3, bytes);
    row->bind(4, guide_checksum(number, shown, bytes));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_symmetry_table(Database& database, const Document& document) {
  if (document.symmetries().empty()) return {};
  if (auto ok = database.run(std::string(kSymmetryTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO symmetry VALUES(?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::string bytes;
  for (const auto& [id, group] : document.symmetries()) {
    bytes.clear();
    if (auto ok = append_symmetry_blob(bytes, *group); !ok) return ok;
    const auto number = static_cast<std::int64_t>(id.value);
    row->bind(1, number);
    row->bind_blob(2, bytes);
    row->bind(3, guide_checksum(number, 0, bytes));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<DrawingGuidePtr> read_guide_row(const Statement& row) {
  const std::string name = "guide " + std::to_string(row.integer(0));
  if (!row.is_integer(1) || (row.integer(1) | 1) != 1) {
    return invalid_data(name + " contains an invalid value");
  }
  if (row.integer(3) != guide_checksum(row.integer(0), row.integer(1), row.blob(2))) {
    return damaged(name);
  }
  Result<DrawingGuidePtr> guide = read_guide_blob(row.blob(2));
  if (!guide) return tl::unexpected(with_context(guide.error(), name));
  return guide;
}

}  // namespace

Result<void> write_guides(Database& database, const Document& document) {
  return write_guide_table(database, document).and_then([&] {
    return write_symmetry_table(database, document);
  });
}

std::string too_many_guides(std::size_t count) {
  return "Skipped " + std::to_string(count - kMaxDrawingGuides) + " of " + std::to_string(count) +
         " guides: a drawing has at most " + std::to_string(kMaxDrawingGuides) + ".";
}

Result<void> read_guides(const Database& database, Edit& edit, std::vector<std::string>* notices) {
  const auto row = database.prepare("SELECT id, shown, guide, checksum FROM guide ORDER BY id");
  if (!row) return tl::unexpected(row.error());
  bool is_hidden = false;
  std::size_t count = 0;
  for (;; ++count) {
    const Result<bool> more = next(*row, "guide", 3);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (count == kMaxStoredGuides) {
      return fail(ErrorCode::kLimitExceeded, "has more than 10000 guides");
    }
    if (count >= kMaxDrawingGuides) continue;
    Result<DrawingGuidePtr> guide = read_guide_row(*row);
    if (!guide) return tl::unexpected(guide.error());
    edit.guides.push_back(
        {{static_cast<std::uint64_t>(row->integer(0))}, nullptr, *std::move(guide)});
    is_hidden = row->integer(1) == 0;
  }
  if (count > kMaxDrawingGuides && notices) notices->push_back(too_many_guides(count));
  edit.toggles_guides = is_hidden;
  return {};
}

Result<void> read_symmetries(const Database& database, Edit& edit) {
  const auto row = database.prepare("SELECT id, strokes, checksum FROM symmetry");
  if (!row) return tl::unexpected(row.error());
  for (std::size_t count = 0;; ++count) {
    const Result<bool> more = next(*row, "symmetry", 2);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (count == kMaxStoredSymmetries) {
      return fail(ErrorCode::kLimitExceeded, "has more than 10000000 symmetry groups");
    }
    const std::string name = "symmetry " + std::to_string(row->integer(0));
    if (row->integer(2) != guide_checksum(row->integer(0), 0, row->blob(1))) return damaged(name);
    Result<SymmetryPtr> group = read_symmetry_blob(row->blob(1));
    if (!group) return tl::unexpected(with_context(group.error(), name));
    edit.symmetries.push_back(
        {{static_cast<std::uint64_t>(row->integer(0))}, nullptr, *std::move(group)});
  }
}

}  // namespace felt
