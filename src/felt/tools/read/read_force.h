#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/scene.h"

namespace felt {

/// The notch at an end or a crossing: 0.25 N, seven times the smallest force that is perceived
/// (docs/design/simulation.md#measures), and small enough that the pen slides out of it with a part
/// of the force that leaves the groove (chosen).
inline constexpr WellShape kReadNotch{
    .radius_mm = 2.0, .core_mm = 1.0, .rim_mm = 0.8, .force_n = 0.25, .damping_n_s_per_m = 0.5};

/// Returns the notch with its forces multiplied by `strength`.
inline WellShape read_notch(double strength) noexcept {
  WellShape shape = kReadNotch;
  shape.force_n *= strength;
  shape.damping_n_s_per_m *= strength;
  return shape;
}

/// Returns the force model: the hardness of the surface, the groove of the line that the pen
/// follows, and the notch near an end or a crossing. There is neither friction nor grain, so that
/// only lines are felt.
inline ForceModel make_read_force(double strength, const Scene& scene, const GuideTrack* groove,
                                  const Point* notch) {
  const Plane plane(plane_for(scene.surface, scene.device));
  const SnapWells well = notch ? SnapWells(*notch, read_notch(strength)) : SnapWells();
  FeelId id("read");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(strength);
  if (groove) id.with("groove").with(std::uint64_t{groove->number()});
  if (notch) id.with(notch->x).with(notch->y);
  ForceModel model =
      groove ? ForceModel(Compose(plane, groove->guide(), well)) : ForceModel(Compose(plane, well));
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
