#include "felt/document/visible_strokes.h"

namespace felt {

Sketch visible_strokes(const Document& document) {
  Sketch sketch;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      sketch.push_back({"s" + std::to_string(id.value), *document.find(id)});
    }
  }
  return sketch;
}

}  // namespace felt
