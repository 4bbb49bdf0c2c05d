#pragma once

#include <cstdint>

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

/// Paints a solid as matt bodies in the light of a lamp at the upper left of the camera, on white.
/// Every body has its shown_color(), with the ink of `paint` on its front unless that is null.
/// Parallel projection; the picture is filled. Works in software, with a depth buffer at twice the
/// resolution. Fails if the size is out of range or there is no body.
Result<Image> paint_solid(const Solid& solid, const SolidView& view,
                          const FrontPaint* paint = nullptr);

}  // namespace felt
