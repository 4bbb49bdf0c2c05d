#pragma once

#include <string_view>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/haptics/capabilities.h"
#include "felt/material/materials.h"

namespace felt {

class StrokeIndex;

/// What a tool sees besides the pen: the document, the sheet under the hand, the device that will
/// push back. Constant while a sample is handled.
struct Scene {
  const Document& document;
  const StrokeIndex& index;        ///< of this document, up to date
  const Selection& selection;      ///< of this document, up to date
  LayerId layer;                   ///< where new ink goes
  const SurfaceMaterial& surface;  ///< the sheet
  const Capabilities& device;
  Rgba color{};  ///< of new ink
  /// What the session knows besides: media by their ids. The first one is the pencil.
  const Materials& materials = Materials::built_in();
};

/// The medium of that id, or the pencil.
inline const Medium& medium_of(const Scene& scene, std::string_view id) noexcept {
  const Medium* medium = scene.materials.find_medium(id);
  return medium ? *medium : scene.materials.media().front();
}

/// A medium that drags so many times as much, on every sheet, and shows so much more of the grain
/// to the hand: a tool's strength, and how it glides.
inline Medium felt_with(Medium medium, double friction, double grain) {
  medium.friction *= friction;
  medium.grain *= grain;
  for (PairFriction& pair : medium.pairs) pair.coefficient *= friction;
  return medium;
}

}  // namespace felt
