#pragma once

#include <span>
#include <string>

#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the stroke that follows the samples of one pen stroke. To fit while the pen draws, use
/// InkFitter. Fails if no sample has a finite position. Safe to call from any thread.
Result<Stroke> fit_stroke(std::span<const InkSample> samples, const InkFitOptions& options = {});

/// Writes strokes, the first at the bottom, completely or not at all. The ending of `path` decides
/// the format: .felt, .svg, .svgz, .inkml, .xopp, .ndjson, .pdf or .png. Pictures show the ink with
/// a margin of `margin_mm` around it. For layers, colours of the page and other options, use
/// write_drawing(). Fails if the ending is unknown, or the file cannot be written; the message
/// begins with the path.
Result<void> save_strokes(const std::string& path, std::span<const Stroke> strokes,
                          double margin_mm = 10.0);

}  // namespace felt
