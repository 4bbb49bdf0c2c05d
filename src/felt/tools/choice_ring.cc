#include "felt/tools/choice_ring.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/tools/feel_id.h"

namespace felt {
namespace {

constexpr double kWellRad = kTau / static_cast<double>(ChoiceRing::kWells);
/// Reach of a well, as a share of the radius. Half of the distance to the next well is sin(pi/8) =
/// 0.383 of the radius.
constexpr double kWellReach = 0.38;

}  // namespace

void ChoiceRing::move(Point pen) noexcept {
  const Vec out = pen - middle_;
  const double radius_squared = norm_squared(up_);
  if (!(norm_squared(out) >= kMiddle * kMiddle * radius_squared)) {  // also for NaN
    chosen_.reset();
    return;
  }
  const double turn = std::atan2(dot(out, right_), dot(out, up_)) / kWellRad;
  if (chosen_) {
    const double off = std::remainder(turn - static_cast<double>(*chosen_), double{kWells});
    if (std::fabs(off) <= 0.5 + kHysteresisRad / kWellRad) return;
  }
  const double nearest = std::round(turn < 0.0 ? turn + double{kWells} : turn);
  chosen_ = static_cast<std::size_t>(nearest) % kWells;
}

Point ChoiceRing::well(std::size_t i) const noexcept {
  const double angle = kWellRad * static_cast<double>(i);
  return middle_ + std::cos(angle) * up_ + std::sin(angle) * right_;
}

GuideLaw ring_law(double radius_mm) noexcept {
  const double share = std::clamp(radius_mm / kRingMm, 0.0, 1.0);
  return {.well = {.radius_mm = kWellReach * radius_mm,
                   .core_mm = 2.0 * share,
                   .rim_mm = 2.0 * share,
                   .force_n = 0.5 * share,
                   .damping_n_s_per_m = 1.0},
          .rise_s = 0.06};
}

Guide ring_guide(const ChoiceRing& ring) noexcept {
  GuidePiece piece;
  if (const auto well = ring.chosen()) {
    piece.count = 1;
    piece.points[0] = ring.well(*well);
    piece.hold = static_cast<std::uint32_t>(*well) + 1;
  }
  return {ring_law(ring.radius_mm()), piece};
}

ForceModel ring_force(const ChoiceRing& ring, const SurfaceMaterial& surface,
                      const Capabilities& device) noexcept {
  ForceModel model(Compose(Plane(plane_for(surface, device)), ring_guide(ring)));
  FeelId id("ring");
  id.with(surface.id).with(surface.stiffness_n_per_m).with(surface.damping_n_s_per_m);
  id.with(ring.middle().x).with(ring.middle().y);
  if (const auto well = ring.chosen()) id.with(std::uint64_t{*well});
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
