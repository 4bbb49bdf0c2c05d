#include "felt/store/felt_tables.h"

#include <optional>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/store/body_edit_table.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_page.h"
#include "felt/store/fill_table.h"
#include "felt/store/guide_table.h"
#include "felt/store/key_timing_table.h"
#include "felt/store/layer_group_table.h"
#include "felt/store/layer_look_table.h"
#include "felt/store/material_table.h"
#include "felt/store/stroke_blob.h"
#include "felt/store/stroke_name_table.h"

namespace felt {
namespace {

/// Returns the checksum of everything that the checksums of the strokes do not cover.
std::uint32_t checksum_of(const Drawing& d) {
  std::string bytes;
  ByteWriter out(bytes);
  out.f64(d.page.width_mm);
  out.f64(d.page.height_mm);
  out.u32(static_cast<std::uint32_t>(number_of(d.page.paper)));
  out.text(d.page.surface);
  out.u32(static_cast<std::uint32_t>(number_of(d.color)));
  out.u64(d.layer.value);
  out.u64(d.document.new_id().value);
  out.u64(d.document.new_layer_id().value);
  for (const Layer& layer : d.document.layers()) {
    out.u64(layer.id.value);
    out.text(layer.name);
    out.u8(static_cast<std::uint8_t>((layer.own_visible ? 1 : 0) | (layer.own_locked ? 2 : 0)));
    out.u64(layer.strokes.size());
    for (const StrokeId id : layer.strokes) out.u64(id.value);
  }
  append_page_bytes(out, d);
  return crc32c(bytes);
}

bool is_side(double mm) noexcept {
  return mm >= Page::kMinMm && mm <= Page::kMaxMm;  // false for NaN
}

bool is_layer_name(std::string_view text) noexcept {
  return text.size() <= kMaxLayerNameBytes && is_utf8(text);
}

Result<void> check_drawing(const Drawing& d) {
  if (d.document.new_id().value - 1 > static_cast<std::uint64_t>(kMaxId) ||
      d.document.new_layer_id().value - 1 > static_cast<std::uint64_t>(kMaxId)) {
    return fail(ErrorCode::kLimitExceeded, "has no free numbers for strokes or layers");
  }
  if (!is_side(d.page.width_mm) || !is_side(d.page.height_mm)) {
    return invalid_data("the sides of the page must be 10 to 5000 mm");
  }
  if (!is_layer_name(d.page.surface)) return invalid_data("the surface has an invalid name");
  if (d.layer && !d.document.layer(d.layer)) return invalid_data("the active layer does not exist");
  if (d.document.layers().size() > kMaxLayers) {
    return fail(ErrorCode::kLimitExceeded, "has more than 10000 layers");
  }
  return check_page(d);
}

// --- Writing

Result<void> write_drawing_row(const Database& db, const Drawing& d) {
  const auto row = db.prepare(
      "INSERT INTO drawing(id, width_mm, height_mm, paper, material, color, layer, last_stroke, "
      "last_layer, palette, palette_columns, checksum) VALUES(1,?,?,?,?,?,?,?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  row->bind(1, d.page.width_mm);
  row->bind(2, d.page.height_mm);
  row->bind(3, number_of(d.page.paper));
  row->bind_text(4, d.page.surface);
  row->bind(5, number_of(d.color));
  row->bind(6, static_cast<std::int64_t>(d.layer.value));
  row->bind(7, static_cast<std::int64_t>(d.document.new_id().value - 1));
  row->bind(8, static_cast<std::int64_t>(d.document.new_layer_id().value - 1));
  row->bind_text(9, d.palette.name);
  row->bind(10, static_cast<std::int64_t>(d.palette.columns));
  row->bind(11, static_cast<std::int64_t>(checksum_of(d)));
  return row->step().map([](bool) {});
}

Result<void> write_layers(const Database& db, const Document& document) {
  const auto row =
      db.prepare("INSERT INTO layer(id, place, name, visible, locked) VALUES(?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t place = 0;
  for (const Layer& layer : document.layers()) {
    if (!is_layer_name(layer.name)) return invalid_data("a layer has an invalid name");
    row->bind(1, static_cast<std::int64_t>(layer.id.value));
    row->bind(2, place++);
    row->bind_text(3, layer.name);
    row->bind(4, std::int64_t{layer.own_visible});
    row->bind(5, std::int64_t{layer.own_locked});
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_strokes(const Database& db, const Document& document) {
  const auto row = db.prepare("INSERT INTO stroke(id, layer, place, shape) VALUES(?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::string shape;
  const auto write = [&](LayerId layer, StrokeId id, std::int64_t place) -> Result<void> {
    shape.clear();
    if (auto ok = append_stroke_blob(shape, *document.find(id)); !ok) {
      return tl::unexpected(with_context(ok.error(), "stroke " + std::to_string(id.value)));
    }
    row->bind(1, static_cast<std::int64_t>(id.value));
    row->bind(2, static_cast<std::int64_t>(layer.value));
    row->bind(3, place);
    row->bind_blob(4, shape);
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
    return {};
  };
  for (const Layer& layer : document.layers()) {
    std::int64_t place = 0;
    for (const StrokeId id : layer.strokes) {
      if (auto done = write(layer.id, id, place++); !done) return done;
    }
  }
  return {};
}

// --- Reading

/// Columns of the table `drawing` that are not members of Drawing.
struct Head {
  std::uint64_t last_stroke = 0, last_layer = 0;
  std::int64_t checksum = 0;
};

bool is_counter(std::int64_t value) noexcept {
  return value >= 0 && value <= kMaxId;
}
Result<Head> read_drawing_row(const Database& db, Drawing& d) {
  const auto row = db.prepare(
      "SELECT width_mm, height_mm, paper, material, color, layer, last_stroke, last_layer, "
      "checksum, palette, palette_columns FROM drawing LIMIT 2");
  if (!row) return tl::unexpected(row.error());
  const Result<bool> any = row->step();
  if (!any) return tl::unexpected(any.error());
  if (!*any) return invalid_data("has no data about its page");
  for (const int column : {2, 4, 5, 6, 7, 8, 10}) {
    if (!row->is_integer(column))
      return invalid_data("the table 'drawing' lacks a required number");
  }
  if (!row->is_real(0) || !row->is_real(1) || !row->is_text(3) ||
      !is_color_number(row->integer(2)) || !is_color_number(row->integer(4)) ||
      !is_counter(row->integer(5)) || !is_counter(row->integer(6)) ||
      !is_counter(row->integer(7)) || !row->is_text(9) || !is_counter(row->integer(10))) {
    return invalid_data("the table 'drawing' contains an invalid value");
  }
  d.page = {row->real(0), row->real(1), color_of(row->integer(2)), std::string(row->text(3))};
  d.color = color_of(row->integer(4));
  d.layer = {static_cast<std::uint64_t>(row->integer(5))};
  d.palette.name = std::string(row->text(9));
  d.palette.columns = static_cast<std::size_t>(row->integer(10));
  const Head head{static_cast<std::uint64_t>(row->integer(6)),
                  static_cast<std::uint64_t>(row->integer(7)), row->integer(8)};
  const Result<bool> more = row->step();
  if (!more) return tl::unexpected(more.error());
  if (*more) return invalid_data("the table 'drawing' has more than one row");
  return head;
}

/// Returns true if a row of the table `layer` is valid and is for the layer at this place.
bool is_layer_row(const Statement& row, std::size_t place) {
  const auto is_switch = [&row](int column) {
    return row.is_integer(column) && (row.integer(column) | 1) == 1;
  };
  return is_id(row.integer(0)) && row.is_text(1) && is_layer_name(row.text(1)) && is_switch(2) &&
         is_switch(3) && row.is_integer(4) && row.integer(4) == static_cast<std::int64_t>(place);
}

/// Adds the layers to an edit of the empty document with which every drawing starts.
Result<void> read_layers(const Database& db, const Document& empty, Edit& edit) {
  const Layer& first = empty.layers().front();
  edit.layers.push_back({first.id, first.state(), std::nullopt, 0, 0});
  const auto row =
      db.prepare("SELECT id, name, visible, locked, place FROM layer ORDER BY place, id");
  if (!row) return tl::unexpected(row.error());
  std::size_t place = 0;
  for (;; ++place) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (place == kMaxLayers) return fail(ErrorCode::kLimitExceeded, "has more than 10000 layers");
    if (!is_layer_row(*row, place)) {
      return invalid_data("layer " + std::to_string(row->integer(0)) +
                          " contains an invalid value");
    }
    LayerChange change{
        {static_cast<std::uint64_t>(row->integer(0))},
        std::nullopt,
        LayerState{std::string(row->text(1)), row->integer(2) != 0, row->integer(3) != 0},
        0,
        place};
    if (change.id == first.id) {
      edit.layers.front().after = std::move(change.after);
      edit.layers.front().after_index = place;
    } else {
      edit.layers.push_back(std::move(change));
    }
  }
  if (place == 0) return invalid_data("has no layer");
  return {};
}

Result<void> read_strokes(const Database& db, Edit& edit) {
  const auto row = db.prepare("SELECT id, layer, place, shape FROM stroke");
  if (!row) return tl::unexpected(row.error());
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    const std::string name = "stroke " + std::to_string(row->integer(0));
    if (!is_id(row->integer(0)) || !row->is_integer(1) || !is_id(row->integer(1)) ||
        !row->is_integer(2) || !is_counter(row->integer(2)) || !row->is_blob(3)) {
      return invalid_data(name + " contains an invalid value");
    }
    Result<Stroke> stroke = read_stroke_blob(row->blob(3));
    if (!stroke) return tl::unexpected(with_context(stroke.error(), name));
    edit.changes.push_back({{static_cast<std::uint64_t>(row->integer(0))},
                            nullptr,
                            std::make_shared<const Stroke>(*std::move(stroke)),
                            {},
                            {{static_cast<std::uint64_t>(row->integer(1))},
                             static_cast<std::size_t>(row->integer(2))}});
  }
}

}  // namespace

Result<void> write_tables(Database& database, const Drawing& drawing, const FeltSchema* like) {
  if (auto ok = check_drawing(drawing); !ok) return ok;
  return make_tables(database, like)
      .and_then([&] { return write_drawing_row(database, drawing); })
      .and_then([&] { return write_layers(database, drawing.document); })
      .and_then([&] { return write_layer_looks(database, drawing.document); })
      .and_then([&] { return write_layer_blends(database, drawing.document); })
      .and_then([&] { return write_layer_groups(database, drawing.document); })
      .and_then([&] { return write_key_timings(database, drawing.document); })
      .and_then([&] { return write_strokes(database, drawing.document); })
      .and_then([&] { return write_fills(database, drawing.document); })
      .and_then([&] { return write_guides(database, drawing.document); })
      .and_then([&] { return write_body_edits(database, drawing.document); })
      .and_then([&] { return write_page(database, drawing); })
      .and_then([&] { return write_materials(database, drawing); })
      .and_then([&] { return write_stroke_names(database, drawing); });
}

Result<Drawing> read_tables(const Database& database, const FeltSchema& schema,
                            std::vector<std::string>* notices) {
  Drawing drawing;
  const Result<Head> head = read_drawing_row(database, drawing);
  if (!head) return tl::unexpected(head.error());
  Edit edit;  // without a label, because errors must name the file and not an edit
  Result<void> done = read_layers(database, drawing.document, edit);
  const auto then = [&](bool has_table, Result<void> (*read)(const Database&, Edit&)) {
    if (done && has_table) done = read(database, edit);
  };
  then(schema.has_layer_looks, read_layer_opacities);
  if (done && schema.has_pictures) done = read_pictures(database, edit, notices);
  then(schema.has_layer_blends, read_layer_blends);
  then(schema.has_layer_groups, read_layer_groups);
  then(schema.has_key_timings, read_key_timings);
  then(true, read_strokes);
  then(schema.has_fills, read_fills);
  if (done && schema.has_guides) done = read_guides(database, edit, notices);
  then(schema.has_symmetries, read_symmetries);
  then(schema.has_body_edits, read_body_edits);
  if (done) {
    done = drawing.document.apply(edit);
    // Each row is valid, but they do not make a drawing.
    if (!done) done = invalid_data("is damaged: " + done.error().message);
    if (done) done = read_page(database, drawing);
  }
  if (done && schema.has_materials) done = read_materials(database, drawing);
  if (done && schema.has_stroke_names) done = read_stroke_names(database, drawing);
  if (!done) return tl::unexpected(done.error());
  drawing.document.reserve_ids({head->last_stroke}, {head->last_layer});
  if (auto ok = check_drawing(drawing); !ok) return tl::unexpected(ok.error());
  if (checksum_of(drawing) != head->checksum) {
    return invalid_data("is damaged: its checksum does not match its layers");
  }
  return drawing;
}

}  // namespace felt
