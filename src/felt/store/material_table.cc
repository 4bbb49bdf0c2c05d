#include "felt/store/material_table.h"

#include <string>

#include "felt/io/limits.h"
#include "felt/io/xml/material_texts.h"
#include "felt/store/crc32c.h"

namespace felt {
namespace {

tl::unexpected<Error> impossible() {
  return fail(ErrorCode::kInvalidData, "the table 'material' contains an invalid value");
}

tl::unexpected<Error> too_many() {
  return fail(ErrorCode::kLimitExceeded,
              "carries more than " + std::to_string(limits::kMaxMaterialTexts) + " materials");
}

}  // namespace

std::int64_t material_checksum(std::string_view text) noexcept {
  return static_cast<std::int64_t>(crc32c(text));
}

Result<void> write_materials(Database& database, const Drawing& drawing) {
  if (drawing.materials.empty()) return {};
  if (drawing.materials.size() > limits::kMaxMaterialTexts) return too_many();
  if (auto ok = database.run(std::string(kMaterialTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO material VALUES(?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  for (const std::string& text : drawing.materials) {
    if (!is_material_text(text)) return impossible();
    row->bind(1, ++id);
    row->bind_text(2, text);
    row->bind(3, material_checksum(text));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> read_materials(const Database& database, Drawing& drawing) {
  const auto row = database.prepare("SELECT text, checksum FROM material");
  if (!row) return tl::unexpected(row.error());
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (drawing.materials.size() == limits::kMaxMaterialTexts) return too_many();
    if (!row->is_text(0) || !row->is_integer(1) || !is_material_text(row->text(0))) {
      return impossible();
    }
    if (row->integer(1) != material_checksum(row->text(0))) {
      return fail(ErrorCode::kInvalidData, "the text of a material is damaged");
    }
    drawing.materials.emplace_back(row->text(0));
  }
}

}  // namespace felt
