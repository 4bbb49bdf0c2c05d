#pragma once

#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/geometry/point.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// What a tool shows besides the document, as a display list in mm; the canvas and pictures draw
/// it. Reused from frame to frame, so that its vectors keep their memory.
struct Overlay {
  /// Ink that is still wet: segments in drawing order, each with its width at both ends.
  struct InkSegment {
    Cubic curve;
    double start_width_mm = 0.0;
    double end_width_mm = 0.0;
  };
  enum class Role {
    kReach,   ///< a radius within which something acts
    kSnap,    ///< a place that attracts
    kTether,  ///< what holds
    kGuide,   ///< where the hand is led
  };
  struct Ring {
    Point center;
    double radius_mm = 0.0;
    Role role = Role::kReach;
  };
  struct Line {
    Point from, to;
    Role role = Role::kGuide;
  };

  std::vector<InkSegment> ink;
  Rgba ink_color{};
  std::vector<Ring> rings;
  std::vector<Line> lines;

  void clear() noexcept {
    ink.clear();
    rings.clear();
    lines.clear();
  }
};

}  // namespace felt
