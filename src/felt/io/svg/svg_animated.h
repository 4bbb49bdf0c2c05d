#pragma once

#include <span>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/geometry/rect.h"

namespace felt {

/// One picture of an animated SVG: a drawing, and for how many frames it is shown.
struct AnimatedPicture {
  Drawing drawing;
  int frames = 1;  ///< > 0
};

/// Options of an animated SVG.
struct AnimatedSvgOptions {
  Rect area;                        ///< that the pictures show, in mm
  Rgba paper{255, 255, 255, 0};     ///< not drawn if alpha is 0
  double frames_per_second = 24.0;  ///< > 0
};

/// Returns drawings as one SVG that plays them over and over, without scripts: each picture is a
/// group with outlines as in svg_compact_text(), and SMIL (SVG 2, `animate` with discrete values of
/// `visibility`) shows the groups in turn. A viewer that does not play SMIL shows the first
/// picture. The file is a film: reading it gives the first picture only. Fails if there is no
/// picture or a coordinate is beyond 1e9 mm.
Result<std::string> svg_animated_text(std::span<const AnimatedPicture> pictures,
                                      const AnimatedSvgOptions& options);

}  // namespace felt
