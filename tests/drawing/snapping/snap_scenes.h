#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"

namespace felt::snap_test {

/// Strokes that are drawn one after another, and the expected result.
struct SnapScene {
  std::string name;
  std::vector<Gesture> strokes;
  /// Number of consecutive strokes that make one shape, which is meant to close. If it is 0, every
  /// stroke must stay separate and open.
  int lines_per_shape = 0;
};

/// Returns scenes in which no line is meant to join another: hatching 0.7 to 3 mm apart in one
/// direction and back and forth, cross-hatching, repeated shading of one area, fans of grass,
/// dashes, words.
std::vector<SnapScene> scenes_to_leave_alone();

/// Returns scenes with shapes of 3 mm or more that are meant to close, and are drawn closed to
/// within 1.5 mm: circles, ellipses, the letter o, squares of one and of four lines, and outlines
/// that a second line closes.
std::vector<SnapScene> scenes_to_close();

}  // namespace felt::snap_test
