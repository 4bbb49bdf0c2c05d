#include "felt/autosave/autosave_rows.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "felt/autosave/edit_blob.h"
#include "felt/autosave/layer_look.h"
#include "felt/base/utf8.h"
#include "felt/io/limits.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_tables.h"
#include "felt/store/fill_blob.h"
#include "felt/store/layer_group_table.h"
#include "felt/store/stroke_blob.h"
#include "felt/store/stroke_name_table.h"

namespace felt {
namespace {

constexpr std::size_t kMaxTextBytes = 1 << 16;
constexpr std::size_t kMaxHeadBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxNamesBytes = std::size_t{256} << 20;
constexpr std::size_t kMinLayerBytes = 13, kMinRunStrokeBytes = 12, kNameHeadBytes = 12;
constexpr std::uint8_t kRowVisible = 1, kRowLocked = 2, kRowHasLook = 4;

/// Appends a drawing without its strokes and layers, as the bytes of a .felt file.
Result<void> append_page(ByteWriter& out, const Drawing& drawing) {
  Drawing page;  // without document and extras
  page.page = drawing.page;
  page.color = drawing.color;
  page.palette = drawing.palette;
  page.view = drawing.view;
  page.materials = drawing.materials;
  const Result<std::string> bytes = felt_bytes(page);
  if (!bytes) return tl::unexpected(bytes.error());
  out.text(*bytes);
  return {};
}

bool has_timings(const Document& document) {
  const auto layers = document.layers();
  return !document.body_edits().empty() ||
         std::any_of(layers.begin(), layers.end(),
                     [](const Layer& l) { return l.timing != nullptr; });
}

bool has_names(const Drawing& drawing) {
  return drawing.names && !drawing.names->empty();
}

/// Appends the guides and symmetry groups of a base, as the bytes of an edit that adds them.
/// Appends nothing if there are none, unless others follow.
Result<void> append_guides(ByteWriter& out, const Drawing& drawing) {
  const Document& document = drawing.document;
  Edit edit;
  for (const auto& [id, guide] : document.guides()) edit.guides.push_back({id, nullptr, guide});
  for (const auto& [id, group] : document.symmetries()) {
    edit.symmetries.push_back({id, nullptr, group});
  }
  edit.toggles_guides = !document.shows_guides();
  if (edit.empty() && !has_timings(document) && !has_names(drawing)) return {};
  std::string bytes;
  if (auto ok = append_edit_blob(bytes, edit); !ok) return ok;
  out.text(bytes);
  return {};
}

/// Appends the timings of the layers and the edits of the body of a base, as the bytes of an edit
/// that adds them. Appends nothing if there are none, unless names follow. They follow the bytes of
/// the guides, after which programs from before timings stop to read.
Result<void> append_timings(ByteWriter& out, const Drawing& drawing) {
  const Document& document = drawing.document;
  Edit edit;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    const Layer& layer = document.layers()[i];
    if (!layer.timing) continue;
    LayerState before = layer.state();
    before.timing = nullptr;
    edit.layers.push_back({layer.id, std::move(before), layer.state(), i, i});
  }
  for (const auto& [id, body_edit] : document.body_edits()) {
    edit.body_edits.push_back({id, nullptr, body_edit});
  }
  if (edit.empty() && !has_names(drawing)) return {};
  std::string bytes;
  if (auto ok = append_edit_blob(bytes, edit); !ok) return ok;
  out.text(bytes);
  return {};
}

/// Appends the names of strokes, including deleted strokes, which an undo can restore. Appends
/// nothing if there are none. Names that .felt files cannot have are left out, and so are all names
/// after the first kMaxNamesBytes, because SQLite limits the size of a row. The names follow the
/// timings, after which programs from before names stop reading.
void append_names(ByteWriter& out, const Drawing& drawing) {
  if (!has_names(drawing)) return;
  std::string names;
  ByteWriter names_out(names);
  for (const auto& [id, name] : *drawing.names) {
    if (!is_stroke_name(name)) continue;
    if (names.size() + kNameHeadBytes + name.size() > kMaxNamesBytes) break;
    names_out.u64(id.value);
    names_out.text(name);
  }
  out.text(names);
}

/// Reads what append_names() wrote. Returns null if there are no names. `next` is the id of the
/// next new stroke, which must not have a name.
Result<std::shared_ptr<const StrokeNames>> read_names(ByteReader& in, StrokeId next) {
  if (in.left() == 0) return nullptr;
  ByteReader names_in(in.text(kMaxNamesBytes));
  if (!in.ok()) return invalid_data("the names of strokes are incomplete");
  StrokeNames names;
  while (names_in.left() > 0) {
    const StrokeId id{names_in.u64()};
    const std::string_view name = names_in.text(limits::kMaxNameBytes);
    if (id.value == 0 || id.value >= next.value || !is_stroke_name(name)) {
      return invalid_data("the name of a stroke is damaged");
    }
    names.try_emplace(id, name);
  }
  return std::make_shared<const StrokeNames>(std::move(names));
}

/// Reads the layers of a base as an edit of a new document.
Result<Edit> read_layers(ByteReader& in, const Document& document) {
  const std::uint32_t count = in.u32();
  if (!in.has(count, kMinLayerBytes) || count == 0)
    return invalid_data("the list of layers is incomplete");
  const Layer& first = document.layers().front();
  Edit edit;
  PicturesInBytes pictures;
  edit.layers.push_back({first.id, first.state(), std::nullopt, 0, 0});
  for (std::uint32_t i = 0; i < count; ++i) {
    LayerChange change{{in.u64()}, std::nullopt, LayerState{}, 0, i};
    change.after->name = std::string(utf8_prefix(in.text(kMaxTextBytes), kMaxLayerNameBytes));
    const std::uint8_t flags = in.u8();
    change.after->visible = (flags & kRowVisible) != 0;
    change.after->locked = (flags & kRowLocked) != 0;
    change.after->blend = blend_of_flags(flags);
    if ((flags & kRowHasLook) != 0) read_layer_look(in, *change.after, nullptr, pictures);
    if (!is_id(static_cast<std::int64_t>(change.id.value))) {
      return invalid_data("a layer has an invalid id");
    }
    if (change.id == first.id && edit.layers.front().after) {
      return invalid_data("layer " + std::to_string(first.id.value) + " is listed twice");
    }
    if (change.id == first.id) {
      edit.layers.front().after = std::move(change.after);
      edit.layers.front().after_index = i;
    } else {
      edit.layers.push_back(std::move(change));
    }
  }
  if (!in.ok()) return invalid_data("the list of layers is incomplete");
  return edit;
}

/// Reads the groups of the layers of a base, which a base of an older program does not have. They
/// are in the order of the layers.
void read_groups(ByteReader& in, Edit& edit) {
  if (in.left() == 0) return;
  std::vector<LayerChange*> layers(edit.layers.size());
  for (LayerChange& c : edit.layers) {
    if (c.after) layers[c.after_index] = &c;
  }
  for (LayerChange* c : layers) {
    if (c) c->after->group = read_layer_group(in);
  }
  separate_groups_of(edit);
}

}  // namespace

