#include "felt/store/layer_look_table.h"

#include <algorithm>
#include <string>
#include <utility>

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

/// Returns the checksum of a picture and its place.
std::int64_t picture_checksum(const LayerPicture& picture) {
  std::string numbers;
  ByteWriter out(numbers);
  const Affine& m = picture.place;
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(x);
  out.u8(picture.exported ? 1 : 0);
  return static_cast<std::int64_t>(crc32c(picture.data->png, crc32c(numbers)));
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
  for (const Layer& layer : document.layers()) {
    if (!layer.picture) continue;
    const Affine& m = layer.picture->place;
    row->bind(1, ++id);
    row->bind(2, static_cast<std::int64_t>(layer.id.value));
    int column = 3;
    for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) row->bind(column++, x);
    row->bind(9, std::int64_t{layer.picture->exported});
    row->bind_blob(10, layer.picture->data->png);
    row->bind(11, picture_checksum(*layer.picture));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

bool read_picture(const Statement& row, LayerState& state) {
  std::array<double, 6> m{};
  for (int i = 0; i < 6; ++i) {
    if (!row.is_real(i + 1)) return false;
    m[static_cast<std::size_t>(i)] = row.real(i + 1);
  }
  if (!row.is_integer(7) || !row.is_blob(8) || !row.is_integer(9)) return false;
  state.picture = picture_of_row(m, row.integer(7), std::string(row.blob(8)), row.integer(9));
  return state.picture != nullptr;
}

}  // namespace

LayerPicturePtr picture_of_row(const std::array<double, 6>& m, std::int64_t exported,
                               std::string png, std::int64_t checksum) {
  if ((exported | 1) != 1) return nullptr;
  auto data = make_picture_data(std::move(png));
  if (!data) return nullptr;
  LayerPicture picture{*std::move(data), {m[0], m[1], m[2], m[3], m[4], m[5]}, exported != 0};
  if (!is_picture_place(picture.place) || picture_checksum(picture) != checksum) return nullptr;
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

Result<void> read_pictures(const Database& database, Edit& edit) {
  return for_each_layer_row(database,
                            "SELECT layer, a, b, c, d, e, f, exported, png, checksum FROM picture",
                            "picture", edit, read_picture);
}

}  // namespace felt
