#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/bricks/yielding_spring.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/pull/pull_gesture.h"
#include "felt/tools/pull/pull_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the force model of the pull tool (paper, eq. 8 and 9; R29, R30): the surface and, while
/// a line is held, the counter-force. The counter-force resists the pen the more the farther it is
/// from the point where it grabbed the line, and yields when the pen rests
/// (docs/design/forces.md#yielding); with `yield_s` 0, and in the form kPaper of the law, it pulls
/// back to that point instead. In the modes push and sweep, which depend on the path of the pen,
/// the counter-force acts between the pen and the current shape of the line instead. The fade_id
/// stays the same during a gesture, so that nothing is cross-faded; only a leap of a swept curve
/// (PullFeel::leaps) changes it.
inline ForceModel make_pull_force(const PullSettings& settings, const Scene& scene,
                                  const PullFeel& feel) {
  const Medium material =
      scaled_medium(medium_of(scene, "pencil"), settings.strength, settings.strength);
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));
  EditOptions edit;
  edit.law.gain = settings.strength;
  edit.law.form = scene.law;
  if (scene.law == LawForm::kPaper) edit.damping_n_s_per_m = 0.0;

  FeelId id("pull");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(settings.strength);
  id.with_law(scene.law);
  ForceModel model;
  switch (feel.kind) {
    case PullFeel::Kind::kNone:
      model = ForceModel(surface);
      break;
    case PullFeel::Kind::kSpring:
      id.with("spring").with(feel.origin.x).with(feel.origin.y);
      if (settings.yield_s > 0.0 && scene.law != LawForm::kPaper) {
        id.with(settings.yield_s);
        model = ForceModel(Compose(surface, YieldingSpring(feel.origin, edit, settings.yield_s)));
      } else {
        model = ForceModel(Compose(surface, EditSpring(feel.origin, edit)));
      }
      break;
    case PullFeel::Kind::kSweep:
      id.with("sweep").with(settings.sweep.time_constant_s).with(std::uint64_t{feel.leaps});
      model = ForceModel(
          Compose(surface, SweepSpring(feel.curve, edit, settings.sweep.time_constant_s)));
      break;
    case PullFeel::Kind::kPush:
      id.with("push");
      model = ForceModel(Compose(surface, PushSpring(feel.line, edit)));
      break;
  }
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
