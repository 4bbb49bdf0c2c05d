#include "felt/autosave/edit_blob.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "felt/autosave/layer_look.h"
#include "felt/base/utf8.h"
#include "felt/store/body_edit_table.h"
#include "felt/store/byte_writer.h"
#include "felt/store/fill_blob.h"
#include "felt/store/guide_table.h"
#include "felt/store/key_timing_table.h"
#include "felt/store/stroke_blob.h"

namespace felt {
namespace {

constexpr std::uint8_t kVersion = 1;
constexpr std::uint8_t kVersionWithFills = 2;
constexpr std::uint8_t kVersionWithGroups = 3;  // has the groups of all changed layers at its end
constexpr std::uint8_t kVersionWithGuides = 4;  // has groups as in 3, and then guides
// has guides as in 4, the timings of all changed layers, and then edits of the body
constexpr std::uint8_t kVersionWithTimings = 5;
constexpr std::size_t kMaxUnplacedBytes = std::size_t{1} << 20;
static_assert(kMaxBodyEditBytes < kMaxUnplacedBytes);
constexpr std::size_t kMaxLabelBytes = 4096;
constexpr std::size_t kMaxNameBytes = 1 << 16;  // older programs wrote names without a limit
constexpr std::uint8_t kIsThere = 1, kVisible = 2, kLocked = 4, kHasLook = 8;  // flags
constexpr std::size_t kMinChangeBytes = 9;

Result<void> write_stroke(ByteWriter& out, const StrokeChange& c) {
  out.u64(c.id.value);
  out.u8(c.after ? kIsThere : 0);
  if (!c.after) return {};
  std::string shape;
  if (auto ok = append_stroke_blob(shape, *c.after); !ok) return ok;
  out.u64(c.after_place.layer.value);
  out.u64(c.after_place.index);
  out.text(shape);
  return {};
}

Result<void> write_fill(ByteWriter& out, const FillChange& c) {
  out.u64(c.id.value);
  out.u8(c.after ? kIsThere : 0);
  if (!c.after) return {};
  std::string shape;
  if (auto ok = append_fill_blob(shape, *c.after); !ok) return ok;
  out.u64(c.after_place.layer.value);
  out.u64(c.after_place.index);
  out.text(shape);
  return {};
}

/// Writes the changes of guides or of symmetry groups.
template <class Change, class Append>
Result<void> write_unplaced(ByteWriter& out, const std::vector<Change>& changes, Append append) {
  out.u32(static_cast<std::uint32_t>(changes.size()));
  for (const Change& c : changes) {
    out.u64(c.id.value);
    std::string bytes;
    if (c.after) {
      if (auto ok = append(bytes, *c.after); !ok) return ok;
    }
    out.text(bytes);  // empty: removed
  }
  return {};
}

template <class Change, class Read>
Result<void> read_unplaced(ByteReader& in, std::vector<Change>& changes, Read read) {
  const std::uint32_t count = in.u32();
  if (!in.has(count, kMinChangeBytes)) return invalid_data("the edit is incomplete");
  for (std::uint32_t i = 0; i < count; ++i) {
    Change c;
    c.id = {in.u64()};
    const std::string_view bytes = in.text(kMaxUnplacedBytes);
    if (!in.ok()) return invalid_data("the edit ends in the middle of an object");
    if (!bytes.empty()) {
      auto after = read(bytes);
      if (!after) return tl::unexpected(with_context(after.error(), "object"));
      c.after = *std::move(after);
    }
    changes.push_back(std::move(c));
  }
  return {};
}

Result<void> write_guides_part(ByteWriter& out, const Edit& edit) {
  out.u8(edit.toggles_guides ? 1 : 0);
  return write_unplaced(out, edit.guides, append_guide_blob).and_then([&] {
    return write_unplaced(out, edit.symmetries, append_symmetry_blob);
  });
}

Result<void> read_guides_part(ByteReader& in, Edit& edit) {
  edit.toggles_guides = in.u8() != 0;
  return read_unplaced(in, edit.guides, read_guide_blob).and_then([&] {
    return read_unplaced(in, edit.symmetries, read_symmetry_blob);
  });
}

bool has_guides_part(const Edit& edit) noexcept {
  return edit.toggles_guides || !edit.guides.empty() || !edit.symmetries.empty();
}

/// Appends an edit of the body with its kind. Fails, and appends nothing, if it is not valid.
Result<void> append_body_edit(std::string& out, const BodyEdit& edit) {
  std::string shape;
  if (auto ok = append_body_edit_blob(shape, edit); !ok) return ok;
  ByteWriter(out).text(body_edit_kind_name(edit.kind));
  out += shape;
  return {};
}

Result<BodyEditPtr> read_body_edit(std::string_view bytes) {
  ByteReader in(bytes);
  const std::string_view kind = in.text(kMaxLabelBytes);
  return read_body_edit_blob(kind, in.bytes(in.left()));
}

/// Writes the timings of the changed layers and the edits of the body.
Result<void> write_timings_part(ByteWriter& out, const Edit& edit) {
  for (const LayerChange& c : edit.layers) {
    std::string bytes;
    if (c.after && c.after->timing) {
      if (auto ok = append_key_timing_blob(bytes, *c.after->timing); !ok) return ok;
    }
    out.text(bytes);  // empty: none
  }
  return write_unplaced(out, edit.body_edits, append_body_edit);
}

Result<void> read_timings_part(ByteReader& in, Edit& edit) {
  for (LayerChange& c : edit.layers) {
    const std::string_view bytes = in.text(kMaxKeyTimingBytes);
    if (!in.ok()) return invalid_data("the edit ends in the middle of a layer");
    if (bytes.empty() || !c.after) continue;
    Result<KeyTimingPtr> timing = read_key_timing_blob(bytes);
    if (!timing) return tl::unexpected(with_context(timing.error(), "timing"));
    c.after->timing = *std::move(timing);
  }
  return read_unplaced(in, edit.body_edits, read_body_edit);
}

bool has_timings_part(const Edit& edit) noexcept {
  return !edit.body_edits.empty() ||
         std::any_of(edit.layers.begin(), edit.layers.end(),
                     [](const LayerChange& c) { return c.after && c.after->timing; });
}

void write_layer(ByteWriter& out, const LayerChange& c, PicturesInBytes& pictures) {
  out.u64(c.id.value);
  if (!c.after) {
    out.u8(0);
    return;
  }
  const bool has_look = c.after->opacity != 1.0 || c.after->picture;
  out.u8(static_cast<std::uint8_t>(kIsThere | (c.after->visible ? kVisible : 0) |
                                   (c.after->locked ? kLocked : 0) | (has_look ? kHasLook : 0) |
                                   flags_of_blend(c.after->blend)));
  out.u64(c.after_index);
  out.text(utf8_prefix(c.after->name, kMaxLayerNameBytes));
  const LayerPicture* before = c.before ? c.before->picture.get() : nullptr;
  if (!has_look) return;
  append_layer_look(out, *c.after, before ? before->data.get() : nullptr, pictures);
}

Result<StrokeChange> read_stroke(ByteReader& in) {
  StrokeChange c;
  c.id = {in.u64()};
  if (in.u8() == 0) return c;
  c.after_place.layer = {in.u64()};
  c.after_place.index = in.u64();
  const std::string_view shape = in.text(kMaxStrokeBlobBytes);
  if (!in.ok()) return invalid_data("the edit ends in the middle of a stroke");
  Result<Stroke> stroke = read_stroke_blob(shape);
  if (!stroke) return tl::unexpected(with_context(stroke.error(), "stroke"));
  c.after = std::make_shared<const Stroke>(*std::move(stroke));
  return c;
}

Result<FillChange> read_fill(ByteReader& in) {
  FillChange c;
  c.id = {in.u64()};
  if (in.u8() == 0) return c;
  c.after_place.layer = {in.u64()};
  c.after_place.index = in.u64();
  const std::string_view shape = in.text(kMaxFillBlobBytes);
  if (!in.ok()) return invalid_data("the edit ends in the middle of a fill");
  Result<FillPtr> fill = read_fill_blob(shape);
  if (!fill) return tl::unexpected(with_context(fill.error(), "fill"));
  c.after = *std::move(fill);
  return c;
}

LayerChange read_layer(ByteReader& in, const Document& document, PicturesInBytes& pictures) {
  LayerChange c;
  c.id = {in.u64()};
  const std::uint8_t flags = in.u8();
  if (flags == 0) return c;
  c.after_index = in.u64();
  c.after = LayerState{std::string(utf8_prefix(in.text(kMaxNameBytes), kMaxLayerNameBytes)),
                       (flags & kVisible) != 0, (flags & kLocked) != 0};
  c.after->blend = blend_of_flags(flags);
  if ((flags & kHasLook) == 0) return c;
  const Layer* before = document.layer(c.id);
  read_layer_look(in, *c.after, before && before->picture ? before->picture->data : nullptr,
                  pictures);
  return c;
}

/// Fills in the current positions of the strokes that change. If many strokes change, walks over
/// all layers once; if only a few change, looks up each stroke.
Result<void> find_strokes(const Document& document, std::vector<StrokeChange>& changes) {
  constexpr std::size_t kFew = 8;
  std::unordered_map<std::uint64_t, StrokePlace> places;
  if (changes.size() > kFew) {
    for (const Layer& layer : document.layers()) {
      for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
        places[layer.strokes[i].value] = {layer.id, i};
      }
    }
  }
  for (StrokeChange& c : changes) {
    c.before = document.find(c.id);
    if (!c.before && !c.after) return invalid_data("the edit removes a stroke that does not exist");
    if (!c.before) continue;
    c.before_place = places.empty() ? document.place(c.id) : places[c.id.value];
  }
  return {};
}

Result<void> find_fills(const Document& document, std::vector<FillChange>& changes) {
  for (FillChange& c : changes) {
    c.before = document.find_fill(c.id);
    if (!c.before && !c.after) return invalid_data("the edit removes a fill that does not exist");
    if (c.before) c.before_place = document.fill_place(c.id);
  }
  return {};
}

Result<void> find_layers(const Document& document, std::vector<LayerChange>& changes) {
  const std::span<const Layer> layers = document.layers();
  for (LayerChange& c : changes) {
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&c](const Layer& layer) { return layer.id == c.id; });
    if (found == layers.end() && !c.after) {
      return invalid_data("the edit removes a layer that does not exist");
    }
    if (found == layers.end()) continue;
    c.before = found->state();
    c.before_index = static_cast<std::size_t>(found - layers.begin());
  }
  return {};
}

}  // namespace

