#pragma once

#include <QString>
#include <vector>

#include "desktop/files/timelapse_file.h"
#include "felt/motion/key_film.h"

namespace felt::desktop {

/// How a film of key drawings is written.
enum class AnimationFormat {
  kAnimatedSvg,  ///< one .svg that plays by itself
  kSvgFiles,     ///< a numbered .svg for each picture
  kPngFiles,     ///< a numbered .png for each picture
};

/// A film of key drawings that the user asks for.
struct AnimationRequest {
  std::vector<FilmKey> keys;  ///< with the same page, which the film shows
  AnimationFormat format = AnimationFormat::kAnimatedSvg;
  int longer_px = 1280;  ///< the longer side of a .png
};

/// Writes the film, as `feltline inbetween --keys` does: an animated .svg at 24 frames a second, or
/// each picture once, "swim-001.png" and so on for the path "swim.png". Fails without writing
/// anything if a numbered file exists. After an error, or if the work is cancelled, no new file
/// stays. Safe to call from any thread.
Result<void> make_animation(const QString& path, const AnimationRequest& request,
                            TimelapseProgress& progress);

}  // namespace felt::desktop
