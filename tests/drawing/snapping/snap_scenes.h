#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"

namespace felt::snap_test {

/// Strokes to be drawn one after another, and what must come of them.
struct SnapScene {
  std::string name;
  std::vector<Gesture> strokes;
  /// So many strokes after each other make one shape that is meant to close. 0: every stroke must
  /// come out by itself, open.
  int lines_per_shape = 0;
};

/// Drawing in which no line is meant to meet another: hatching 0.7 to 3 mm apart in one direction
/// and back and forth, cross-hatching, shading over the same place, fans of grass, dashes, words.
std::vector<SnapScene> scenes_to_leave_alone();

/// Shapes of 3 mm and more that are meant to close, drawn to within 1.5 mm: circles, ellipses, the
/// letter o, squares of one and of four lines, outlines that a second line closes.
std::vector<SnapScene> scenes_to_close();

}  // namespace felt::snap_test