namespace {

bool has_groups(const Edit& edit) {
  return std::any_of(edit.layers.begin(), edit.layers.end(),
                     [](const LayerChange& c) { return c.after && c.after->group; });
}

}  // namespace

Result<void> append_edit_blob(std::string& out, const Edit& edit) {
  ByteWriter writer(out);
  const bool with_timings = has_timings_part(edit);
  const bool with_guides = with_timings || has_guides_part(edit);
  const bool with_groups = with_guides || has_groups(edit);
  const bool with_fills = with_groups || !edit.fills.empty();
  writer.u8(with_timings  ? kVersionWithTimings
            : with_guides ? kVersionWithGuides
            : with_groups ? kVersionWithGroups
            : with_fills  ? kVersionWithFills
                          : kVersion);
  writer.text(utf8_prefix(edit.label, kMaxLabelBytes));
  writer.u32(static_cast<std::uint32_t>(edit.layers.size()));
  PicturesInBytes pictures;
  for (const LayerChange& c : edit.layers) write_layer(writer, c, pictures);
  writer.u32(static_cast<std::uint32_t>(edit.changes.size()));
  for (const StrokeChange& c : edit.changes) {
    if (auto ok = write_stroke(writer, c); !ok) return ok;
  }
  if (!with_fills) return {};
  writer.u32(static_cast<std::uint32_t>(edit.fills.size()));
  for (const FillChange& c : edit.fills) {
    if (auto ok = write_fill(writer, c); !ok) return ok;
  }
  if (!with_groups) return {};
  for (const LayerChange& c : edit.layers) {
    append_layer_group(writer, c.after ? c.after->group : nullptr);
  }
  if (!with_guides) return {};
  if (auto ok = write_guides_part(writer, edit); !ok) return ok;
  return with_timings ? write_timings_part(writer, edit) : Result<void>();
}

