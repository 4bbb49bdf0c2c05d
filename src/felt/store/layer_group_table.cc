#include "felt/store/layer_group_table.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "felt/base/utf8.h"
#include "felt/document/document.h"
#include "felt/store/felt_tables.h"
#include "felt/store/layer_rows.h"

namespace felt {

LayerGroupPtr group_of_row(std::int64_t number, std::string name, std::int64_t visible,
                           std::int64_t locked, double opacity, std::string_view mode) {
  const auto blend = blend_mode_of(mode);
  if (!is_id(number) || (visible | 1) != 1 || (locked | 1) != 1 || !blend) return nullptr;
  if (!(opacity >= 0.0 && opacity <= 1.0)) return nullptr;
  if (name.size() > kMaxLayerNameBytes || !is_utf8(name)) return nullptr;
  return std::make_shared<const LayerGroup>(LayerGroup{{static_cast<std::uint64_t>(number)},
                                                       std::move(name),
                                                       visible == 1,
                                                       locked == 1,
                                                       opacity,
                                                       *blend});
}

Result<void> write_layer_blends(Database& database, const Document& document) {
  const std::span<const Layer> layers = document.layers();
  const auto is_normal = [](const Layer& layer) { return layer.blend == BlendMode::kNormal; };
  if (std::all_of(layers.begin(), layers.end(), is_normal)) return {};
  if (auto ok = database.run(std::string(kLayerBlendTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO layer_blend VALUES(?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  for (const Layer& layer : layers) {
    if (is_normal(layer)) continue;
    row->bind(1, ++id);
    row->bind_text(2, blend_mode_name(layer.blend));
    row->bind(3, static_cast<std::int64_t>(layer.id.value));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_layer_groups(Database& database, const Document& document) {
  const std::span<const Layer> layers = document.layers();
  if (std::none_of(layers.begin(), layers.end(), [](const Layer& l) { return l.group != nullptr; }))
    return {};
  if (auto ok = database.run(std::string(kLayerGroupTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO layer_group VALUES(?,?,?,?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  for (const Layer& layer : layers) {
    if (!layer.group) continue;
    const LayerGroup& group = *layer.group;
    if (group.name.size() > kMaxLayerNameBytes || !is_utf8(group.name)) {
      return invalid_data("a group of layers has an invalid name");
    }
    row->bind(1, ++id);
    row->bind(2, static_cast<std::int64_t>(layer.id.value));
    row->bind(3, static_cast<std::int64_t>(group.id.value));
    row->bind_text(4, group.name);
    row->bind(5, std::int64_t{group.visible});
    row->bind(6, std::int64_t{group.locked});
    row->bind(7, group.opacity);
    row->bind_text(8, blend_mode_name(group.blend));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> read_layer_blends(const Database& database, Edit& edit) {
  std::string unknown;
  auto done = for_each_layer_row(database, "SELECT layer, mode FROM layer_blend", "layer_blend",
                                 edit, [&unknown](const Statement& row, LayerState& state) {
                                   if (!row.is_text(1)) return false;
                                   const auto mode = blend_mode_of(row.text(1));
                                   if (!mode) unknown = std::string(row.text(1).substr(0, 100));
                                   state.blend = mode.value_or(BlendMode::kNormal);
                                   return mode.has_value();
                                 });
  if (done || unknown.empty()) return done;
  return invalid_data("a layer has the blend mode '" + unknown +
                      "', which this version of Feltline does not have");
}

Result<void> read_layer_groups(const Database& database, Edit& edit) {
  auto done = for_each_layer_row(
      database, "SELECT layer, number, name, visible, locked, opacity, mode FROM layer_group",
      "layer_group", edit, [](const Statement& row, LayerState& state) {
        const bool has_types = row.is_integer(1) && row.is_text(2) && row.is_integer(3) &&
                               row.is_integer(4) && row.is_real(5) && row.is_text(6);
        if (!has_types) return false;
        state.group = group_of_row(row.integer(1), std::string(row.text(2)), row.integer(3),
                                   row.integer(4), row.real(5), row.text(6));
        return state.group != nullptr;
      });
  if (done) separate_groups_of(edit);
  return done;
}

void separate_groups_of(Edit& edit) {
  std::vector<LayerChange*> layers;
  for (LayerChange& c : edit.layers) {
    if (c.after) layers.push_back(&c);
  }
  std::sort(layers.begin(), layers.end(), [](const LayerChange* a, const LayerChange* b) {
    return a->after_index < b->after_index;
  });
  std::vector<LayerGroupPtr*> groups;
  for (LayerChange* c : layers) groups.push_back(&c->after->group);
  separate_groups(groups, GroupNumbers::kKept);
}

}  // namespace felt
