#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/haptics/pen_sample.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// One gesture as a device reports it: hover samples, the touch, samples in contact and, usually,
/// the lift. Times continue from the previous gesture. The session computes the velocities. Some
/// samples have no valid position (NaN).
struct PenGesture {
  std::string_view kind;  ///< such as "along", for reports
  std::vector<PenSample> samples;
};

/// Returns a random gesture on `document`: taps, rests, lines, circles, scribbles, jumps; along
/// existing strokes and guides, near their ends and corners, or around one or all of them; out and
/// back, too fast, or far off the page. The samples may have a pressure, changing buttons, or
/// bounces of the tip.
PenGesture random_gesture(Dice& dice, const Document& document, std::int64_t start_ns);

/// Returns a gesture that the pencil may take for more than ink: to and fro over a stroke, twice
/// around one, along a guide, or a shape after which the pen rests. The pen is that of a tablet,
/// without faults.
PenGesture meant_gesture(Dice& dice, const Document& document, std::int64_t start_ns);

}  // namespace felt::gestures