namespace {

/// Parses the bytes. The state before the edit is not filled in, but pictures that the edit keeps
/// come from the document.
Result<Edit> parse(std::string_view bytes, const Document& document) {
  ByteReader in(bytes);
  const std::uint8_t version = in.u8();
  if (version < kVersion || version > kVersionWithTimings)
    return invalid_data("the edit has an unknown version");
  Edit edit;
  edit.label = std::string(in.text(kMaxLabelBytes));
  const std::uint32_t layers = in.u32();
  if (!in.has(layers, kMinChangeBytes)) return invalid_data("the edit is incomplete");
  PicturesInBytes pictures;
  for (std::uint32_t i = 0; i < layers; ++i) {
    edit.layers.push_back(read_layer(in, document, pictures));
  }
  const std::uint32_t strokes = in.u32();
  if (!in.has(strokes, kMinChangeBytes)) return invalid_data("the edit is incomplete");
  edit.changes.reserve(strokes);
  for (std::uint32_t i = 0; i < strokes; ++i) {
    Result<StrokeChange> change = read_stroke(in);
    if (!change) return tl::unexpected(change.error());
    edit.changes.push_back(*std::move(change));
  }
  const std::uint32_t fills = version >= kVersionWithFills ? in.u32() : 0;
  if (!in.has(fills, kMinChangeBytes)) return invalid_data("the edit is incomplete");
  for (std::uint32_t i = 0; i < fills; ++i) {
    Result<FillChange> change = read_fill(in);
    if (!change) return tl::unexpected(change.error());
    edit.fills.push_back(*std::move(change));
  }
  for (std::size_t i = 0; version >= kVersionWithGroups && i < edit.layers.size(); ++i) {
    const LayerGroupPtr group = read_layer_group(in);
    if (edit.layers[i].after) edit.layers[i].after->group = group;
  }
  if (version >= kVersionWithGuides) {
    if (auto ok = read_guides_part(in, edit); !ok) return tl::unexpected(ok.error());
  }
  if (version >= kVersionWithTimings) {
    if (auto ok = read_timings_part(in, edit); !ok) return tl::unexpected(ok.error());
  }
  if (!in.ok() || in.left() > 0)
    return invalid_data("the edit does not have the length that it states");
  return edit;
}

/// Applies one change as a separate edit, and adapts it to the document if necessary.
void force(StrokeChange change, Document& document) {
  change.before = document.find(change.id);
  if (!change.before && !change.after) return;
  if (change.before) change.before_place = document.place(change.id);
  if (change.after && change.before) {
    change.after_place = change.before_place;
  } else if (change.after) {
    const Layer* layer = document.layer(change.after_place.layer);
    if (!layer) layer = &document.layers().back();
    change.after_place = {layer->id, layer->strokes.size()};
  }
  Edit edit;
  edit.changes.push_back(std::move(change));
  static_cast<void>(document.apply(edit));
}

void force(FillChange change, Document& document) {
  change.before = document.find_fill(change.id);
  if (!change.before && !change.after) return;
  if (change.before) change.before_place = document.fill_place(change.id);
  if (change.after && change.before) {
    change.after_place = change.before_place;
  } else if (change.after) {
    const Layer* layer = document.layer(change.after_place.layer);
    if (!layer) layer = &document.layers().back();
    change.after_place = {layer->id, layer->fills.size()};
  }
  Edit edit;
  edit.fills.push_back(std::move(change));
  static_cast<void>(document.apply(edit));
}

/// Applies the changes of guides, symmetry groups and edits of the body as far as they fit.
void force_unplaced(const Edit& blob, Document& document) {
  Edit edit;
  edit.toggles_guides = blob.toggles_guides;
  for (GuideChange c : blob.guides) {
    c.before = document.find_guide(c.id);
    if (c.before || c.after) edit.guides.push_back(std::move(c));
  }
  for (SymmetryChange c : blob.symmetries) {
    c.before = document.find_symmetry(c.id);
    if (c.before || c.after) edit.symmetries.push_back(std::move(c));
  }
  static_cast<void>(document.apply(edit));
  Edit body;
  for (BodyEditChange c : blob.body_edits) {
    c.before = document.find_body_edit(c.id);
    if (c.before || c.after) body.body_edits.push_back(std::move(c));
  }
  static_cast<void>(document.apply(body));
}

/// Fills in the guides, symmetry groups and edits of the body before the edit.
Result<void> find_unplaced(const Document& document, Edit& edit) {
  for (GuideChange& c : edit.guides) c.before = document.find_guide(c.id);
  for (SymmetryChange& c : edit.symmetries) c.before = document.find_symmetry(c.id);
  for (BodyEditChange& c : edit.body_edits) c.before = document.find_body_edit(c.id);
  const auto is_unknown = [](const auto& c) { return !c.before && !c.after; };
  if (std::any_of(edit.guides.begin(), edit.guides.end(), is_unknown) ||
      std::any_of(edit.symmetries.begin(), edit.symmetries.end(), is_unknown)) {
    return invalid_data("the edit removes a guide that does not exist");
  }
  if (std::any_of(edit.body_edits.begin(), edit.body_edits.end(), is_unknown)) {
    return invalid_data("the edit removes an edit of the body that does not exist");
  }
  return {};
}

}  // namespace

