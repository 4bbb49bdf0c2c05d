#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke that travelled in the attributes of a path, and what became of it on the way.
struct SvgWideStroke {
  StrokeData data;
  std::string id;  ///< ours; empty where it has none
  std::vector<std::string> notices;
};

/// Reads it: ours exactly, as long as no other program changed the path; a PowerStroke of Inkscape
/// by its knots. `to_mm` moves it; one that does not keep shapes alike scales widths by the mean.
/// Error: the attributes say nothing that makes a stroke, and the outline has to do.
Result<SvgWideStroke> svg_wide_stroke(const SvgVariableWidth& attributes, const Affine& to_mm);

/// Whether a transform keeps shapes: it turns, mirrors, moves, and scales all directions alike.
bool svg_is_similarity(const Affine& m) noexcept;

}  // namespace felt
