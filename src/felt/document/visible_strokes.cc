#include "felt/document/visible_strokes.h"

namespace felt {

std::vector<StrokePtr> visible_strokes(const Document& document) {
  std::vector<StrokePtr> strokes;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) strokes.push_back(document.find(id));
  }
  return strokes;
}

const LayerPicture* exported_picture(const Layer& layer, PictureChoice pictures) noexcept {
  const bool is_shown = layer.picture && layer.visible &&
                        (pictures == PictureChoice::kAll || layer.picture->exported);
  return is_shown ? layer.picture.get() : nullptr;
}

Rect ink_bounds(const Document& document, LayerChoice layers) {
  Rect ink;
  for (const Layer& layer : document.layers()) {
    if (layers == LayerChoice::kVisible && !layer.visible) continue;
    for (const StrokeId id : layer.strokes) ink.extend(document.find(id)->bounds());
    for (const FillId id : layer.fills) ink.extend(fill_bounds(*document.find_fill(id)));
  }
  return ink;
}

std::string fill_name(FillId id) {
  return "f" + std::to_string(id.value);
}

std::string stroke_name(StrokeId id) {
  return "s" + std::to_string(id.value);
}

}  // namespace felt
