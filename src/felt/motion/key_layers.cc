#include "felt/motion/key_layers.h"

#include <utility>

#include "felt/base/check.h"

namespace felt {

bool is_key_layer(const Layer& layer) noexcept {
  return !layer.locked && !(layer.strokes.empty() && layer.fills.empty());
}

std::vector<LayerId> key_layers(const Document& document) {
  std::vector<LayerId> keys;
  for (const Layer& layer : document.layers()) {
    if (is_key_layer(layer)) keys.push_back(layer.id);
  }
  return keys;
}

Drawing key_drawing(const Document& document, LayerId id, const Page& page) {
  const Layer& layer = *document.layer(id);
  Drawing drawing;
  drawing.page = page;
  drawing.has_page = true;
  const Layer& first = drawing.document.layers().front();
  LayerState state = layer.state();
  state.visible = true;
  state.group = nullptr;
  state.picture = nullptr;
  state.timing = nullptr;
  Edit edit;
  edit.label = "Key drawing";
  edit.layers.push_back({first.id, first.state(), std::move(state), 0, 0});
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    const StrokeId stroke = layer.strokes[i];
    edit.changes.push_back({stroke, nullptr, document.find(stroke), {}, {first.id, i}});
  }
  for (std::size_t i = 0; i < layer.fills.size(); ++i) {
    const FillId fill = layer.fills[i];
    edit.fills.push_back({fill, nullptr, document.find_fill(fill), {}, {first.id, i}});
  }
  FELT_CHECK(drawing.document.apply(edit).has_value());
  return drawing;
}

std::size_t film_frames(const Document& document) {
  std::size_t frames = 0, between = 0;  // `between`: after the last key drawing so far
  for (const LayerId id : key_layers(document)) {
    const KeyTiming& timing = timing_or_default(document.layer(id)->timing);
    frames += between + static_cast<std::size_t>(timing.hold);
    between = static_cast<std::size_t>(timing.between);
  }
  return frames;
}

std::vector<FilmKey> film_keys(const Document& document, const Page& page) {
  std::vector<FilmKey> keys;
  for (const LayerId id : key_layers(document)) {
    keys.push_back(
        {key_drawing(document, id, page), timing_or_default(document.layer(id)->timing)});
  }
  return keys;
}

}  // namespace felt
