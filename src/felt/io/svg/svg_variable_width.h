#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke that was stored in the attributes of a path, with notices about changes that the reader
/// made to it.
struct SvgWideStroke {
  StrokeData data;
  std::vector<std::string> notices;
};

/// Reads the stroke from the attributes. If Feltline wrote them and no other program changed the
/// path, the stroke is exactly the one that was written. A PowerStroke of Inkscape is converted to
/// a stroke with the same widths at the knots of the PowerStroke. `to_mm` transforms the stroke to
/// the page; if it is not a similarity, the widths are scaled by sqrt(|determinant|). Fails if the
/// attributes do not describe a valid stroke; the caller then uses the outline.
Result<SvgWideStroke> svg_wide_stroke(const SvgVariableWidth& attributes, const Affine& to_mm);

/// Returns true if a transform is a similarity: it rotates, mirrors, moves, and scales all
/// directions equally.
bool svg_is_similarity(const Affine& m) noexcept;

}  // namespace felt
