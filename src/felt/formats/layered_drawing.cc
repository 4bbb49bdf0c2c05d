#include "felt/formats/layered_drawing.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <set>
#include <utility>

#include "felt/base/check.h"
#include "felt/base/utf8.h"
#include "felt/io/limits.h"
#include "felt/io/xml/material_texts.h"

namespace felt {
namespace {

/// Largest id that a name may ask for: far below the largest that a file can hold (2^53), so that
/// new strokes get ids that can be saved.
constexpr std::uint64_t kMostId = std::uint64_t{1} << 40;

/// 12 of "s12"; 0 of anything else.
std::uint64_t id_of_name(std::string_view name) noexcept {
  if (name.size() < 2 || name[0] != 's' || name[1] == '0') return 0;
  std::uint64_t id = 0;
  const char* end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + 1, end, id);
  return error == std::errc() && rest == end && id < kMostId ? id : 0;
}

/// Gives each stroke of a sketch its id.
class Ids {
 public:
  explicit Ids(const LayeredSketch& sketch) {
    for (const SketchLayer& layer : sketch.layers) {
      for (const SketchStroke& s : layer.strokes) last_ = std::max(last_, id_of_name(s.id));
    }
  }
  StrokeId next(const std::string& name) {
    const std::uint64_t id = id_of_name(name);
    return {id > 0 && taken_.insert(id).second ? id : ++last_};
  }

 private:
  std::uint64_t last_ = 0;
  std::set<std::uint64_t> taken_;
};

LayerState state_of(const SketchLayer& layer, std::size_t number) {
  const bool fits = !layer.name.empty() && layer.name.size() <= limits::kMaxNameBytes &&
                    layer.name.find('\0') == std::string::npos && is_utf8(layer.name);
  return {fits ? layer.name : "Layer " + std::to_string(number), layer.visible, layer.locked};
}

SheetPage sheet_of(const LayeredSketch& sketch) {
  const SheetPage page = sketch.page.value_or(SheetPage{.surface = sketch.surface});
  const auto fits = [](double mm) { return mm >= SheetPage::kLeastMm && mm <= SheetPage::kMostMm; };
  const bool is_sheet = fits(page.width_mm) && fits(page.height_mm);
  SheetPage sheet = is_sheet ? page : SheetPage{.paper = page.paper, .surface = page.surface};
  if (sheet.surface.size() > limits::kMaxNameBytes || !is_utf8(sheet.surface)) sheet.surface = "";
  return sheet;
}

}  // namespace

LayeredSketch layered_sketch(const StoredDrawing& drawing, LayerChoice choice) {
  LayeredSketch sketch;
  for (const Layer& layer : drawing.document.layers()) {
    if (choice == LayerChoice::kVisible && !layer.visible) continue;
    SketchLayer& added =
        sketch.layers.emplace_back(SketchLayer{layer.name, layer.visible, layer.locked, {}});
    added.strokes.reserve(layer.strokes.size());
    for (const StrokeId id : layer.strokes) {
      added.strokes.push_back({"s" + std::to_string(id.value), *drawing.document.find(id)});
    }
  }
  sketch.page = drawing.page;
  sketch.materials = drawing.materials;
  return sketch;
}

DrawingView view_of(const StoredDrawing& drawing, LayerChoice choice) {
  DrawingView view;
  for (const Layer& layer : drawing.document.layers()) {
    if (choice == LayerChoice::kVisible && !layer.visible) continue;
    LayerView& added = view.layers.emplace_back();
    added.name = layer.name;
    added.visible = layer.visible;
    added.locked = layer.locked;
    added.count = layer.strokes.size();
    added.stroke = [&document = drawing.document, &layer](std::size_t i) -> const Stroke& {
      return *document.find(layer.strokes[i]);
    };
    added.id = [&layer](std::size_t i) { return "s" + std::to_string(layer.strokes[i].value); };
  }
  view.page = drawing.page;
  view.materials = drawing.materials;
  return view;
}

StoredDrawing stored_drawing(LayeredSketch sketch) {
  if (sketch.layers.empty()) sketch.layers.push_back({"Ink", true, false, {}});
  StoredDrawing drawing;
  Ids ids(sketch);
  Edit edit;
  const Layer& first = drawing.document.layers().front();
  for (std::size_t i = 0; i < sketch.layers.size(); ++i) {
    const LayerId layer{i + 1};
    const bool is_first = layer == first.id;
    edit.layers.push_back({layer, is_first ? std::optional(first.state()) : std::nullopt,
                           state_of(sketch.layers[i], i + 1), 0, i});
    std::size_t place = 0;
    for (SketchStroke& s : sketch.layers[i].strokes) {
      const StrokeId id = ids.next(s.id);
      edit.changes.push_back({id,
                              nullptr,
                              std::make_shared<const Stroke>(std::move(s.stroke)),
                              {},
                              StrokePlace{layer, place++}});
    }
  }
  FELT_CHECK(drawing.document.apply(edit).has_value());
  drawing.page = sheet_of(sketch);
  for (const std::string& text : sketch.materials) add_material_text(drawing.materials, text);
  return drawing;
}

Sketch flat_sketch(const LayeredSketch& sketch) {
  Sketch flat;
  for (const SketchLayer& layer : sketch.layers) {
    if (layer.visible) flat.insert(flat.end(), layer.strokes.begin(), layer.strokes.end());
  }
  return flat;
}

}  // namespace felt
