#pragma once

#include <string>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// One stroke of a sketch and the name that its source gave it.
struct SketchStroke {
  std::string id;
  Stroke stroke;

  friend bool operator==(const SketchStroke&, const SketchStroke&) = default;
};

/// Strokes in drawing order, the last on top: what readers return and writers take.
using Sketch = std::vector<SketchStroke>;

}  // namespace felt
