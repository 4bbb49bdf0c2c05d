#pragma once

#include <cstdint>
#include <string>

#include "felt/io/drawing_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// Returns a random drawing for round-trip tests. It has none to four layers, some of them hidden,
/// locked, empty or with names that need escaping, and it may have a page. The same seed gives the
/// same drawing.
inline Drawing random_layers(std::uint64_t seed) {
  RandomStroke random(seed);
  DrawingBuilder builder;
  Drawing& drawing = builder.drawing();
  if (random.chance(0.7)) {
    drawing.has_page = true;
    drawing.page.width_mm = random.uniform(Page::kMinMm, Page::kMaxMm);
    drawing.page.height_mm = random.uniform(Page::kMinMm, Page::kMaxMm);
    drawing.page.paper.a = static_cast<std::uint8_t>(random.pick(0, 255));
  }
  if (random.chance(0.5)) drawing.page.surface = "my <\"paper\"> & co";
  for (int k = random.chance(0.5) ? random.pick(1, 3) : 0; k > 0; --k) {
    drawing.materials.push_back("id = \"m" + std::to_string(k) + "\"\r\n\t# <&> \xC3\xA9\n");
  }
  const int layers = random.pick(0, 4);
  for (int i = 0; i < layers; ++i) {
    LayerState state;
    state.name =
        random.chance(0.2) ? "" : "<\"Layer\" & 'more'>\t\n" + std::to_string(i) + "\xC3\xA9";
    state.visible = random.chance(0.8);
    state.locked = random.chance(0.2);
    const std::size_t layer = builder.add_layer(std::move(state));
    for (int k = random.pick(0, 5); k > 0; --k) {
      StrokeData data = random.make();
      if (random.chance(0.2)) data.medium = "chalk & co";
      builder.add(layer, Stroke::create(std::move(data)).value(),
                  random.chance(0.1) ? "" : "s" + std::to_string(20 * i + k));
    }
  }
  return std::move(builder).build();
}

}  // namespace felt::testing