Result<void> remove_autosave_folder(const std::string& folder) {
  // Deletes the database first, because a folder without one holds no drawing. The lock is last.
  for (const char* name : {kAutosaveDatabaseFile, kNewDatabaseFile, kCopiedDatabaseFile}) {
    for (const char* end : {"", "-wal", "-shm", "-journal"}) {
      const std::string path = folder + '/' + name + end;
      // Stops at the first failure: a database must not lose its WAL, or it would be an older
      // drawing.
      if (::unlink(path.c_str()) != 0 && errno != ENOENT) {
        return fail(ErrorCode::kIo, path + ": cannot remove: " + std::strerror(errno));
      }
    }
  }
  ::unlink((folder + "/lock").c_str());
  if (::rmdir(folder.c_str()) == 0 || errno == ENOENT) return {};
  return fail(ErrorCode::kIo, folder + ": cannot remove: " + std::strerror(errno));
}

std::int64_t row_crc(std::uint64_t a, std::uint64_t b, std::string_view bytes) noexcept {
  std::array<char, 16> numbers{};
  for (std::size_t i = 0; i < 8; ++i) {
    numbers[i] = static_cast<char>(a >> (8 * i) & 0xff);
    numbers[8 + i] = static_cast<char>(b >> (8 * i) & 0xff);
  }
  return crc32c(bytes, crc32c({numbers.data(), numbers.size()}));
}

