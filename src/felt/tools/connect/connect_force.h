#pragma once

#include <optional>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/connect/connect_options.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"

namespace felt {

/// The points at which forces act in addition to the force of the surface.
struct ConnectFeel {
  std::optional<Point> well;          ///< attracts the pen
  std::optional<Point> dragged_from;  ///< position of the pen when it grabbed an end
};

/// Fraction of the edit force law (docs/design/forces.md#edit-law) with which a dragged end
/// resists: at most 0.2 N.
inline constexpr double kDragShare = 0.2;

/// Returns the force model of the connect tool: the surface under a pencil, the attraction of an
/// end and, while an end is dragged, a weak spring back to the point of the grab (R43). Attraction
/// and spring together are at most 1 N.
inline ForceModel make_connect_force(const ConnectSettings& settings, const Scene& scene,
                                     const ConnectFeel& feel) {
  const Medium material =
      scaled_medium(medium_of(scene, "pencil"), settings.strength, settings.strength);
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));
  WellShape shape = well_of(settings.snap, settings.strength);
  if (scene.law == LawForm::kPaper) shape = shape.printed(settings.strength);
  const SnapWells well = feel.well ? SnapWells(*feel.well, shape) : SnapWells();

  FeelId id("connect");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(settings.strength);
  id.with_law(scene.law);
  if (feel.well) {
    id.with("well").with(feel.well->x).with(feel.well->y).with(shape.radius_mm).with(shape.force_n);
  }
  ForceModel model;
  if (feel.dragged_from) {
    id.with("drag").with(feel.dragged_from->x).with(feel.dragged_from->y);
    EditOptions drag;
    drag.law.gain = kDragShare * settings.strength;
    model = ForceModel(Compose(surface, well, EditSpring(*feel.dragged_from, drag)));
  } else {
    model = ForceModel(Compose(surface, well));
  }
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
