#pragma once

#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/geometry/vec3.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/solid/solid.h"

namespace felt {

/// The ink that is painted on the fronts of bodies, as a decal that is projected along z.
struct FrontPaint {
  static constexpr double kMaxPxPerMm = 12.0;
  static constexpr int kMaxPx = 2048;  ///< of the longer side

  Image ink;      ///< transparent where there is no ink; premultiplied
  Vec corner_mm;  ///< x and y of the solid at the top left corner of the picture
  double px_per_mm = 1.0;

  /// Returns the position on the picture of a point of the solid, in pixels from its top left
  /// corner.
  [[nodiscard]] Vec to_px(const Vec3& p) const noexcept {
    return {px_per_mm * (p.x - corner_mm.x), px_per_mm * (corner_mm.y - p.y)};
  }
};

/// Draws the visible strokes and fills of a document for the fronts of its bodies. A stroke that
/// follows an outline for more than half of its length is left out: it has become the body. `solid`
/// must be that of this document, before its edits (body_edits.h). Returns nullopt if no ink is
/// left on the bodies: ink beside them and in their holes does not count. The same drawing gives
/// the same picture. Fails if the memory limit of Image does not allow a layer.
Result<std::optional<FrontPaint>> front_paint(const Document& document, const Solid& solid,
                                              const Grain& grain);

/// Returns true if a triangle of a body belongs to its front: it lies before the page and faces the
/// viewer. The faces of a cut along z do not.
bool is_front(const SolidBody& body, const SolidBody::Triangle& triangle) noexcept;

/// Returns the colour that a body is shown with: that of its stroke, but dark colours are made
/// lighter, because a black body shows no shape and no ink.
Rgba shown_color(Rgba color) noexcept;

/// Returns the colour that each point of a body is shown with: its shown_color() under the paint of
/// the point (SolidBody::paint). Opaque.
std::vector<Rgba> point_colors(const SolidBody& body);

/// A triangle belongs to the front if the z of its normal is larger than this.
inline constexpr double kMinFrontNormal = 1e-3;

/// Returns the picture of the front of one body: its shown colour with the ink on it, opaque. Its
/// corner is that of the body's bounds. Returns nullopt if there is no ink within these bounds.
/// Fails if the memory limit of Image does not allow it.
Result<std::optional<FrontPaint>> painted_front(const SolidBody& body, const FrontPaint& paint);

}  // namespace felt
