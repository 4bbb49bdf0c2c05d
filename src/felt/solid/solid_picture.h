#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/solid.h"

namespace felt {

/// What fits the picture.
enum class SolidFit : std::uint8_t {
  kView,  ///< the solid as it is seen
  kTurn,  ///< the solid in every turn about the vertical axis: for films, in which it keeps its
          ///< size
};

/// How a picture of a solid is made.
struct SolidView {
  int width_px = 1200;     ///< of the picture; 16 to 8192
  int height_px = 900;     ///< of the picture; 16 to 8192
  double turn_deg = 25.0;  ///< how far the camera stands to the right of the drawing's front
  double rise_deg = 20.0;  ///< how far it stands above
  SolidFit fit = SolidFit::kView;
};

/// Whether the edges of the triangles are painted.
enum class WireframeChoice : std::uint8_t { kHide, kShow };

/// What is painted besides the bodies.
struct SolidLook {
  Rgba paper{255, 255, 255, 255};  ///< the background; opaque
  WireframeChoice wireframe = WireframeChoice::kHide;
  /// If set, everything with a larger x is cut away, and the cut is painted in kCutColor.
  std::optional<double> section_x_mm;
  const FrontPaint* paint = nullptr;  ///< the ink on the fronts, or null
};

/// A colour, 0..1 in each part.
using SolidShade = std::array<double, 3>;

/// The colour of a section, mixed with that of the body.
inline constexpr SolidShade kCutColor{0.86, 0.47, 0.33};

/// A camera with parallel projection: its axes in the frame of the solid, and where they are in
/// the picture. Pixels count from the upper left corner of the picture.
struct SolidCamera {
  Vec3 right{1.0, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 towards{0.0, 0.0, 1.0};  ///< from the solid to the camera
  double px_per_mm = 1.0;
  Point origin_px;  ///< position of the solid's origin in the picture

  /// Returns a position in the picture, in pixels; z is the distance towards the camera in mm.
  [[nodiscard]] Vec3 to_px(const Vec3& p) const {
    return {origin_px.x + px_per_mm * dot(right, p), origin_px.y - px_per_mm * dot(up, p),
            dot(towards, p)};
  }
};

/// Returns a camera with the directions of the view, 1 pixel per mm, and the origin at (0, 0).
SolidCamera solid_camera(double turn_deg, double rise_deg) noexcept;

/// Paints a solid as matt bodies in the light of a lamp at the upper left of the camera, on white.
/// Every body has its shown_color(), with the ink of `paint` on its front unless that is null.
/// Parallel projection; the picture is filled. Works in software, with a depth buffer and nine
/// samples for each pixel. Fails if the size is out of range or `solid` is empty.
Result<Image> paint_solid(const Solid& solid, const SolidView& view,
                          const FrontPaint* paint = nullptr);

/// Paints a solid as paint_solid() does, seen by this camera. Fails if the size is out of range.
Result<Image> paint_solid(const Solid& solid, const SolidCamera& camera, const SolidLook& look,
                          int width_px, int height_px);

}  // namespace felt
