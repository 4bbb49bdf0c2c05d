#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/id.h"

namespace felt {

/// The timing function cubic-bezier(x1, y1, x2, y2) of CSS Easing Functions Level 1
/// (https://www.w3.org/TR/css-easing-1/). Each number is 0 to 1, so that the motion never goes
/// back. The default is a motion of constant speed.
struct EaseCurve {
  double x1 = 0.0, y1 = 0.0, x2 = 1.0, y2 = 1.0;

  friend bool operator==(const EaseCurve&, const EaseCurve&) noexcept = default;
};

/// A stroke of a key drawing, and the stroke of the next key drawing that it becomes, because the
/// user says so. If one id is zero, the other stroke has no partner.
struct KeyPair {
  StrokeId from;  ///< in the layer that has the timing
  StrokeId to;    ///< in the next key drawing

  friend bool operator==(const KeyPair&, const KeyPair&) noexcept = default;
};

/// How a film shows the key drawing of a layer, and how it goes on to the next one. Immutable. A
/// layer without a timing (null) has the values of a new one.
struct KeyTiming {
  static constexpr int kMaxBetween = 1000, kMaxHold = 1000;
  static constexpr std::size_t kMaxPairs = 10'000;

  int between = 12;  ///< number of in-betweens to the next key drawing, 0..kMaxBetween
  int hold = 1;      ///< number of frames for which the key drawing is shown, 1..kMaxHold
  EaseCurve ease{};  ///< speed from this key drawing to the next one
  /// Corrections of the matches between this key drawing and the next one. Pairs that name strokes
  /// which are not in these key drawings have no effect.
  std::vector<KeyPair> pairs = {};

  friend bool operator==(const KeyTiming&, const KeyTiming&) = default;
};

using KeyTimingPtr = std::shared_ptr<const KeyTiming>;

/// Checks the invariants of a timing: every number is within the limits above, and no stroke is in
/// two pairs. All readers call this. The message starts with the key of the event
/// (docs/formats/events.md).
Result<void> check_key_timing(const KeyTiming& timing);

/// Returns the timing, or the values of a new one if it is null.
[[nodiscard]] const KeyTiming& timing_or_default(const KeyTimingPtr& timing) noexcept;

/// Returns null for the values of a new timing, so that equal drawings have equal timings.
[[nodiscard]] KeyTimingPtr shared_timing(KeyTiming timing);

/// Returns true if both are null or equal by value.
[[nodiscard]] bool equal_timings(const KeyTimingPtr& a, const KeyTimingPtr& b) noexcept;

}  // namespace felt
