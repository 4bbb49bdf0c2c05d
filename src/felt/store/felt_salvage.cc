#include "felt/store/felt_salvage.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "felt/base/read_file.h"
#include "felt/base/utf8.h"
#include "felt/io/limits.h"
#include "felt/io/xml/material_texts.h"
#include "felt/store/body_edit_table.h"
#include "felt/store/felt_page.h"
#include "felt/store/felt_tables.h"
#include "felt/store/fill_blob.h"
#include "felt/store/fill_table.h"
#include "felt/store/guide_table.h"
#include "felt/store/key_timing_table.h"
#include "felt/store/layer_group_table.h"
#include "felt/store/layer_look_table.h"
#include "felt/store/material_table.h"
#include "felt/store/page_scan.h"
#include "felt/store/stroke_blob.h"
#include "felt/store/stroke_name_table.h"

namespace felt {
namespace {

using Value = ScannedRow::Value;

bool is_none(const Value& v) noexcept {
  return std::holds_alternative<std::monostate>(v);
}
std::optional<std::int64_t> whole(const Value& v) noexcept {
  const auto* n = std::get_if<std::int64_t>(&v);
  return n ? std::optional(*n) : std::nullopt;
}
/// Returns a number as a double. SQLite stores a whole double as an integer.
std::optional<double> number(const Value& v) noexcept {
  if (const auto* x = std::get_if<double>(&v)) return *x;
  const auto n = whole(v);
  return n ? std::optional(static_cast<double>(*n)) : std::nullopt;
}
const std::string* text(const Value& v) noexcept {
  const auto* bytes = std::get_if<ScannedRow::Bytes>(&v);
  return bytes && bytes->is_text ? &bytes->value : nullptr;
}
const std::string* blob(const Value& v) noexcept {
  const auto* bytes = std::get_if<ScannedRow::Bytes>(&v);
  return bytes && !bytes->is_text ? &bytes->value : nullptr;
}
/// First of the new ids for strokes and fills whose own id belongs to another one, too.
constexpr std::int64_t kStrayIds = std::int64_t{1} << 40;

/// Collects rows. Recognises the table of a row by the types of its values, because it is not known
/// which page belongs to which table.
class Findings {
 public:
  void take(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.empty() || !is_none(v[0]) || !is_id(row.id)) return;
    if (take_stroke(row) || take_fill(row) || take_layer(row) || take_drawing(row) ||
        take_view(row))
      return;
    if (take_guide(row) || take_symmetry(row) || take_material(row)) return;
    if (take_opacity(row) || take_picture(row) || salvage_stroke_name(row, names)) return;
    if (take_blend(row) || take_group(row) || take_timing(row) || take_body_edit(row)) return;
    if (!take_color(row)) ++others;
  }

  template <class T>
  struct Found {
    std::shared_ptr<const T> object;
    std::int64_t layer = 0, place = 0;
  };
  struct FoundLayer {
    LayerState state;
    std::int64_t place = 0;
  };
  std::map<std::int64_t, Found<Stroke>> strokes;
  std::map<std::int64_t, Found<Fill>> fills;
  std::map<std::int64_t, FoundLayer> layers;
  std::map<std::int64_t, double> opacities;                                  // by layer
  std::map<std::int64_t, LayerPicturePtr> pictures;                          // by layer
  std::map<std::int64_t, std::shared_ptr<const PictureData>> picture_files;  // by row
  std::vector<std::pair<std::int64_t, PictureRow>> repeats;  // layers and rows without a file
  std::map<std::int64_t, BlendMode> blends;                  // by layer
  std::map<std::int64_t, LayerGroupPtr> groups;              // by layer
  std::map<std::int64_t, KeyTimingPtr> timings;              // by layer
  std::map<std::int64_t, DrawingGuidePtr> guides;
  std::map<std::int64_t, BodyEditPtr> body_edits;
  std::map<std::int64_t, SymmetryPtr> symmetries;
  bool hides_guides = false;
  std::map<std::int64_t, NamedColor> colors;
  std::optional<Drawing> head;  // without the document and the palette's colours
  std::optional<Viewport> view;
  std::map<std::int64_t, std::string> materials;
  StrokeNames names;
  std::int64_t last_stroke = 0, last_layer = 0;
  std::size_t others = 0;

 private:
  std::int64_t next_stray_ = kStrayIds;

