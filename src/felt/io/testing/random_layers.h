#pragma once

#include <cstdint>
#include <string>

#include "felt/io/layered_sketch.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// Drawings of every kind for round trips: none to four layers, hidden, locked, empty, names that
/// need escaping, with and without a sheet. The same seed gives the same drawing.
inline LayeredSketch random_layers(std::uint64_t seed) {
  RandomStroke random(seed);
  LayeredSketch drawing;
  if (random.chance(0.7)) {
    drawing.page.emplace();
    drawing.page->width_mm = random.uniform(SheetPage::kLeastMm, SheetPage::kMostMm);
    drawing.page->height_mm = random.uniform(SheetPage::kLeastMm, SheetPage::kMostMm);
    drawing.page->paper.a = static_cast<std::uint8_t>(random.pick(0, 255));
  }
  if (random.chance(0.5)) {
    (drawing.page ? drawing.page->surface : drawing.surface) = "my <\"paper\"> & co";
  }
  for (int k = random.chance(0.5) ? random.pick(1, 3) : 0; k > 0; --k) {
    drawing.materials.push_back("id = \"m" + std::to_string(k) + "\"\r\n\t# <&> \xC3\xA9\n");
  }
  const int layers = random.pick(0, 4);
  for (int i = 0; i < layers; ++i) {
    SketchLayer layer;
    layer.name =
        random.chance(0.2) ? "" : "<\"Layer\" & 'more'>\t\n" + std::to_string(i) + "\xC3\xA9";
    layer.visible = random.chance(0.8);
    layer.locked = random.chance(0.2);
    for (int k = random.pick(0, 5); k > 0; --k) {
      StrokeData data = random.make();
      if (random.chance(0.2)) data.material = "chalk & co";
      layer.strokes.push_back({random.chance(0.1) ? "" : "s<" + std::to_string(k),
                               Stroke::create(std::move(data)).value()});
    }
    drawing.layers.push_back(std::move(layer));
  }
  return drawing;
}

}  // namespace felt::testing
