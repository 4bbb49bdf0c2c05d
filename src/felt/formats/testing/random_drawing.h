#pragma once

#include "felt/base/check.h"
#include "felt/document/testing/random_document.h"
#include "felt/io/drawing_builder.h"

namespace felt::testing {

/// Makes a random drawing of several layers, for property tests: strokes of all kinds, ids with
/// gaps, some layers hidden or locked, and a page. Layers have ids from 1, as formats without layer
/// ids give them. The layers have no pictures
/// and no timings. The same seed gives the same drawing.
inline Drawing random_drawing(std::uint64_t seed) {
  Document document;
  RandomEdits edits(seed);
  for (int i = 0; i < 12; ++i) {
    const bool fits = document.apply(edits.next(document)).has_value();
    FELT_CHECK(fits);
  }
  DrawingBuilder builder;
  for (const Layer& layer : document.layers()) {
    LayerState state = layer.state();
    state.picture = nullptr;  // only .felt keeps pictures and timings
    state.timing = nullptr;
    const std::size_t index = builder.add_layer(std::move(state));
    for (const StrokeId id : layer.strokes) builder.add(index, document.find(id), id);
  }
  RandomStroke random(seed);
  const auto byte = [&random] { return static_cast<std::uint8_t>(random.pick(0, 255)); };
  Drawing& drawing = builder.drawing();
  drawing.has_page = true;
  drawing.page = Page{static_cast<double>(random.pick(10, 500)) + 0.25,
                      static_cast<double>(random.pick(10, 5000)),
                      {byte(), byte(), byte(), byte()}};
  if (random.chance(0.5)) drawing.page.surface = "my-paper";
  if (random.chance(0.5)) drawing.materials = {"kind = \"surface\"\nid = \"my-paper\"\n"};
  return std::move(builder).build();
}

}  // namespace felt::testing
