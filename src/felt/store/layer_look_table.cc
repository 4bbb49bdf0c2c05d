#include "felt/store/layer_look_table.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/layer_rows.h"
#include "felt/store/stroke_blob.h"

namespace felt {
namespace {

// A database reads values up to kMaxStrokeBlobBytes: a picture, and also the event that adds it to
// a recording, in base64.
static_assert(PictureData::kMaxBytes / 3 * 4 + 10'000 < kMaxStrokeBlobBytes);

/// Returns the checksum of a picture and its place. If another row has the bytes of the picture,
/// `same_as` is its id, and the checksum covers that instead of the bytes.
std::int64_t picture_checksum(const LayerPicture& picture, std::int64_t same_as) {
  std::string numbers;
  ByteWriter out(numbers);
  const Affine& m = picture.place;
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(x);
  out.u8(picture.exported ? 1 : 0);
  if (same_as != 0) out.u64(static_cast<std::uint64_t>(same_as));
  const std::string_view bytes = same_as == 0 ? picture.data->png : std::string_view();
  return static_cast<std::int64_t>(crc32c(bytes, crc32c(numbers)));
}

/// Pictures by the id of the first row that has them.
using PictureRows = std::vector<std::pair<std::int64_t, std::shared_ptr<const PictureData>>>;

/// Returns the row with the same picture, or 0.
std::int64_t row_of(const PictureRows& rows, const PictureData& data) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&data](const auto& row) {
    return row.second.get() == &data || *row.second == data;
  });
  return found == rows.end() ? 0 : found->first;
}

Result<void> write_opacities(Database& database, const Document& document) {
  if (auto ok = database.run(std::string(kLayerLookTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO layer_look VALUES(?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  for (const Layer& layer : document.layers()) {
    if (layer.opacity == 1.0) continue;
    row->bind(1, ++id);
    row->bind(2, static_cast<std::int64_t>(layer.id.value));
    row->bind(3, layer.opacity);
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_pictures(Database& database, const Document& document) {
  if (auto ok = database.run(std::string(kPictureTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO picture VALUES(?,?,?,?,?,?,?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  PictureRows stored;
  for (const Layer& layer : document.layers()) {
    if (!layer.picture) continue;
    const std::int64_t same_as = row_of(stored, *layer.picture->data);
    if (same_as == 0) stored.emplace_back(id + 1, layer.picture->data);
    const Affine& m = layer.picture->place;
    row->bind(1, ++id);
    row->bind(2, static_cast<std::int64_t>(layer.id.value));
    int column = 3;
    for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) row->bind(column++, x);
    row->bind(9, std::int64_t{layer.picture->exported});
    if (same_as == 0) {
      row->bind_blob(10, layer.picture->data->png);
    } else {
      row->bind(10, same_as);
    }
    row->bind(11, picture_checksum(*layer.picture, same_as));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

/// Reads a row. `read` has the pictures of the rows before it. If the row that has the bytes is
/// missing, because an older program left it out together with its layer, adds a notice.
bool read_picture(const Statement& row, PictureRows& read, LayerState& state,
                  std::vector<std::string>* notices) {
  PictureRow values;
  for (int i = 0; i < 6; ++i) {
    if (!row.is_real(i + 1)) return false;
    values.place[static_cast<std::size_t>(i)] = row.real(i + 1);
  }
  if (!row.is_integer(7) || !row.is_integer(9) || !row.is_integer(10)) return false;
  values.exported = row.integer(7);
  values.checksum = row.integer(9);
  if (row.is_integer(8)) {
    values.same_as = row.integer(8);
    const auto same = std::find_if(read.begin(), read.end(), [&values](const auto& known) {
      return known.first == values.same_as;
    });
    if (same == read.end()) {
      if (notices) notices->push_back("The picture of the layer '" + state.name + "' is lost.");
      return true;
    }
    values.data = same->second;
  } else if (row.is_blob(8)) {
    values.data = make_picture_data(std::string(row.blob(8))).value_or(nullptr);
    read.emplace_back(row.integer(10), values.data);
  }
  state.picture = picture_of_row(values);
  return state.picture != nullptr;
}

}  // namespace

LayerPicturePtr picture_of_row(const PictureRow& row) {
  if ((row.exported | 1) != 1 || !row.data) return nullptr;
  const auto& m = row.place;
  LayerPicture picture{row.data, {m[0], m[1], m[2], m[3], m[4], m[5]}, row.exported != 0};
  if (!is_picture_place(picture.place)) return nullptr;
  if (picture_checksum(picture, row.same_as) != row.checksum) return nullptr;
  return std::make_shared<const LayerPicture>(std::move(picture));
}

Result<void> write_layer_looks(Database& database, const Document& document) {
  const std::span<const Layer> layers = document.layers();
  const auto is_faded = [](const Layer& layer) { return layer.opacity != 1.0; };
  const auto has_picture = [](const Layer& layer) { return layer.picture != nullptr; };
  if (std::any_of(layers.begin(), layers.end(), is_faded)) {
    if (auto ok = write_opacities(database, document); !ok) return ok;
  }
  if (std::none_of(layers.begin(), layers.end(), has_picture)) return {};
  return write_pictures(database, document);
}

Result<void> read_layer_opacities(const Database& database, Edit& edit) {
  return for_each_layer_row(database, "SELECT layer, opacity FROM layer_look", "layer_look", edit,
                            [](const Statement& row, LayerState& state) {
                              if (!row.is_real(1)) return false;
                              state.opacity = row.real(1);
                              return state.opacity >= 0.0 && state.opacity <= 1.0;
                            });
}

Result<void> read_pictures(const Database& database, Edit& edit,
                           std::vector<std::string>* notices) {
  PictureRows read;
  return for_each_layer_row(
      database,
      "SELECT layer, a, b, c, d, e, f, exported, png, checksum, id FROM picture ORDER BY id",
      "picture", edit, [&read, notices](const Statement& row, LayerState& state) {
        return read_picture(row, read, state, notices);
      });
}

}  // namespace felt
