#pragma once

#include "felt/material/materials.h"

/// A user-defined surface for tests.
namespace felt::desktop {

inline SurfaceMaterial slate(double friction) {
  SurfaceMaterial surface = *find_surface("blackboard");
  surface.id = "slate";
  surface.label = "Slate";
  surface.friction = friction;
  return surface;
}

}  // namespace felt::desktop
