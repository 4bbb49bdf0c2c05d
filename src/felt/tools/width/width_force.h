#pragma once

#include <algorithm>
#include <optional>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/pressing.h"
#include "felt/tools/scene.h"
#include "felt/tools/width/width_options.h"

namespace felt {

/// How near the width under the pen is to each limit of the brush: 0 means far away, 1 means at the
/// limit.
struct WidthStops {
  double harder = 0.0;   ///< the limit reached by pressing harder
  double lighter = 0.0;  ///< the limit reached by pressing less
};

/// The spring and damper that resist the pressure when the width has reached a limit (paper,
/// "Change curve width"; docs/design/errata.md#e20). Their force is added to that of the plane of
/// the surface. With d the depth, and d0 the depth at which the width does not change:
///
///   F = K max(harder d, lighter min(d, d0)) - B vz,   |B vz| at most the spring
///
/// So at the broadest width the surface is stiffer: by a quarter on paper on the softest devices,
/// which can be felt (a difference of 8 to 13 %, docs/design/forces.md#width-stop). At the thinnest
/// width, the user needs more force to press down to the depth d0, beyond which the width grows
/// again: a detent. The force is zero at the surface, never pulls inwards, and is continuous. The
/// force of both springs depends only on the depth, so they are passive. WidthStop must come after
/// the plane in the chain, because it reads the normal speed that the plane computes. K is the part
/// of the device's stiffness that the plane does not use (see width_stop_stiffness).
class WidthStop {
 public:
  WidthStop(const WidthStops& stops, double neutral_mm, double stiffness_n_per_m) noexcept
      : stops_(stops), neutral_mm_(neutral_mm), stiffness_(stiffness_n_per_m) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const double depth = depth_mm(sample);
    const double stretch =
        std::max(stops_.harder * depth, stops_.lighter * std::min(depth, neutral_mm_));
    const double spring = 1e-3 * stiffness_ * memory.scale.normal * stretch;
    const double speed = memory.normal_speed_mm_per_s;
    const double damper = std::clamp(-1e-3 * kDampingNSPerM * speed, -spring, spring);
    const Force force{0.0, 0.0, spring + damper};
    memory.terms.add("stop", force);
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept {
    return {.normal_n_per_m = stiffness_ * std::max(stops_.harder, stops_.lighter)};
  }

 private:
  static constexpr double kDampingNSPerM = 0.5;

  WidthStops stops_;
  double neutral_mm_;
  double stiffness_;
};

/// Returns the stiffness that is left for a stop in addition to the plane of a surface, N/m: the
/// minimum of the stiffness budget (R56), 0.9 of the device's maximum stiffness (R55) and the limit
/// from its sensor resolution, minus the stiffness of the plane; at most 400. Returns 0 if the
/// plane uses all of this; then the user feels a stop only as higher friction.
inline double width_stop_stiffness(const SurfaceMaterial& surface, const Capabilities& device) {
  constexpr double kMax = 400.0, kMaxPerStepN = 0.025;
  double room = stiffness_budget_n_per_m(device);
  if (device.max_stiffness_n_per_m > 0.0) {
    room = std::min(room, 0.9 * device.max_stiffness_n_per_m);
  }
  if (device.position_step_mm > 0.0) {
    room = std::min(room, 1e3 * kMaxPerStepN / device.position_step_mm);
  }
  return std::clamp(room - plane_for(surface, device).stiffness_n_per_m, 0.0, kMax);
}

/// Pulls the pen back to the y at which it began to scale a line: EditSpring along y only.
class HeightSpring {
 public:
  HeightSpring(double origin_y_mm, double share) noexcept : origin_y_mm_(origin_y_mm) {
    options_.law.gain = share;
    options_.damping_n_s_per_m *= share;
  }

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const Force force =
        pull_back(options_.law, {0.0, sample.position.y - origin_y_mm_}, options_.damping_n_s_per_m,
                  {0.0, known_velocity(sample).y}, memory.scale.lateral);
    memory.terms.add("edit", force);
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept {
    return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
  }

 private:
  double origin_y_mm_;
  EditOptions options_;
};

/// The state of the width tool that its force model depends on.
struct WidthFeel {
  WidthStops stops;  ///< how near the width is to the limits of the brush
  WidthDirection direction = WidthDirection::kPressure;
  std::optional<double> origin_y_mm;  ///< set while a line is scaled
};

/// Returns the force model of the width tool: the surface, more friction near a stop, the stop
/// itself and, while a line is scaled, the pull back to the point where the scaling began. The
/// stops change smoothly and do not change the fade_id.
inline ForceModel make_width_force(const WidthSettings& settings, const Scene& scene,
                                   const WidthFeel& feel) {
  const double near = std::max(feel.stops.harder, feel.stops.lighter);
  const Medium material = scaled_medium(medium_of(scene, "pencil"),
                                        settings.strength * (1.0 + near), settings.strength);
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));

  FeelId id("width");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(settings.strength);
  ForceModel model;
  if (feel.origin_y_mm) {
    id.with("scale").with(*feel.origin_y_mm);
    model = ForceModel(Compose(surface, HeightSpring(*feel.origin_y_mm, settings.strength)));
  } else {
    // The force at which the width does not change: that of half pressure, or the minimum force if
    // the direction is fixed.
    const Pressing pressing(scene.surface, scene.device);
    const bool by_pressure = feel.direction == WidthDirection::kPressure;
    const double neutral_n =
        Pressing::kMinN + (by_pressure ? 0.5 * (pressing.max_n() - Pressing::kMinN) : 0.0);
    const double neutral_mm = 1e3 * neutral_n / std::max(pressing.stiffness_n_per_m(), 1.0);
    const double stiffness = settings.strength * width_stop_stiffness(scene.surface, scene.device);
    model = ForceModel(Compose(surface, WidthStop(feel.stops, neutral_mm, stiffness)));
  }
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
