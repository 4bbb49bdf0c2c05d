#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke that was stored in the attributes of a path, with notices of changes to it.
struct SvgWideStroke {
  StrokeData data;
  std::string id;  ///< the id that Feltline gave it; empty if it has none
  std::vector<std::string> notices;
};

/// Reads the stroke. If Feltline wrote it and no other program changed the path, it is exact. A
/// PowerStroke of Inkscape is built from its knots. `to_mm` transforms it; if that is not a
/// similarity, widths are scaled by sqrt(|determinant|). Fails if the attributes do not make a
/// stroke; the caller then uses the outline.
Result<SvgWideStroke> svg_wide_stroke(const SvgVariableWidth& attributes, const Affine& to_mm);

/// Returns true if a transform is a similarity: it rotates, mirrors, moves, and scales all
/// directions equally.
bool svg_is_similarity(const Affine& m) noexcept;

}  // namespace felt