Result<std::string> base_head_bytes(const Drawing& drawing) {
  std::string bytes;
  ByteWriter out(bytes);
  const Document& document = drawing.document;
  out.u64(document.new_id().value - 1);
  out.u64(document.new_layer_id().value - 1);
  out.u64(drawing.layer.value);
  out.u32(static_cast<std::uint32_t>(document.layers().size()));
  PicturesInBytes pictures;
  for (const Layer& layer : document.layers()) {
    const bool has_look = layer.opacity != 1.0 || layer.picture;
    out.u64(layer.id.value);
    out.text(utf8_prefix(layer.name, kMaxLayerNameBytes));
    out.u8(static_cast<std::uint8_t>((layer.own_visible ? kRowVisible : 0) |
                                     (layer.own_locked ? kRowLocked : 0) |
                                     (has_look ? kRowHasLook : 0) | flags_of_blend(layer.blend)));
    if (has_look) append_layer_look(out, layer.state(), nullptr, pictures);
  }
  if (auto ok = append_page(out, drawing); !ok) return tl::unexpected(ok.error());
  // Groups, guides, timings and names are last, because programs from before them ignore what
  // follows the page.
  for (const Layer& layer : document.layers()) append_layer_group(out, layer.group);
  if (auto ok = append_guides(out, drawing); !ok) return tl::unexpected(ok.error());
  if (auto ok = append_timings(out, drawing); !ok) return tl::unexpected(ok.error());
  append_names(out, drawing);
  return bytes;
}

Result<Drawing> read_base_head(std::string_view bytes) {
  ByteReader in(bytes);
  const StrokeId last_stroke{in.u64()};
  const LayerId last_layer{in.u64()}, in_use{in.u64()};
  Document document;
  Result<Edit> layers = read_layers(in, document);
  if (!layers) return tl::unexpected(layers.error());
  Result<Drawing> drawing = parse_felt(in.text(kMaxHeadBytes));
  if (!drawing) return drawing;
  read_groups(in, *layers);
  if (auto ok = document.apply(*layers); !ok) return tl::unexpected(ok.error());
  document.reserve_ids(last_stroke, last_layer);
  for (int part = 0; part < 2 && in.left() > 0; ++part) {  // guides, timings
    const Result<Edit> edit = read_edit_blob(in.text(kMaxHeadBytes), document);
    if (!edit) return tl::unexpected(edit.error());
    if (auto ok = document.apply(*edit); !ok) return tl::unexpected(ok.error());
  }
  auto names = read_names(in, document.new_id());
  if (!names) return tl::unexpected(names.error());
  drawing->names = *std::move(names);
  drawing->document = std::move(document);
  drawing->layer = drawing->document.layer(in_use) ? in_use : LayerId{};
  return drawing;
}

