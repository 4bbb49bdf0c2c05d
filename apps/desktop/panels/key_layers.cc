#include "desktop/panels/key_layers.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"

namespace felt::desktop {
namespace {

constexpr double kOnionOpacity = 0.35;

bool is_key_layer(const Layer& layer) {
  return !layer.locked && !(layer.strokes.empty() && layer.fills.empty());
}

StrokePtr tinted(const Stroke& stroke, Rgba tint) {
  StrokeData data = stroke.data();
  tint.a = data.color.a;
  data.color = tint;
  Result<Stroke> made = Stroke::create(std::move(data));
  return made ? std::make_shared<const Stroke>(*std::move(made)) : nullptr;
}

void add_onion_layer(const Document& document, const Layer& layer, Rgba tint,
                     DrawingBuilder& builder) {
  LayerState state{layer.name, true, false};
  state.opacity = kOnionOpacity;
  const std::size_t added = builder.add_layer(std::move(state));
  for (const FillId id : layer.fills) {
    Fill fill = *document.find_fill(id);
    tint.a = fill.color.a;
    fill.color = tint;
    builder.add_fill(added, std::make_shared<const Fill>(std::move(fill)), fill_name(id));
  }
  for (const StrokeId id : layer.strokes) {
    if (StrokePtr stroke = tinted(*document.find(id), tint)) builder.add(added, stroke, id);
  }
}

}  // namespace

std::vector<LayerId> key_layers(const Document& document) {
  std::vector<LayerId> keys;
  for (const Layer& layer : document.layers()) {
    if (is_key_layer(layer)) keys.push_back(layer.id);
  }
  return keys;
}

Drawing key_drawing(const Document& document, LayerId id, const Page& page) {
  const Layer& layer = *document.layer(id);
  DrawingBuilder builder;
  builder.drawing().page = page;
  builder.drawing().has_page = true;
  LayerState state = layer.state();
  state.visible = true;
  state.group = nullptr;
  state.picture = nullptr;
  const std::size_t added = builder.add_layer(std::move(state));
  for (const FillId fill : layer.fills) {
    builder.add_fill(added, document.find_fill(fill), fill_name(fill));
  }
  for (const StrokeId stroke : layer.strokes) builder.add(added, document.find(stroke), stroke);
  return std::move(builder).build();
}

std::vector<Drawing> key_drawings(const Document& document, const Page& page) {
  std::vector<Drawing> keys;
  for (const LayerId layer : key_layers(document)) {
    keys.push_back(key_drawing(document, layer, page));
  }
  return keys;
}

Document onion_skin(const Document& document, LayerId current) {
  const auto& layers = document.layers();
  const auto here = std::find_if(layers.begin(), layers.end(),
                                 [current](const Layer& l) { return l.id == current; });
  DrawingBuilder builder;
  const auto before = std::find_if(std::make_reverse_iterator(here), layers.rend(), is_key_layer);
  if (before != layers.rend()) add_onion_layer(document, *before, kOnionBefore, builder);
  const auto after = std::find_if(here + 1, layers.end(), is_key_layer);
  if (after != layers.end()) add_onion_layer(document, *after, kOnionAfter, builder);
  return std::move(builder).build().document;
}

}  // namespace felt::desktop
