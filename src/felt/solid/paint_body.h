#pragma once

#include <span>
#include <vector>

#include "felt/solid/line_on_body.h"
#include "felt/solid/solid.h"

namespace felt {

/// A line that is painted on a body.
struct PaintedLine {
  std::vector<LineOnBody> parts;
  double width_mm = 1.0;
  Rgba color{0, 0, 0, 255};
};

/// Paints lines on a body, in their order: sets the colours of its points (SolidBody::paint).
/// First, triangles at the borders of the lines are divided until their edges are at most a third
/// of the width, so that the borders are sharp; the surface stays exactly the same. A line is
/// painted only where the surface faces the same side as at the line, so that it does not appear on
/// the back of a thin body. No triangles are divided beyond kMaxPaintedTriangles; then borders are
/// less sharp.
void paint_body(SolidBody& body, std::span<const PaintedLine> lines);
inline constexpr std::size_t kMaxPaintedTriangles = 200'000;

}  // namespace felt