Result<std::string> base_run_bytes(const Document& document, const Layer& layer,
                                   std::size_t& index) {
  std::string strokes;
  ByteWriter out(strokes);
  std::uint32_t count = 0;
  for (; index < layer.strokes.size() && strokes.size() < kBasePartBytes; ++index, ++count) {
    std::string shape;
    const StrokeId id = layer.strokes[index];
    if (auto ok = append_stroke_blob(shape, *document.find(id)); !ok) {
      return tl::unexpected(ok.error());
    }
    out.u64(id.value);
    out.text(shape);
  }
  std::string fills;
  ByteWriter fills_out(fills);
  std::uint32_t fill_count = 0;
  const std::size_t first_fill = layer.strokes.size();
  for (; index >= first_fill && index < first_fill + layer.fills.size() &&
         strokes.size() + fills.size() < kBasePartBytes;
       ++index, ++fill_count) {
    std::string shape;
    const FillId id = layer.fills[index - first_fill];
    if (auto ok = append_fill_blob(shape, *document.find_fill(id)); !ok) {
      return tl::unexpected(ok.error());
    }
    fills_out.u64(id.value);
    fills_out.text(shape);
  }
  std::string bytes;
  ByteWriter head(bytes);
  head.u64(layer.id.value);
  head.u32(count);
  bytes += strokes;
  if (fill_count == 0) return bytes;
  head.u32(fill_count);
  return bytes += fills;
}

Result<BaseRun> read_base_run(std::string_view bytes) {
  ByteReader in(bytes);
  BaseRun run{{in.u64()}, {}, {}};
  const std::uint32_t count = in.u32();
  if (!in.has(count, kMinRunStrokeBytes)) return invalid_data("the list of strokes is incomplete");
  run.strokes.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const StrokeId id{in.u64()};
    Result<Stroke> stroke = read_stroke_blob(in.text(kMaxStrokeBlobBytes));
    if (!stroke) return tl::unexpected(stroke.error());
    run.strokes.emplace_back(id, std::make_shared<const Stroke>(*std::move(stroke)));
  }
  const std::uint32_t fills = in.left() > 0 ? in.u32() : 0;
  if (!in.has(fills, kMinRunStrokeBytes)) return invalid_data("the list of fills is incomplete");
  for (std::uint32_t i = 0; i < fills; ++i) {
    const FillId id{in.u64()};
    Result<FillPtr> fill = read_fill_blob(in.text(kMaxFillBlobBytes));
    if (!fill) return tl::unexpected(fill.error());
    run.fills.emplace_back(id, *std::move(fill));
  }
  if (!in.ok() || in.left() > 0) return invalid_data("the list of strokes is incomplete");
  return run;
}

Result<std::string> info_bytes(const AutosaveInfo& info) {
  std::string bytes;
  ByteWriter out(bytes);
  out.text(std::string_view(info.name).substr(0, kMaxTextBytes));
  out.text(std::string_view(info.path).substr(0, kMaxTextBytes));
  out.u8(info.modified ? 1 : 0);
  out.u64(info.head.layer.value);
  if (auto ok = append_page(out, info.head); !ok) return tl::unexpected(ok.error());
  out.u8(info.has_extras.value_or(info.head.extras != nullptr) ? 1 : 0);
  out.u8(info.stamp ? 1 : 0);
  if (!info.stamp) return bytes;
  out.u64(info.stamp->bytes);
  out.u64(static_cast<std::uint64_t>(info.stamp->changed_at_ns));
  return bytes;
}

Result<AutosaveInfo> read_info(std::string_view bytes) {
  ByteReader in(bytes);
  AutosaveInfo info;
  info.name = std::string(in.text(kMaxTextBytes));
  info.path = std::string(in.text(kMaxTextBytes));
  info.modified = in.u8() != 0;
  const LayerId layer{in.u64()};
  Result<Drawing> head = parse_felt(in.text(kMaxHeadBytes));
  if (!head) return tl::unexpected(head.error());
  info.head = *std::move(head);
  info.head.layer = layer;
  if (!in.has(1, 2)) return info;
  info.has_extras = in.u8() != 0;
  if (in.u8() == 0 || !in.has(1, 16)) return info;
  info.stamp.emplace();
  info.stamp->bytes = in.u64();
  info.stamp->changed_at_ns = static_cast<std::int64_t>(in.u64());
  return info;
}

}  // namespace felt
