#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/scene.h"

namespace felt {

/// The notch at an end or a crossing: 0.2 N, five times the smallest force that is perceived
/// (docs/design/simulation.md#measures), and small enough that the pen slides out of it with a part
/// of the force that leaves the groove (chosen). Its stiffness is 125 N/m: beside the groove and
/// without friction, a pen that nobody holds is not calm in a stiffer one on the device with the
/// most delay (docs/stability.md).
inline constexpr WellShape kReadNotch{
    .radius_mm = 2.5, .core_mm = 1.6, .rim_mm = 0.8, .force_n = 0.2, .damping_n_s_per_m = 0.5};

/// Returns the notch with its forces multiplied by `strength`.
inline WellShape read_notch(double strength) noexcept {
  WellShape shape = kReadNotch;
  shape.force_n *= strength;
  shape.damping_n_s_per_m *= strength;
  return shape;
}

/// Share of the groove's force (GuideLaw::groove): 0.56 N and 210 N/m, so that groove and notch
/// together stay below the 1 N of an editing tool (docs/design/forces.md#guides).
inline constexpr double kReadGrooveShare = 0.7;

/// Returns the forces: the hardness of the surface, the groove of a line, and the notch at an end
/// or a crossing; null if there is none. There is neither friction nor grain, so that only lines
/// are felt.
inline ForceModel read_feel(const SurfaceMaterial& surface, const Capabilities& device,
                            double strength, const Guide* groove, const Point* notch) {
  const Plane plane(plane_for(surface, device));
  const SnapWells well = notch ? SnapWells(*notch, read_notch(strength)) : SnapWells();
  return groove ? ForceModel(Compose(plane, *groove, well)) : ForceModel(Compose(plane, well));
}

/// Returns the force model of the tool: read_feel() of the line that the pen follows, and of the
/// mark that is near.
inline ForceModel make_read_force(double strength, const Scene& scene, const GuideTrack* groove,
                                  const Point* notch) {
  FeelId id("read");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(strength);
  if (groove) id.with("groove").with(std::uint64_t{groove->number()});
  if (notch) id.with(notch->x).with(notch->y);
  ForceModel model =
      read_feel(scene.surface, scene.device, strength, groove ? &groove->guide() : nullptr, notch);
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
