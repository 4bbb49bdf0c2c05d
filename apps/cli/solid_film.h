#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/solid.h"

namespace felt::cli {

/// Writes a film, .webm or .gif, in which a solid turns once about its vertical axis, in 3 s.
/// `paint` is the ink on the bodies, or null. Needs ffmpeg: fails with kUnsupported without it,
/// else like FilmWriter. An interrupt (Ctrl-C) cancels it.
Result<void> write_turning_film(const Solid& solid, const FrontPaint* paint,
                                const std::string& path);

}  // namespace felt::cli
