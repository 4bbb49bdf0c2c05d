#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/selection.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force_law.h"
#include "felt/material/materials.h"

namespace felt {

class Guide;
class StrokeIndex;

/// The guide whose force acts on the pen while it draws.
struct ActiveGuide {
  const Guide* force = nullptr;  ///< near the last sample; null: no guide
  std::uint32_t number = 0;      ///< changes when another guide acts
  /// If true, the pencil's friction is softer, so that it and the guide stay within the stiffness
  /// budget: near a guide of the drawing, and on a retraced line.
  bool softens_friction = false;
};

/// What a tool can read besides the pen samples: the document, the surface under the pen, and the
/// device that renders forces. Does not change while a sample is handled.
struct Scene {
  static constexpr double kUsualInkWidthMm = 1.0;
  /// A tenth of a thin line. With more, the fit may spread the thin end of a line over the whole of
  /// it, so that it looks like a blob at its start (docs/design/loop.md#landing).
  static constexpr double kFeltWidthToleranceMm = 0.05;

  const Document& document;
  const StrokeIndex& index;        ///< index of `document`, up to date
  const Selection& selection;      ///< selection in `document`, up to date
  LayerId layer;                   ///< layer that receives new ink
  const SurfaceMaterial& surface;  ///< the surface that the user draws on
  const Capabilities& device;
  Rgba color{};  ///< colour of new ink
  /// All materials of the session, by id. The first medium is the pencil.
  const Materials& materials = Materials::built_in();
  ActiveGuide guide = {};                  ///< guides the pen while it draws
  std::string_view medium = "pencil";      ///< id of the medium of new ink
  double ink_width_mm = kUsualInkWidthMm;  ///< width of a line that a mouse draws in this medium
  /// The guides of the document, by ascending id; none while guides are hidden.
  std::span<const DrawingGuidePtr> guides = {};
  /// Largest error of the fitted width of a line on a surface that is felt, mm. Recordings of older
  /// versions have another.
  double felt_width_tolerance_mm = kFeltWidthToleranceMm;
  /// If true, lines that were pasted in place can be moved without their originals
  /// (MovedStrokes). False in recordings of older versions.
  bool copies_leave_originals = true;
  /// The form of the forces of edits, of transforms and of the attraction of ends.
  LawForm law = LawForm::kFelt;
  /// False while only the plane of the surface is felt (surface.plane_only).
  bool feels_tools = true;
};

/// Returns the medium with this id, or the pencil if no medium has it.
inline const Medium& medium_of(const Scene& scene, std::string_view id) noexcept {
  const Medium* medium = scene.materials.find_medium(id);
  return medium ? *medium : scene.materials.media().front();
}

/// Returns the medium with its friction (on every surface) and its grain multiplied by these
/// factors. Tools use it to apply their `strength` option. Tools that leave no ink also use it to
/// reduce friction.
inline Medium scaled_medium(Medium medium, double friction, double grain) {
  medium.strength *= friction;
  medium.grain *= grain;
  return medium;
}

}  // namespace felt
