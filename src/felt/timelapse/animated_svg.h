#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/timelapse/film_timing.h"
#include "felt/timelapse/timelapse.h"

namespace felt {

/// What an animated SVG shows besides the ink.
struct TimelapseSvgOptions {
  Rect area;                       ///< the part of the page; not empty
  Rgba paper{255, 255, 255, 255};  ///< alpha 0: no paper
  int width_px = 1280;             ///< the size at which it is shown
  int height_px = 720;
};

/// Plays a recording and returns its film as an SVG file with animations of SMIL (SVG 1.1,
/// https://www.w3.org/TR/SVG11/animate.html). A stroke appears along its path, in the time that the
/// pen needed for it; a stroke that an edit changes is replaced when the edit is complete. The film
/// plays once. Programs that do not play animations show the drawing at the end.
///
/// The file contains each shape that a stroke or fill ever had, as an outline within 0.03 mm of the
/// exact one. Opacities, blend modes and the order of layers are those at the end; the grain of
/// media and pictures of layers are left out. Fails like survey_recording(), and if ink is beyond
/// 1e9 mm.
Result<std::string> animated_svg(const TimelapseSource& source, const FilmTiming& timing,
                                 const TimelapseSvgOptions& options);

}  // namespace felt
