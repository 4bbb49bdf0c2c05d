#pragma once

#include <cstdint>

#include "felt/stroke/stroke.h"

namespace felt {

/// One of the two ends of an open stroke.
enum class StrokeTip : std::uint8_t { kStart, kEnd };

constexpr StrokeTip opposite(StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? StrokeTip::kEnd : StrokeTip::kStart;
}

/// The first or last point of a stroke.
inline Point tip_point(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? stroke.data().points.front() : stroke.data().points.back();
}

/// Unit direction in which the ink would go on beyond the tip.
inline Vec tip_direction(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? -tangent(stroke.segment(0), 0.0)
                                  : tangent(stroke.segment(stroke.segment_count() - 1), 1.0);
}

}  // namespace felt