  /// Returns true if the row has the first columns of a stroke or of a fill.
  static bool has_shape(const ScannedRow& row) {
    const auto& v = row.values;
    return v.size() >= 4 && whole(v[1]) && whole(v[2]) && blob(v[3]) && is_id(*whole(v[1])) &&
           *whole(v[2]) >= 0 && *whole(v[2]) <= kMaxId;
  }

  template <class T>
  void keep(const ScannedRow& row, std::shared_ptr<const T> object,
            std::map<std::int64_t, Found<T>>& found) {
    std::int64_t id = row.id;
    if (const auto there = found.find(id); there != found.end()) {
      if (*there->second.object == *object) return;
      // One of the two ids is damaged, but both objects are intact, so this one gets a new id.
      while (found.contains(next_stray_)) ++next_stray_;
      id = next_stray_++;
    }
    found[id] = {std::move(object), *whole(row.values[1]), *whole(row.values[2])};
  }

  bool take_stroke(const ScannedRow& row) {
    if (!has_shape(row)) return false;
    Result<Stroke> stroke = read_stroke_blob(*blob(row.values[3]));
    if (!stroke) return false;
    keep(row, std::make_shared<const Stroke>(*std::move(stroke)), strokes);
    return true;
  }
  bool take_fill(const ScannedRow& row) {
    const auto& v = row.values;
    if (!has_shape(row) || v.size() != 5 || !whole(v[4])) return false;
    const std::string& shape = *blob(v[3]);
    if (*whole(v[4]) != fill_checksum(row.id, *whole(v[1]), *whole(v[2]), shape)) return false;
    Result<FillPtr> fill = read_fill_blob(shape);
    if (!fill) return false;
    keep(row, *std::move(fill), fills);
    return true;
  }
  bool take_layer(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() < 5 || !whole(v[1]) || !text(v[2]) || !whole(v[3]) || !whole(v[4])) return false;
    const std::string& name = *text(v[2]);
    if ((*whole(v[3]) | 1) != 1 || (*whole(v[4]) | 1) != 1) return false;
    if (name.size() > kMaxLayerNameBytes || !is_utf8(name)) return false;
    if (layers.size() < kMaxLayers) {
      layers.try_emplace(row.id,
                         FoundLayer{{name, *whole(v[3]) == 1, *whole(v[4]) == 1}, *whole(v[1])});
    }
    return true;
  }
  bool take_drawing(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() < 12 || row.id != 1 || !number(v[1]) || !number(v[2]) || !text(v[4]) ||
        !text(v[9])) {
      return false;
    }
    for (const std::size_t i : {3U, 5U, 6U, 7U, 8U, 10U, 11U}) {
      if (!whole(v[i]) || *whole(v[i]) < 0 || *whole(v[i]) > kMaxId) return false;
    }
    Drawing found;
    found.page = {*number(v[1]), *number(v[2]), color_of(*whole(v[3])), *text(v[4])};
    found.color = color_of(*whole(v[5]));
    found.layer = {static_cast<std::uint64_t>(*whole(v[6]))};
    found.palette.name = *text(v[9]);
    found.palette.columns = static_cast<std::size_t>(*whole(v[10]));
    const auto is_side = [](double mm) { return mm >= Page::kMinMm && mm <= Page::kMaxMm; };
    if (!is_side(found.page.width_mm) || !is_side(found.page.height_mm) || head ||
        found.page.surface.size() > kMaxLayerNameBytes || !is_utf8(found.page.surface)) {
      return true;
    }
    head = std::move(found);
    last_stroke = *whole(v[7]);
    last_layer = *whole(v[8]);
    return true;
  }
  bool take_view(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 6 || row.id != 1 || !whole(v[5])) return false;
    for (const std::size_t i : {1U, 2U, 3U, 4U}) {
      if (!number(v[i])) return false;
    }
    view =
        Viewport{{*number(v[1]), *number(v[2])}, *number(v[3]), *number(v[4]), *whole(v[5]) == 1};
    return true;
  }
  bool take_material(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 3 || !text(v[1]) || !whole(v[2])) return false;
    if (!is_material_text(*text(v[1])) || material_checksum(*text(v[1])) != *whole(v[2])) {
      return false;
    }
    if (materials.size() < limits::kMaxMaterialTexts) materials.try_emplace(row.id, *text(v[1]));
    return true;
  }
  bool take_opacity(const ScannedRow& row) {
    const auto& v = row.values;
    // Not an integer, which other tables could have there. An opacity of exactly 0 is stored as one
    // and is lost, so the layer becomes visible.
    const auto* opacity = v.size() == 3 ? std::get_if<double>(&v[2]) : nullptr;
    if (!opacity || !whole(v[1]) || !is_id(*whole(v[1]))) return false;
    if (!(*opacity >= 0.0 && *opacity <= 1.0)) return false;
    if (opacities.size() < kMaxLayers) opacities.try_emplace(*whole(v[1]), *opacity);
    return true;
  }
  bool take_picture(const ScannedRow& row) {
    const auto& v = row.values;
    const bool has_types = v.size() == 11 && whole(v[1]) && is_id(*whole(v[1])) && whole(v[8]) &&
                           (blob(v[9]) || whole(v[9])) && whole(v[10]);
    if (!has_types) return false;
    PictureRow values{.exported = *whole(v[8]), .data = nullptr, .checksum = *whole(v[10])};
    for (std::size_t i = 0; i < values.place.size(); ++i) {
      if (!number(v[i + 2])) return false;
      values.place[i] = *number(v[i + 2]);
    }
    if (whole(v[9])) {
      values.same_as = *whole(v[9]);
      if (repeats.size() < kMaxLayers) repeats.emplace_back(*whole(v[1]), std::move(values));
      return true;
    }
    values.data = make_picture_data(*blob(v[9])).value_or(nullptr);
    LayerPicturePtr picture = picture_of_row(values);
    if (!picture) return false;
    if (pictures.size() < kMaxLayers) {
      picture_files.try_emplace(row.id, values.data);
      pictures.try_emplace(*whole(v[1]), std::move(picture));
    }
    return true;
  }
  bool take_blend(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 3 || !text(v[1]) || !whole(v[2]) || !is_id(*whole(v[2]))) return false;
    const auto mode = blend_mode_of(*text(v[1]));
    if (mode && blends.size() < kMaxLayers) blends.try_emplace(*whole(v[2]), *mode);
    return mode.has_value();
  }
  bool take_group(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 8 || !whole(v[1]) || !is_id(*whole(v[1])) || !whole(v[2]) || !text(v[3]) ||
        !whole(v[4]) || !whole(v[5]) || !number(v[6]) || !text(v[7])) {
      return false;
    }
    const LayerGroupPtr group = group_of_row(*whole(v[2]), *text(v[3]), *whole(v[4]), *whole(v[5]),
                                             *number(v[6]), *text(v[7]));
    if (group && groups.size() < kMaxLayers) groups.try_emplace(*whole(v[1]), group);
    return group != nullptr;
  }
  bool take_timing(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 4 || !blob(v[1]) || !whole(v[2]) || !is_id(*whole(v[2])) || !whole(v[3])) {
      return false;
    }
    if (*whole(v[3]) != key_timing_checksum(*whole(v[2]), *blob(v[1]))) return false;
    Result<KeyTimingPtr> timing = read_key_timing_blob(*blob(v[1]));
    if (!timing) return false;
    if (timings.size() < kMaxLayers) timings.try_emplace(*whole(v[2]), *std::move(timing));
    return true;
  }
  bool take_body_edit(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 4 || !text(v[1]) || !blob(v[2]) || !whole(v[3])) return false;
    if (*whole(v[3]) != body_edit_checksum(row.id, *text(v[1]), *blob(v[2]))) return false;
    Result<BodyEditPtr> edit = read_body_edit_blob(*text(v[1]), *blob(v[2]));
    if (!edit) return false;
    if (body_edits.size() < kMaxBodyEdits) body_edits.try_emplace(row.id, *std::move(edit));
    return true;
  }
  bool take_guide(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 4 || !whole(v[1]) || !blob(v[2]) || !whole(v[3])) return false;
    if (*whole(v[3]) != guide_checksum(row.id, *whole(v[1]), *blob(v[2]))) return false;
    Result<DrawingGuidePtr> guide = read_guide_blob(*blob(v[2]));
    if (!guide) return false;
    hides_guides = *whole(v[1]) == 0;
    if (guides.size() < kMaxStoredGuides) guides.try_emplace(row.id, *std::move(guide));
    return true;
  }
  bool take_symmetry(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 3 || !blob(v[1]) || !whole(v[2])) return false;
    if (*whole(v[2]) != guide_checksum(row.id, 0, *blob(v[1]))) return false;
    Result<SymmetryPtr> group = read_symmetry_blob(*blob(v[1]));
    if (!group) return false;
    if (symmetries.size() < kMaxStoredSymmetries) {
      symmetries.try_emplace(row.id, *std::move(group));
    }
    return true;
  }
  bool take_color(const ScannedRow& row) {
    const auto& v = row.values;
    if (v.size() != 3 || !whole(v[1]) || !is_color_number(*whole(v[1])) || !text(v[2])) {
      return false;
    }
    if (colors.size() < PaletteLimits::kMaxColors) {
      colors.try_emplace(row.id, NamedColor{color_of(*whole(v[1])), *text(v[2])});
    }
    return true;
  }
};

