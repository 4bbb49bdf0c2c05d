#include "desktop/panels/onion_skin.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"
#include "felt/motion/key_layers.h"

namespace felt::desktop {
namespace {

constexpr double kOnionOpacity = 0.35;

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
