#pragma once

#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/height_field.h"

namespace felt {

/// A custom relief as a picture: white is high.
struct HeightPicture {
  int width = 0;
  int height = 0;
  std::vector<float> heights;  ///< 0 (black) .. 1 (white), row by row
  double width_mm = 0.0;       ///< from the file; 0 if unknown
};

/// The size of the relief on the page, and its height.
struct HeightPictureSpec {
  double tile_mm = 40.0;    ///< side of the square tile that the picture fills, 5..500
  double height_um = 60.0;  ///< from black to white, 0..1000
};

/// Returns the height field of a picture. The picture is stretched to the square tile. If opposite
/// edges do not match, the picture is blended with a copy shifted by half its size, so that it
/// repeats without a seam. Waves shorter than tile_mm / 40 are removed. However high the relief is,
/// Texture limits the stiffness of its force to what the haptic loop can render.
///
/// Fails if a size is out of range, the number of heights is not width x height, a height is not
/// finite, or the resulting relief is flat (for example, if the picture is one uniform grey).
Result<HeightField> height_field_of(const HeightPicture& picture,
                                    const HeightPictureSpec& spec = {});

}  // namespace felt