/// Makes a drawing from what was found.
class Assembly {
 public:
  explicit Assembly(Findings findings) : found_(std::move(findings)) {}

  Result<Salvaged> make(const std::string& why) {
    if (found_.strokes.empty() && found_.fills.empty() && found_.layers.empty() &&
        found_.pictures.empty()) {
      return fail(ErrorCode::kInvalidData, why + "; it does not contain any part of a drawing");
    }
    out_.problems.push_back("The file " + why + ".");
    take_head();
    take_repeated_pictures();
    name_lost_layers();
    set_layer_looks();
    if (auto ok = fill(); !ok) return tl::unexpected(ok.error());
    take_rest();
    return std::move(out_);
  }

 private:
  void take_head() {
    if (found_.head) {
      out_.drawing = *std::move(found_.head);
      return;
    }
    out_.problems.emplace_back(
        "The page size, the paper colour, the surface and the colour of new ink are lost; the "
        "defaults of a new drawing were used.");
  }

  /// Gives the rows that only name the row of their picture its file, if that was found.
  void take_repeated_pictures() {
    for (auto& [layer, row] : found_.repeats) {
      const auto file = found_.picture_files.find(row.same_as);
      if (file != found_.picture_files.end()) row.data = file->second;
      const LayerPicturePtr picture = picture_of_row(row);
      if (picture && found_.pictures.size() < kMaxLayers) {
        found_.pictures.try_emplace(layer, picture);
      } else {
        ++found_.others;
      }
    }
  }

