#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/render/image.h"

namespace felt::testing {

/// A stored copy of the scene of an SVG file: its shapes, and the notices about unsupported
/// content.
struct PaintedScene {
  SvgRoot root;
  Rgba paper{0, 0, 0, 0};
  std::vector<SvgShape> shapes;  ///< their string views are no longer valid
  std::vector<std::string> notices;
};

Result<PaintedScene> paint_scene(std::string_view svg);

/// Draws a scene with the stroker of AGG, which shares no code with our ink: fills with their fill
/// rule, lines with their caps, joins and dashes. The page fills the width of the picture. Pixels
/// without paint are transparent.
Result<Image> scene_picture(const PaintedScene& scene, int width_px, int height_px);

/// Returns the number of pixels, counted in both pictures, that differ from the other picture. A
/// pixel differs if a channel is more than `tolerance` (of 255) outside the range of the nine
/// pixels around the same position in the other picture. Returns -1 if the sizes differ. The
/// default tolerance allows for edges sampled in quarters of a pixel, as in the suite: half a
/// quarter of 255 is 32.
std::int64_t pixels_apart(const Image& a, const Image& b, int tolerance = 40);

}  // namespace felt::testing
