#include "felt/stroke/width_profile.h"

#include <algorithm>

namespace felt {
namespace {

bool follows_width(const WidthKnot& knot) noexcept {
  return knot.tone == tone_of_width(knot.width_mm);
}

/// Returns true if tone_of_width() is linear at this tone, that is, not clamped.
bool is_tone(double tone) noexcept {
  return tone > 0.0 && tone < 1.0;
}

/// Two neighbouring knots, and a position between them, 0..1. Beyond an end of the profile, both
/// are the knot at that end.
struct Between {
  const WidthKnot &a, &b;
  double share;

  [[nodiscard]] double of(double x, double y) const noexcept {
    return share > 0.0 ? (1.0 - share) * x + share * y : x;
  }
  // Rounding must not give a width below the smallest one (I4).
  [[nodiscard]] double width_mm() const noexcept {
    return std::max(of(a.width_mm, b.width_mm), std::min({a.width_mm, b.width_mm, kMinWidthMm}));
  }
  // Rounding must not give a tone above 1 (I7).
  [[nodiscard]] double tone() const noexcept { return std::min(of(a.tone, b.tone), 1.0); }
};

/// Returns the position of u between the knots. Requires a profile that is not empty.
Between place(std::span<const WidthKnot> profile, double u) noexcept {
  const WidthKnot &front = profile.front(), &back = profile.back();
  if (!(u > front.u)) return {front, front, 0.0};
  if (u >= back.u) return {back, back, 0.0};
  const auto after = std::upper_bound(profile.begin(), profile.end(), u,
                                      [](double x, const WidthKnot& knot) { return x < knot.u; });
  const WidthKnot &a = *(after - 1), &b = *after;
  return {a, b, (u - a.u) / (b.u - a.u)};
}

}  // namespace

double width_at(std::span<const WidthKnot> profile, double u) noexcept {
  if (profile.empty()) return 0.0;
  return place(profile, u).width_mm();
}

double tone_at(std::span<const WidthKnot> profile, double u) noexcept {
  return profile.empty() ? 0.0 : place(profile, u).tone();
}

WidthKnot knot_at(std::span<const WidthKnot> profile, double u) noexcept {
  if (profile.empty()) return {u, 0.0, 0.0};
  const Between at = place(profile, u);
  const double width_mm = at.width_mm();
  const bool follows =
      is_tone(at.a.tone) && is_tone(at.b.tone) && follows_width(at.a) && follows_width(at.b);
  return {u, width_mm, follows ? tone_of_width(width_mm) : at.tone()};
}

bool has_own_tone(std::span<const WidthKnot> profile) noexcept {
  return !std::all_of(profile.begin(), profile.end(), follows_width);
}

void take_tone_of_width(std::span<WidthKnot> profile) noexcept {
  for (WidthKnot& knot : profile) knot.tone = tone_of_width(knot.width_mm);
}

}  // namespace felt
