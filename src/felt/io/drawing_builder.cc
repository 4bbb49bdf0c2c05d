#include "felt/io/drawing_builder.h"

#include <algorithm>
#include <memory>
#include <set>

#include "felt/base/check.h"
#include "felt/base/utf8.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/limits.h"

namespace felt {
namespace {

/// Returns true if files can have this name, of a layer, a group or a stroke.
bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= limits::kMaxNameBytes &&
         name.find('\0') == std::string_view::npos && is_utf8(name);
}

void make_valid(Page& page) {
  const auto fits = [](double mm) { return mm >= Page::kMinMm && mm <= Page::kMaxMm; };
  if (!fits(page.width_mm) || !fits(page.height_mm)) {
    page.width_mm = Page{}.width_mm;
    page.height_mm = Page{}.height_mm;
  }
  if (page.surface.size() > limits::kMaxNameBytes || !is_utf8(page.surface)) page.surface = "";
}

}  // namespace

std::size_t DrawingBuilder::add_layer(LayerState state) {
  if (!is_name(state.name)) state.name = "Layer " + std::to_string(layers_.size() + 1);
  layers_.push_back({std::move(state), {}});
  return layers_.size() - 1;
}

void DrawingBuilder::set_state(std::size_t layer, LayerState state) {
  FELT_CHECK(layer < layers_.size());
  if (!is_name(state.name)) state.name = "Layer " + std::to_string(layer + 1);
  layers_[layer].state = std::move(state);
}

void DrawingBuilder::add(std::size_t layer, Stroke stroke, std::string_view name,
                         std::string_view number) {
  FELT_CHECK(layer < layers_.size());
  const StrokeId numbered = stroke_id_of_name(number);
  const StrokeId id = numbered.value > 0 ? numbered : stroke_id_of_name(name);
  layers_[layer].strokes.push_back({id.value, std::make_shared<const Stroke>(std::move(stroke)),
                                    std::string(is_name(name) ? name : "")});
}

void DrawingBuilder::add(std::size_t layer, StrokePtr stroke, StrokeId id) {
  FELT_CHECK(layer < layers_.size());
  layers_[layer].strokes.push_back({stroke_id_of_name(stroke_name(id)).value, std::move(stroke)});
}

void DrawingBuilder::add_fill(std::size_t layer, FillPtr fill, std::string_view name) {
  FELT_CHECK(layer < layers_.size() && fill);
  layers_[layer].fills.emplace_back(fill_id_of_name(name).value, std::move(fill));
}

Edit DrawingBuilder::edit(StrokeNames& names) const {
  std::uint64_t last_id = 0;
  for (const NewLayer& layer : layers_) {
    for (const Entry& entry : layer.strokes) last_id = std::max(last_id, entry.id);
    for (const auto& fill : layer.fills) last_id = std::max(last_id, fill.first);
  }
  Edit edit;
  std::set<std::uint64_t> taken, fills_taken;
  const Layer& first = drawing_.document.layers().front();
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const LayerId layer{i + 1};
    const auto before = layer == first.id ? std::optional(first.state()) : std::nullopt;
    edit.layers.push_back({layer, before, layers_[i].state, 0, i});
    std::size_t index = 0;
    for (const Entry& entry : layers_[i].strokes) {
      const bool gets_it = entry.id > 0 && taken.insert(entry.id).second;
      const StrokeId id{gets_it ? entry.id : ++last_id};
      edit.changes.push_back({id, nullptr, entry.stroke, {}, StrokePlace{layer, index++}});
      if (!entry.name.empty() && entry.name != stroke_name(id)) names[id] = entry.name;
    }
    index = 0;
    for (const auto& [asked, fill] : layers_[i].fills) {
      const bool gets_it = asked > 0 && fills_taken.insert(asked).second;
      const FillId id{gets_it ? asked : ++last_id};
      edit.fills.push_back({id, nullptr, fill, {}, StrokePlace{layer, index++}});
    }
  }
  return edit;
}

void DrawingBuilder::number_groups() {
  std::vector<LayerGroupPtr*> groups;
  for (NewLayer& layer : layers_) groups.push_back(&layer.state.group);
  separate_groups(groups, GroupNumbers::kFromOne);
  for (NewLayer& layer : layers_) {
    LayerGroupPtr& shared = layer.state.group;
    if (!shared || is_name(shared->name)) continue;
    LayerGroup group = *shared;
    group.name = "Group " + std::to_string(group.id.value);
    shared = std::make_shared<const LayerGroup>(std::move(group));
  }
}

Drawing DrawingBuilder::build() && {
  if (layers_.empty()) add_layer({"Ink"});
  number_groups();
  StrokeNames names;
  FELT_CHECK(drawing_.document.apply(edit(names)).has_value());
  if (!names.empty()) drawing_.names = std::make_shared<const StrokeNames>(std::move(names));
  make_valid(drawing_.page);
  return std::move(drawing_);
}

}  // namespace felt
