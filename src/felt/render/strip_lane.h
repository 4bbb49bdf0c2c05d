#pragma once

#include <cstdint>

#include "felt/render/pressure_map.h"
#include "felt/render/tip_strips.h"

namespace felt {

/// Where the soft edge of a medium begins, as a value of rho^2, and the inverse of its extent.
struct SoftEdge {
  float from = 2.0F, per_edge = 0.0F;
};

/// What a strip lays on one pixel.
struct StripLane {
  std::int32_t value = 0;  ///< a value of PressureMap
  std::int32_t is_in = 0;  ///< 1 if the strip touches the pixel
  float t = 0.0F;          ///< position along the strip, 0..1
  float radius = 0.0F;     ///< radius there, with kSoftPx
  float beside2 = 0.0F;    ///< squared distance from the middle line
};

/// Clamps in two separate steps, because compilers do not vectorize nested conditions.
[[gnu::always_inline]] inline float clamped_lane(float x, float low, float high) noexcept {
  const float smallest = x < low ? low : x;
  return smallest > high ? high : smallest;
}

/// Returns what a strip lays on the pixel at (px, py) from its start: projects the pixel onto the
/// strip's middle line, finds the dab there, and computes rho^2 and from it the push.
template <bool kTapers>
[[gnu::always_inline]] inline StripLane strip_lane(const TipStrip& w, SoftEdge edge, float px,
                                                   float py) noexcept {
  constexpr float kLessAtEdge = 0.45F;  // fraction of the tone that is lost at the edge of the tip
  constexpr auto kBesidePx = static_cast<float>(kRimPx - kSoftPx);
  constexpr auto kMin = static_cast<float>(PressureMap::kMinPush);
  constexpr float kPerPush = PressureMap::kMaxKey / (1.0F - kMin);
  const float along = px * w.dx + py * w.dy;
  const float across = px * w.dy - py * w.dx;
  float at = clamped_lane(along, 0.0F, w.len);
  if constexpr (kTapers) {  // the dab of a point lies towards the wider end
    at = along + w.taper * across * across / (w.r0 + w.taper * at);
    at = clamped_lane(at, 0.0F, w.len);
  }
  const float t = at * w.per_length;
  const float past = along - at;
  const float radius = w.r0 + t * w.dr;
  const float per_r = 1.0F / radius;
  const float rho2 = (across * across + past * past) * per_r * per_r;
  const float rim = rho2 < 1.0F ? rho2 : 1.0F;
  const float in_edge = (rim - edge.from) * edge.per_edge;
  const float at_edge = in_edge > 0.0F ? in_edge : 0.0F;
  const float firm = (w.tone0 + t * w.dtone) * (1.0F - kLessAtEdge * rim);
  const float push = firm + (kMin - firm) * (at_edge * at_edge);
  const float side = across * per_r;
  const float position = clamped_lane(side, -1.0F, 1.0F);
  const auto key = static_cast<std::int32_t>((push - kMin) * kPerPush);
  const auto rim_key = static_cast<std::int32_t>(rim * PressureMap::kMaxRim);
  const auto across_key =
      static_cast<std::int32_t>((position + 1.0F) * (0.5F * PressureMap::kMaxAcross));
  const float reach = radius + kBesidePx;
  const float reach2 = kTapers ? w.widest2 : reach * reach;
  const float beside2 = across * across + past * past;
  const std::int32_t is_in = static_cast<std::int32_t>(along >= w.low) &
                             static_cast<std::int32_t>(along <= w.high) &
                             static_cast<std::int32_t>(beside2 <= reach2);
  return {(key << PressureMap::kPushShift) | (rim_key << PressureMap::kRimShift) | across_key,
          is_in, t, radius, beside2};
}

}  // namespace felt
