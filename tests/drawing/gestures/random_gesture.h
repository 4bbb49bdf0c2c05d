#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/haptics/pen_sample.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// One gesture as the device tells it: some way in the air, the touch, what the pen does on the
/// sheet, the lift (as a rule). Times count on from the gesture before; velocities are left to the
/// session. Some samples have no place at all (NaN).
struct PenGesture {
  std::string_view kind;  ///< "along": for reports
  std::vector<PenSample> samples;
};

/// A gesture on this document: taps, rests, lines, circles, scribbles, jumps, along lines that are
/// there, near their ends and corners, round one or all of them, out and back, too fast, far off
/// the sheet; with pressure or without, with buttons that change, with bounces of the tip.
PenGesture random_gesture(Dice& dice, const Document& document, std::int64_t start_ns);

}  // namespace felt::gestures
