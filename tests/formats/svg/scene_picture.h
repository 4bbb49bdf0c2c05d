#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/render/image.h"

namespace felt::testing {

/// What an SVG file paints, kept: the shapes of its scene and what was said about the rest.
struct PaintedScene {
  SvgRoot root;
  Rgba paper{0, 0, 0, 0};
  std::vector<SvgShape> shapes;  ///< their views are not valid any more
  std::vector<std::string> notices;
};

Result<PaintedScene> paint_scene(std::string_view svg);

/// The picture of a scene by AGG's own stroker, which shares nothing with our ink: fillings by
/// their rule, lines with their caps, joins and dashes. Its width is that of the page; transparent
/// where nothing is painted.
Result<Image> scene_picture(const PaintedScene& scene, int width_px, int height_px);

/// How many pixels of a picture have no like in the other one within a pixel of them: beyond
/// `tolerance` of 255 outside of what the nine pixels around that place span, in any channel.
/// Both pictures are looked at from the other. The tolerance allows for edges that were sampled in
/// quarters of a pixel, as the suite's are: half a quarter is 32.
std::int64_t pixels_apart(const Image& a, const Image& b, int tolerance = 40);

}  // namespace felt::testing