Result<Edit> read_edit_blob(std::string_view bytes, const Document& document) {
  Result<Edit> edit = parse(bytes, document);
  if (!edit) return edit;
  if (auto ok = find_strokes(document, edit->changes); !ok) return tl::unexpected(ok.error());
  if (auto ok = find_fills(document, edit->fills); !ok) return tl::unexpected(ok.error());
  if (auto ok = find_layers(document, edit->layers); !ok) return tl::unexpected(ok.error());
  if (auto ok = find_unplaced(document, *edit); !ok) return tl::unexpected(ok.error());
  return edit;
}

Result<void> apply_what_fits(std::string_view bytes, Document& document) {
  Result<Edit> edit = parse(bytes, document);
  if (!edit) return tl::unexpected(edit.error());
  for (const LayerChange& change : edit->layers) {
    if (!change.after || document.layer(change.id)) continue;
    Edit add;
    add.layers.push_back({change.id, std::nullopt, change.after, 0, document.layers().size()});
    add.layers.back().after->group = nullptr;  // the others of its group may be elsewhere
    static_cast<void>(document.apply(add));
  }
  for (StrokeChange& change : edit->changes) force(std::move(change), document);
  for (FillChange& change : edit->fills) force(std::move(change), document);
  force_unplaced(*edit, document);
  return {};
}

}  // namespace felt
