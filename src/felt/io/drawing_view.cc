#include "felt/io/drawing_view.h"

#include <cmath>

namespace felt {
namespace {

LayerView layer_of(const Sketch& strokes) {
  LayerView view;
  view.count = strokes.size();
  view.stroke = [&strokes](std::size_t i) -> const Stroke& { return strokes[i].stroke; };
  view.id = [&strokes](std::size_t i) { return strokes[i].id; };
  return view;
}

}  // namespace

Rect DrawingView::ink() const {
  Rect ink;
  for (const LayerView& layer : layers) {
    for (std::size_t i = 0; i < layer.count; ++i) ink.extend(layer.stroke(i).bounds());
  }
  return ink;
}

Rect picture_area(const Rect& ink, const std::optional<Rect>& page, double margin_mm) noexcept {
  if (page) return *page;
  const Rect area = (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(margin_mm);
  return {std::floor(area.x0 * 100.0) / 100.0, std::floor(area.y0 * 100.0) / 100.0,
          std::ceil(area.x1 * 100.0) / 100.0, std::ceil(area.y1 * 100.0) / 100.0};
}

DrawingView view_of(const LayeredSketch& drawing) {
  DrawingView view;
  view.page = drawing.page;
  view.surface = drawing.surface;
  view.materials = drawing.materials;
  for (const SketchLayer& layer : drawing.layers) {
    LayerView& added = view.layers.emplace_back(layer_of(layer.strokes));
    added.name = layer.name;
    added.visible = layer.visible;
    added.locked = layer.locked;
  }
  return view;
}

DrawingView view_of(const Sketch& sketch) {
  DrawingView view;
  view.layers.push_back(layer_of(sketch));
  return view;
}

}  // namespace felt