  void name_lost_layers() {
    std::size_t lost = 0;
    const auto name_layer = [&](std::int64_t& layer) {
      if (found_.layers.contains(layer)) return;
      if (found_.layers.size() == kMaxLayers) {
        layer = found_.layers.rbegin()->first;
        return;
      }
      found_.layers[layer] = {{"Salvaged " + std::to_string(++lost), true, false}, kMaxId};
    };
    for (auto& [id, stroke] : found_.strokes) name_layer(stroke.layer);
    for (auto& [id, fill] : found_.fills) name_layer(fill.layer);
    for (const auto& [id, picture] : found_.pictures) {
      std::int64_t layer = id;
      name_layer(layer);
    }
    if (lost == 0) return;
    out_.problems.push_back(
        lost == 1 ? "A layer lost its name and position; it was put on top."
                  : std::to_string(lost) +
                        " layers lost their names and positions; they were put on top.");
  }

  /// Gives the layers their opacities, pictures, blend modes, groups and timings.
  void set_layer_looks() {
    const auto set = [](const auto& found, std::int64_t id, auto& value) {
      if (const auto at = found.find(id); at != found.end()) value = at->second;
    };
    for (auto& [id, layer] : found_.layers) {
      set(found_.opacities, id, layer.state.opacity);
      set(found_.pictures, id, layer.state.picture);
      set(found_.blends, id, layer.state.blend);
      set(found_.groups, id, layer.state.group);
      set(found_.timings, id, layer.state.timing);
    }
  }

