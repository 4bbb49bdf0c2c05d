#include "felt/store/fill_table.h"

#include <string>
#include <utility>

#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_tables.h"
#include "felt/store/fill_blob.h"

namespace felt {

std::int64_t fill_checksum(std::int64_t id, std::int64_t layer, std::int64_t place,
                           std::string_view shape) {
  std::string numbers;
  ByteWriter out(numbers);
  for (const std::int64_t n : {id, layer, place}) out.u64(static_cast<std::uint64_t>(n));
  return static_cast<std::int64_t>(crc32c(shape, crc32c(numbers)));
}

Result<void> write_fills(Database& database, const Document& document) {
  if (document.fill_count() == 0) return {};
  if (auto ok = database.run(std::string(kFillTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO fill VALUES(?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::string shape;
  for (const Layer& layer : document.layers()) {
    for (std::size_t i = 0; i < layer.fills.size(); ++i) {
      shape.clear();
      if (auto ok = append_fill_blob(shape, *document.find_fill(layer.fills[i])); !ok) {
        return tl::unexpected(
            with_context(ok.error(), "fill " + std::to_string(layer.fills[i].value)));
      }
      const auto id = static_cast<std::int64_t>(layer.fills[i].value),
                 in = static_cast<std::int64_t>(layer.id.value),
                 place = static_cast<std::int64_t>(i);
      row->bind(1, id);
      row->bind(2, in);
      row->bind(3, place);
      row->bind_blob(4, shape);
      row->bind(5, fill_checksum(id, in, place, shape));
      if (auto done = row->step(); !done) return tl::unexpected(done.error());
      row->reset();
    }
  }
  return {};
}

Result<void> read_fills(const Database& database, Edit& edit) {
  const auto row = database.prepare("SELECT id, layer, place, shape, checksum FROM fill");
  if (!row) return tl::unexpected(row.error());
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    const std::string name = "fill " + std::to_string(row->integer(0));
    if (!is_id(row->integer(0)) || !row->is_integer(1) || !is_id(row->integer(1)) ||
        !row->is_integer(2) || row->integer(2) < 0 || row->integer(2) > kMaxId ||
        !row->is_blob(3) || !row->is_integer(4)) {
      return invalid_data(name + " contains an invalid value");
    }
    if (row->integer(4) !=
        fill_checksum(row->integer(0), row->integer(1), row->integer(2), row->blob(3))) {
      return invalid_data(name + " is damaged: its checksum does not match its bytes");
    }
    Result<FillPtr> fill = read_fill_blob(row->blob(3));
    if (!fill) return tl::unexpected(with_context(fill.error(), name));
    edit.fills.push_back({{static_cast<std::uint64_t>(row->integer(0))},
                          nullptr,
                          *std::move(fill),
                          {},
                          {{static_cast<std::uint64_t>(row->integer(1))},
                           static_cast<std::size_t>(row->integer(2))}});
  }
}

}  // namespace felt
