#pragma once

#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/height_field.h"

namespace felt {

/// A relief as somebody's own picture has it: white is high.
struct HeightPicture {
  int width = 0;
  int height = 0;
  std::vector<float> heights;  ///< 0 (black) .. 1 (white), row by row
  double width_mm = 0.0;       ///< where the file says; 0 is not known
};

/// How large it is on the sheet, and how high.
struct HeightPictureSpec {
  double tile_mm = 40.0;    ///< side of the square that the picture fills and that repeats, 5..500
  double height_um = 60.0;  ///< from black to white, 0..1000
};

/// The height field of a picture. It is fitted into the square tile (what is not square is
/// stretched), and where its edges do not meet, each fades into the picture moved by half, so that
/// it repeats without a seam; what is shorter than tile_mm / 40 is taken away. A hand is given as
/// much of it as keeps to the stiffness that a loop bears (Texture), however high it is said to be.
///
/// Error: sizes outside of the above, not as many heights as width x height, one that is not
/// finite, or a picture of one grey.
Result<HeightField> height_field_of(const HeightPicture& picture,
                                    const HeightPictureSpec& spec = {});

}  // namespace felt
