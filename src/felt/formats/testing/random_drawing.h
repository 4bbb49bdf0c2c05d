#pragma once

#include "felt/base/check.h"
#include "felt/document/testing/random_document.h"
#include "felt/formats/layered_drawing.h"

namespace felt::testing {

/// A random drawing of some layers, for property tests: strokes of all kinds, ids with gaps, some
/// layers hidden or locked, and a sheet. Layers are counted from 1, as formats without ids of
/// layers give them back. The same seed gives the same drawing.
inline StoredDrawing random_drawing(std::uint64_t seed) {
  Document document;
  RandomEdits edits(seed);
  for (int i = 0; i < 12; ++i) {
    const bool fits = document.apply(edits.next(document)).has_value();
    FELT_CHECK(fits);
  }
  LayeredSketch sketch;
  for (const Layer& layer : document.layers()) {
    sketch.layers.push_back({layer.name, layer.visible, layer.locked, {}});
    for (const StrokeId id : layer.strokes) {
      sketch.layers.back().strokes.push_back({"s" + std::to_string(id.value), *document.find(id)});
    }
  }
  RandomStroke random(seed);
  const auto byte = [&random] { return static_cast<std::uint8_t>(random.pick(0, 255)); };
  sketch.page = SheetPage{static_cast<double>(random.pick(10, 500)) + 0.25,
                          static_cast<double>(random.pick(10, 5000)),
                          {byte(), byte(), byte(), byte()}};
  if (random.chance(0.5)) sketch.page->surface = "my-paper";
  if (random.chance(0.5)) sketch.materials = {"kind = \"sheet\"\nid = \"my-paper\"\n"};
  return stored_drawing(std::move(sketch));
}

}  // namespace felt::testing