  Result<void> fill() {
    std::vector<std::int64_t> order;
    for (const auto& [id, layer] : found_.layers) order.push_back(id);
    std::sort(order.begin(), order.end(), [this](std::int64_t a, std::int64_t b) {
      return std::pair(found_.layers[a].place, a) < std::pair(found_.layers[b].place, b);
    });
    Edit edit;
    edit.label = "Salvage";
    Document& document = out_.drawing.document;
    const Layer& first = document.layers().front();
    edit.layers.push_back({first.id, first.state(), std::nullopt, 0, 0});
    for (std::size_t i = 0; i < order.size(); ++i) {
      const LayerState& state = found_.layers[order[i]].state;
      const LayerId id{static_cast<std::uint64_t>(order[i])};
      if (id == first.id) {
        edit.layers.front().after = state;
        edit.layers.front().after_index = i;
      } else {
        edit.layers.push_back({id, std::nullopt, state, 0, i});
      }
    }
    separate_groups_of(edit);
    place(found_.strokes, edit.changes, " stroke");
    place(found_.fills, edit.fills, " fill");
    for (const auto& [id, guide] : found_.guides) {
      if (edit.guides.size() == kMaxDrawingGuides) {
        out_.problems.push_back(too_many_guides(found_.guides.size()));
        break;
      }
      edit.guides.push_back({{static_cast<std::uint64_t>(id)}, nullptr, guide});
    }
    for (const auto& [id, group] : found_.symmetries) {
      edit.symmetries.push_back({{static_cast<std::uint64_t>(id)}, nullptr, group});
    }
    for (const auto& [id, body_edit] : found_.body_edits) {
      edit.body_edits.push_back({{static_cast<std::uint64_t>(id)}, nullptr, body_edit});
    }
    edit.toggles_guides = found_.hides_guides;
    return document.apply(edit);
  }

  /// Places in a layer are consecutive, so gaps below the highest place show the minimum number of
  /// strokes or fills that are missing.
  template <class T, class Change>
  void place(std::map<std::int64_t, Findings::Found<T>>& found, std::vector<Change>& changes,
             const std::string& kind) {
    std::map<std::int64_t, std::vector<std::int64_t>> by_layer;
    for (const auto& [id, object] : found) by_layer[object.layer].push_back(id);
    for (auto& [layer, ids] : by_layer) {
      const auto place = [&found](std::int64_t id) { return found[id].place; };
      std::stable_sort(ids.begin(), ids.end(),
                       [&](std::int64_t a, std::int64_t b) { return place(a) < place(b); });
      for (std::size_t i = 0; i < ids.size(); ++i) {
        changes.push_back({{static_cast<std::uint64_t>(ids[i])},
                           nullptr,
                           found[ids[i]].object,
                           {},
                           {{static_cast<std::uint64_t>(layer)}, i}});
      }
      const std::int64_t missing = place(ids.back()) + 1 - std::ssize(ids);
      if (missing <= 0) continue;
      out_.problems.push_back("At least " + std::to_string(missing) + kind +
                              (missing == 1 ? "" : "s") + " of the layer “" +
                              found_.layers[layer].state.name + "” could not be read.");
    }
  }

  void take_rest() {
    Drawing& d = out_.drawing;
    d.document.reserve_ids({std::uint64_t(found_.last_stroke)}, {std::uint64_t(found_.last_layer)});
    if (!d.document.layer(d.layer)) d.layer = {};
    for (auto& [id, color] : found_.colors) d.palette.colors.push_back(std::move(color));
    if (!check_page(d)) {
      d.palette = {};
      out_.problems.emplace_back("The drawing's palette is lost.");
    }
    for (auto& [id, text] : found_.materials) add_material_text(d.materials, text);
    // New strokes may get the ids of strokes that are lost, but not their names.
    std::erase_if(found_.names, [&d](const auto& named) { return !d.document.find(named.first); });
    if (!found_.names.empty()) d.names = std::make_shared<StrokeNames>(std::move(found_.names));
    d.view = found_.view;
    if (!check_page(d)) d.view.reset();
    if (found_.others > 0) {
      out_.problems.emplace_back("Other data in the file, such as recordings, was not recovered.");
    }
  }

  Findings found_;
  Salvaged out_;
};

}  // namespace

Result<Salvaged> salvage_felt_bytes(std::string_view bytes) {
  Result<Drawing> whole = parse_felt(bytes);
  if (whole) return Salvaged{*std::move(whole), {}};
  Findings findings;
  scan_rows(bytes, [&findings](const ScannedRow& row) { findings.take(row); });
  return Assembly(std::move(findings)).make(whole.error().message);
}

Result<Salvaged> salvage_felt(const std::string& path) {
  const Result<std::string> bytes = read_file(path, check_salvage_head);
  if (!bytes) return tl::unexpected(bytes.error());
  Result<Salvaged> salvaged = salvage_felt_bytes(*bytes);
  if (salvaged) return salvaged;
  return tl::unexpected(with_context(salvaged.error(), path == "-" ? "stdin" : path));
}

}  // namespace felt
